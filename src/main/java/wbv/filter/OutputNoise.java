package wbv.filter;

import java.io.Serializable;
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
    private static final double TRIAL = 2;
    private static final double POWER_MEMORY = 1;
    private static final double LONGEST_MEMORY = 10;
    private static final double SHORTEST_MEMORY = 0.5;
    private static final double LARGEST_SURPRISE = 25;
    /** A fall is believed sooner than a rise: c² is at most this many times what the last second shows. */
    private static final double SHORT_MEMORY = 1;
    private static final double MOST_ABOVE_LATELY = 3;
    /** The motion tells about c as far as this share of its power, or c² of it if that is more, exceeds the sensor's. */
    private static final double VISIBLE = 0.01;
    /** c² for which a changed body is given credit. */
    private static final double DOUBT = 0.1;
    /** c² of a body that may not be the right one. */
    private static final double LITTLE = 0.08;
    private static final double MOST_CORRELATION = 0.9;

    private final double rate;
    private final double sensor;
    private double share;
    private double lately;
    private double age;
    private double power;
    private double previous;
    private double square;
    private double product;

    OutputNoise(double rate, double sensorDeviation) {
        this.rate = rate;
        this.sensor = sensorDeviation * sensorDeviation;
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
        double correlation = Math.max(0, Math.min(MOST_CORRELATION, product / square));
        return (1 + correlation) / (1 - correlation);
    }

    /** Learns quickly again: what disturbs the output is not what it was. */
    void relearn() {
        age = Math.min(age, 2 * TRIAL * rate);
        forgetCorrelation();
    }

    /** Learns quickly again from a model that may be wrong. */
    void doubt() {
        relearn();
        share = Math.max(share, DOUBT);
        lately = Math.max(lately, DOUBT);
    }

    /** Whether the innovations are as large as the output itself, where there is an output at all. */
    boolean explainsNothing() {
        return age > TRIAL * rate && share >= 1 && power > sensor * sensor;
    }

    /** Whether a good part of the motion is not explained. */
    boolean explainsLittle() {
        return share > LITTLE;
    }

    private void forgetCorrelation() {
        previous = 0;
        square = 1;
        product = 0;
    }

    /** @param output of the body without offset [m/s²]; what is believed of it */
    void hear(double output) {
        age++;
        power += (output * output - power) / Math.min(age, POWER_MEMORY * rate);
    }

    /**
     * @param innovation ν [m/s²]
     * @param predicted H P Hᵀ, the part of ν² that the filter expects
     */
    void learn(double innovation, double predicted) {
        if (age <= TRIAL * rate) {
            return;
        }
        double memory = rate * Math.min(LONGEST_MEMORY, Math.max(SHORTEST_MEMORY, (age / rate - TRIAL) / 4));
        double r = variance();
        double s = predicted + r;
        double surprise = Math.min(innovation * innovation, LARGEST_SURPRISE * s);
        double shown = (surprise - predicted - sensor) / power;
        // an innovation tells about R only as far as R is its larger part, and about c as far as there is motion
        double part = Math.max(share, VISIBLE) * power;
        double visible = part / (part + sensor);
        double weight = r / s * visible * visible;
        share = Math.max(0, share + weight * (shown - share) / memory);
        lately += weight * (Math.max(0, shown) - lately) / (rate * SHORT_MEMORY);
        share = Math.min(share, MOST_ABOVE_LATELY * lately);
    }

    /** @param normalised ν/√S of the sample after the one before, once the filter has settled */
    void correlate(double normalised) {
        double forgetting = 1 / (LONGEST_MEMORY * rate);
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
