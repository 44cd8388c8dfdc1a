package wbv.state;

import java.io.Serializable;
import java.util.Arrays;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Features of motion, sample by sample: how seat and head jerk, and three levels that tell what is being done to the sitter.
 *
 * <p>Jerk is a {@link Slope}, which is true within a fiftieth to 8 Hz at 60 Hz: a smoother one would take from the jerk of strong
 * vibration what decides on which side of a threshold it is. It comes out {@link FeatureSpec#delay} samples late.
 *
 * <p>Vibration at 5 Hz and more jerks as strongly as jolts do, but does not carry the seat along: the <em>surge</em> is the
 * greatest {@link Surge} of the seat in the last half second. Vibration
 * that turns to and fro at 3 to 4 Hz is as fast as rocking: <em>sway</em> is the root mean square over half a second of roll and
 * pitch rate below 1.5 Hz. <em>Shaking</em> is the root mean square of both jerks over the last quarter of a second. All three
 * know the past alone; they are logarithms that are flat where they say no more: how strong a ride is makes it neither jolt nor
 * rocking, and how strong a jolt's vibration is makes it no other jolt. So what is learned at one level holds at others.
 */
public final class FeatureStream implements Serializable, Snapshot {

    private static final long serialVersionUID = 3;

    private static final double SHAKING_WINDOW = 0.25;
    private static final double SURGE_WINDOW = 0.45;
    /** Two means one after the other, whose first zeros lie at 3.3 and 4 Hz. */
    private static final double[] SLOW = {0.3, 0.25};
    private static final double SWAY_WINDOW = 0.5;

    private final double rate;
    private final Slope seat;
    private final Slope head;
    private final Surge surge;
    private final MovingMean shaking;
    private final Greatest surges;
    private final MovingMean[][] slow = new MovingMean[2][SLOW.length];
    private final MovingMean sway;

    /** A stream before its first sample. */
    public FeatureStream(FeatureSpec spec) {
        rate = spec.rate();
        seat = new Slope(rate);
        head = new Slope(rate);
        surge = new Surge(rate);
        shaking = new MovingMean(samples(SHAKING_WINDOW));
        surges = new Greatest(samples(SURGE_WINDOW));
        for (MovingMean[] axis : slow) {
            Arrays.setAll(axis, i -> new MovingMean(samples(SLOW[i])));
        }
        sway = new MovingMean(samples(SWAY_WINDOW));
    }

    /** Forgets all samples. */
    public void reset() {
        seat.clear();
        head.clear();
        surge.clear();
        shaking.clear();
        surges.clear();
        for (MovingMean[] axis : slow) {
            Arrays.stream(axis).forEach(MovingMean::clear);
        }
        sway.clear();
    }

    private int samples(double seconds) {
        return Math.max(1, (int) Math.round(seconds * rate));
    }

    /**
     * Takes a sample, and gives the features of the one {@link FeatureSpec#delay} before.
     *
     * @param sample one a channel of {@link FeatureSpec#channels}, in its unit, NaN where missing. Not modified.
     * @param into   features, as long as {@link FeatureSpec#NAMES} and in their units; NaN where a sample that they need is missing.
     *               Modified.
     */
    public void step(double[] sample, double[] into) {
        double seatJerk = seat.step(sample[0]);
        double headJerk = head.step(sample[1]);
        shaking.add((seatJerk * seatJerk + headJerk * headJerk) / 2);
        double surged = surges.add(surge.step(sample[0]));
        double roll = slowly(slow[0], sample[2]);
        double pitch = slowly(slow[1], sample[3]);
        sway.add(roll * roll + pitch * pitch);
        into[FeatureSpec.SEAT_JERK] = seatJerk;
        into[FeatureSpec.HEAD_JERK] = headJerk;
        into[FeatureSpec.SHAKING] = FeatureSpec.shaking(Math.sqrt(shaking.mean()));
        into[FeatureSpec.SURGE] = FeatureSpec.surge(surged);
        into[FeatureSpec.SWAY] = FeatureSpec.sway(Math.sqrt(sway.mean()));
    }

    private static double slowly(MovingMean[] axis, double rate) {
        double value = rate;
        for (MovingMean window : axis) {
            window.add(value);
            value = window.mean();
        }
        return value;
    }

    @Override
    public void save(StateWriter out) {
        out.put(seat);
        out.put(head);
        out.put(surge);
        out.put(shaking);
        out.put(surges);
        out.put(slow[0]);
        out.put(slow[1]);
        out.put(sway);
    }

    @Override
    public void load(StateReader in) {
        in.part(seat);
        in.part(head);
        in.part(surge);
        in.part(shaking);
        in.part(surges);
        in.parts(slow[0]);
        in.parts(slow[1]);
        in.part(sway);
    }
}
