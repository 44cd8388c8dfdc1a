package wbv.learn;

import moa.classifiers.core.driftdetection.ChangeDetector;
import wbv.filter.drift.Alarm;

/**
 * Any of MOA's change detectors as an {@link Alarm}. Such a detector does not say which values it still regards as one regime: those
 * since it last rang do, and the last {@value #RECENT} of them when it rings.
 */
final class DetectorAlarm implements Alarm {

    private static final long serialVersionUID = 1;
    /** ADWIN's clock: the values of one look. */
    private static final int RECENT = 32;

    private final ChangeDetector fresh;
    private ChangeDetector detector;
    private long width;
    private double mean;
    private double recent;

    /** @param fresh a detector that has heard nothing; it never will, its copies do */
    DetectorAlarm(ChangeDetector fresh) {
        this.fresh = fresh;
        reset();
    }

    @Override
    public boolean feed(double value) {
        width++;
        mean += (value - mean) / width;
        recent += (value - recent) / Math.min(width, RECENT);
        detector.input(value);
        if (!detector.getChange()) {
            return false;
        }
        mean = recent;
        width = Math.min(width, RECENT);
        return true;
    }

    @Override
    public long width() {
        return width;
    }

    @Override
    public double mean() {
        return mean;
    }

    /** A copy of the fresh one: not every detector's own reset forgets all. */
    @Override
    public void reset() {
        detector = (ChangeDetector) fresh.copy();
        width = 0;
        mean = 0;
        recent = 0;
    }
}
