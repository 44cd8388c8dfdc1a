package wbv.filter.drift;

import java.io.Serializable;
import wbv.filter.model.Adaptation;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Hears that a body is no longer what it was: Page's test (Biometrika 1954) on the log likelihood of each output as foreseen by
 * filters that follow the body, over that by one that does not. Whatever the filters have learned before a sample, the mean of
 * the ratio is 1 while the body stays as it was, so that the test rings falsely at most once in {@code e^h} samples (Lorden,
 * Annals of Mathematical Statistics 1971), which for usual settings is once a day.
 */
public final class EvidenceTest implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;

    private final double enough;
    private final double mostAtOnce;
    private final double likely;
    private double sum;

    /**
     * No evidence yet.
     *
     * @param rate     of the samples [Hz]
     * @param settings how far false alarms are apart
     */
    public EvidenceTest(double rate, Adaptation.Changes settings) {
        this.enough = Math.log(settings.apart() * rate);
        this.mostAtOnce = enough / settings.leastSamples();
        this.likely = Math.log(settings.likelyOdds());
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
        sum = Math.max(0, sum + Math.min(mostAtOnce, gain));
        return sum > enough;
    }

    /** Whether it is more likely than not by far that the body has changed. */
    public boolean likely() {
        return sum > likely;
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
