package wbv.recording;

/**
 * The counter or clock inside a sensor that the times of its rows were made from.
 *
 * @param origin what that clock said at {@code t = 0} [s]
 * @param period after how long it starts again at zero [s], &gt; 0
 */
public record SensorClock(double origin, double period) {

    public SensorClock {
        if (!Double.isFinite(origin)) {
            throw new IllegalArgumentException("origin must be a finite time in s: " + origin);
        }
        if (!(period > 0)) {
            throw new IllegalArgumentException("period must be > 0 s: " + period);
        }
    }
}
