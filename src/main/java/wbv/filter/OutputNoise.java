package wbv.filter;

import java.io.Serializable;
import wbv.filter.model.Adaptation;
import wbv.filter.model.Spec;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Variance R of what the model does not explain in the output: {@code R = σ² + c² p}, the sensor's noise and a share c of the
 * motion, since what a real body does beside the model grows with its motion. p is the output's power in the last second; c²
 * is learned from the innovations so that {@code E[ν²] = H P Hᵀ + R} (after Mehra, IEEE Trans. Automatic Control 1970). For
 * the first seconds the model is taken to explain nothing, c = 1.
 *
 * <p>Innovations of a wrong model follow each other. Their correlation ρ from one to the next makes n of them worth
 * {@code n (1 - ρ) / (1 + ρ)} independent ones (Bartlett 1935), so that the filter must weigh them with a larger variance.
 */
final class OutputNoise implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;

    private final Adaptation.Noise settings;
    private final double rate;
    private final double sensor;
    private double share;
    private double lately;
    private double age;
    private double power;
    private double previous;
    private double square;
    private double product;

    OutputNoise(Spec spec) {
        this.settings = spec.adaptation().noise();
        this.rate = spec.rate();
        this.sensor = spec.outputNoise() * spec.outputNoise();
        reset();
    }

    void reset() {
        share = 1;
        lately = 1;
        age = 0;
        power = 0;
        forgetCorrelation();
    }

    /** R [m²/s⁴] of one sample. */
    double variance() {
        return sensor + share * power;
    }

    /** How many samples count as one. &gt;= 1. */
    double samplesInOne() {
        double correlation = Math.max(0, Math.min(settings.mostCorrelation(), product / square));
        return (1 + correlation) / (1 - correlation);
    }

    /** Learns quickly again: what disturbs the output is not what it was. */
    void relearn() {
        age = Math.min(age, 2 * settings.trial() * rate);
        forgetCorrelation();
    }

    /** Learns quickly again from a model that may be wrong. */
    void doubt() {
        relearn();
        share = Math.max(share, settings.doubt());
        lately = Math.max(lately, settings.doubt());
    }

    /** Whether the innovations are as large as the output itself, where there is an output at all. */
    boolean explainsNothing() {
        return age > settings.trial() * rate && share >= 1 && power > sensor * sensor;
    }

    /** Whether a good part of the motion is not explained. */
    boolean explainsLittle() {
        return share > settings.little();
    }

    private void forgetCorrelation() {
        previous = 0;
        square = 1;
        product = 0;
    }

    /** @param output of the body without offset [m/s²]; what is believed of it */
    void hear(double output) {
        age++;
        power += (output * output - power) / Math.min(age, settings.powerMemory() * rate);
    }

    /**
     * @param innovation ν [m/s²]
     * @param predicted H P Hᵀ, the part of ν² that the filter expects
     */
    void learn(double innovation, double predicted) {
        if (age <= settings.trial() * rate) {
            return;
        }
        double memory = rate * Math.min(settings.longestMemory(),
                Math.max(settings.shortestMemory(), settings.growth() * (age / rate - settings.trial())));
        double r = variance();
        double s = predicted + r;
        double surprise = Math.min(innovation * innovation, settings.largestSurprise() * s);
        double shown = (surprise - predicted - sensor) / power;
        // an innovation tells about R only as far as R is its larger part, and about c as far as there is motion
        double part = Math.max(share, settings.visible()) * power;
        double visible = part / (part + sensor);
        double weight = r / s * visible * visible;
        share = Math.max(0, share + weight * (shown - share) / memory);
        lately += weight * (Math.max(0, shown) - lately) / (rate * settings.latelyMemory());
        share = Math.min(share, settings.mostAboveLately() * lately);
    }

    /** @param normalised ν/√S of the sample after the one before, once the filter has settled */
    void correlate(double normalised) {
        double forgetting = 1 / (settings.longestMemory() * rate);
        square += forgetting * (normalised * normalised - square);
        product += forgetting * (normalised * previous - product);
        previous = normalised;
    }

    @Override
    public void save(StateWriter out) {
        out.put(share);
        out.put(lately);
        out.put(age);
        out.put(power);
        out.put(previous);
        out.put(square);
        out.put(product);
    }

    @Override
    public void load(StateReader in) {
        share = in.number();
        lately = in.number();
        age = in.number();
        power = in.number();
        previous = in.number();
        square = in.number();
        product = in.number();
    }
}
