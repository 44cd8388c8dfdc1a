package wbv.filter;

import java.io.Serializable;
import wbv.filter.drift.Alarm;
import wbv.filter.drift.ChangeTest;
import wbv.filter.drift.Probability;
import wbv.filter.model.Adaptation;
import wbv.filter.model.Spec;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Watches whether innovations are what the filter expects. The {@link Alarm} hears the probability of each ν²/S under a right
 * model, uniform in [0, 1], and {@link ChangeTests} beside it what a window cannot; all listen only after the innovations have
 * been consistent for a while.
 */
final class InnovationWatch implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;

    /** What an innovation means. */
    enum Verdict {
        /** Nothing yet, the alarm does not listen. */
        UNSETTLED,
        /** All as expected. */
        QUIET,
        /** Not the body, but what the model leaves of the output has changed; that it has become less, mostly. */
        DISTURBED,
        /** The body has changed. */
        CHANGED,
        /** The model has nothing to do with the output. */
        LOST
    }

    private final Adaptation.Watch settings;
    private final double rate;
    private final Alarm alarm;
    private final ChangeTests tests;
    private double mean;
    private double longMean;
    private double untilSettled;
    private double useless;
    private ChangeTest heard = ChangeTest.NONE;
    private boolean settled;

    /** @param spec rate and adaptation */
    InnovationWatch(Spec spec, Alarm alarm, ChangeTests tests) {
        this.settings = spec.adaptation().watch();
        this.rate = spec.rate();
        this.alarm = alarm;
        this.tests = tests;
        restart();
    }

    void restart() {
        mean = 1;
        longMean = 1;
        useless = 0;
        tests.restart();
        unsettle();
    }

    private void unsettle() {
        untilSettled = settings.settling();
        settled = false;
        forget();
    }

    private void forget() {
        tests.forget();
        alarm.reset();
    }

    boolean settled() {
        return settled;
    }

    long width() {
        return alarm.width();
    }

    /** What rang at the last sample. */
    ChangeTest heardBy() {
        return heard;
    }

    /**
     * Hears a sample that tells about the parameters.
     *
     * @param nis        ν²/S
     * @param normalised ν/√S, S as large as correlated innovations make it
     * @param slope      how much the output depends on ln ω, over the same √S
     * @param noise      what the model leaves
     */
    Verdict hear(double nis, double normalised, double slope, OutputNoise noise) {
        heard = ChangeTest.NONE;
        mean += (Math.min(nis, settings.mostCounted()) - mean) / (settings.memory() * rate);
        useless = noise.explainsNothing() ? useless + 1 / rate : 0;
        if (mean > settings.hopeless() || useless > settings.longestUseless()) {
            return Verdict.LOST;
        }
        longMean += (mean - longMean) / (settings.longMemory() * rate);
        boolean steady = Math.abs(mean - longMean) < settings.steady() * longMean;
        boolean consistent = mean < settings.mostConsistent() && (mean > settings.leastConsistent() || steady);
        untilSettled = consistent ? untilSettled - 1 / rate : settings.settling();
        settled |= untilSettled <= 0;
        double before = alarm.mean();
        boolean cut = settled && alarm.feed(Probability.chiSquare1(tests.nis(nis)));
        ChangeTest test = settled || tests.listenEarly() ? tests.hear(nis, normalised, slope, noise) : ChangeTest.NONE;
        if (!cut && test == ChangeTest.NONE) {
            return settled ? Verdict.QUIET : Verdict.UNSETTLED;
        }
        heard = test == ChangeTest.NONE ? ChangeTest.DETECTOR : test;
        boolean changed = test != ChangeTest.NONE || tests.isOfTheBody(alarm.mean() > before);
        if (tests.deafAfterChange()) {
            unsettle();
        } else {
            forget();
        }
        return changed ? Verdict.CHANGED : Verdict.DISTURBED;
    }

    @Override
    public void save(StateWriter out) {
        out.put(mean);
        out.put(longMean);
        out.put(untilSettled);
        out.put(useless);
        out.put(settled);
        out.put(tests);
        out.put(alarm);
    }

    @Override
    public void load(StateReader in) {
        mean = in.number();
        longMean = in.number();
        untilSettled = in.number();
        useless = in.number();
        settled = in.flag();
        in.part(tests);
        in.part(alarm);
    }
}
