package wbv.rig;

import java.util.List;
import wbv.rig.platform.PlatformCommand;

/**
 * What happened to the sitter, row by row, and how seat and head really jerked: the truth for whoever recognises states.
 * The jerk of a row is the rise of the true vertical acceleration over the row's interval, which is what a boxcar's sensor
 * can know of it.
 */
final class Happenings {

    /** In the order of {@link #take}: {@code episode} 0 idle, 1 riding, 2 rocking; {@code jolt} 0 or 1; jerks [m/s³]. */
    static final List<String> NAMES = List.of("episode", "jolt", "seat_jerk_m_per_s3", "head_jerk_m_per_s3");

    private final Plant plant;
    private final int seat;
    private final int head;
    private final double rate;
    private double seatBefore;
    private double headBefore;
    private final double[] row = new double[NAMES.size()];

    /**
     * @param places of the sitter
     * @param rate of the rows [Hz]
     */
    Happenings(Plant plant, List<String> places, double rate) {
        this.plant = plant;
        this.seat = places.indexOf("seat");
        this.head = places.indexOf("head");
        this.rate = rate;
    }

    /** Takes the row that ends now. */
    void take(PlatformCommand drive) {
        double seatNow = plant.motion(seat).acceleration[2];
        double headNow = plant.motion(head).acceleration[2];
        row[0] = drive.episode().ordinal();
        row[1] = drive.jolting() ? 1 : 0;
        row[2] = (seatNow - seatBefore) * rate;
        row[3] = (headNow - headBefore) * rate;
        seatBefore = seatNow;
        headBefore = headNow;
    }

    void copy(double[] into) {
        System.arraycopy(row, 0, into, 0, row.length);
    }
}
