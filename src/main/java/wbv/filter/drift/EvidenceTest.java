package wbv.filter.drift;

import java.io.Serializable;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Hears that a body is no longer what it was: Page's test (Biometrika 1954) on the log likelihood of each output as foreseen by
 * filters that follow the body, over that by one that does not. Whatever the filters have learned before a sample, the mean of
 * the ratio is 1 while the body stays as it was, so that the test rings falsely at most once in {@code e^h} samples (Lorden,
 * Annals of Mathematical Statistics 1971), which here is once in {@value #APART} seconds.
 */
public final class EvidenceTest implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;
    /** Time between false alarms, at least [s]: a day. */
    private static final double APART = 86400;
    /** Samples that must agree, at least: no single shock is a change. To count less never rings more. */
    private static final double LEAST_SAMPLES = 4;
    /** The odds at which another's alarm is one about the body: 20 to 1. */
    private static final double LIKELY = Math.log(20);

    private final double enough;
    private double sum;

    /**
     * No evidence yet.
     *
     * @param rate of the samples [Hz]
     */
    public EvidenceTest(double rate) {
        this.enough = Math.log(APART * rate);
    }

    /** Forgets what it heard. */
    public void restart() {
        sum = 0;
    }

    /**
     * Hears a sample.
     *
     * @param gain log likelihood ratio
     * @return true if the body has changed
     */
    public boolean hear(double gain) {
        sum = Math.max(0, sum + Math.min(enough / LEAST_SAMPLES, gain));
        return sum > enough;
    }

    /** Whether it is more likely than not by far that the body has changed. */
    public boolean likely() {
        return sum > LIKELY;
    }

    @Override
    public void save(StateWriter out) {
        out.put(sum);
    }

    @Override
    public void load(StateReader in) {
        sum = in.number();
    }
}
