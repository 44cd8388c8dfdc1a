package wbv.control.trial;

import wbv.rig.Subject;

/**
 * Who rides where, for how long.
 *
 * @param sitter  who sits there
 * @param floor under the seat
 * @param scale factor of the floor's accelerations, &gt; 0
 * @param jolt    height of a jolt every {@value #JOLT_EVERY} s [m/s²], one sine of {@value #JOLT_LENGTH} s, &gt;= 0
 * @param settle  time that is ridden but not judged, at the beginning [s], &gt;= 0
 * @param seconds time that is judged [s], &gt; 0
 * @param seed    of the floor and the sensors
 * @param faults  what goes wrong; times count from the beginning of the judged part
 */
public record Ride(Subject sitter, Floor floor, double scale, double jolt, double settle, double seconds, long seed, Faults faults) {

    static final double JOLT_EVERY = 10;
    static final double JOLT_LENGTH = 0.3;

    public Ride {
        if (!(scale > 0 && jolt >= 0 && settle >= 0 && seconds > 0 && settle + seconds <= 3600)) {
            throw new IllegalArgumentException(
                    "a ride needs a scale > 0, jolts >= 0 m/s² and at most 3600 s: " + scale + ", " + jolt + " m/s², " + settle
                            + " + " + seconds + " s");
        }
    }

    /**
     * A ride without faults and jolts.
     *
     * @param settle as there [s]
     * @param seconds as there [s]
     */
    public Ride(Subject sitter, Floor floor, double settle, double seconds, long seed) {
        this(sitter, floor, 1, 0, settle, seconds, seed, Faults.NONE);
    }

    /** The same under faults. */
    public Ride with(Faults others) {
        return new Ride(sitter, floor, scale, jolt, settle, seconds, seed, others);
    }

    /**
     * The same with a jolt every 10 s.
     *
     * @param height [m/s²]
     */
    public Ride withJolts(double height) {
        return new Ride(sitter, floor, scale, height, settle, seconds, seed, faults);
    }
}
