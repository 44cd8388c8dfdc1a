package wbv.body.simulate;

import java.util.Arrays;
import java.util.List;
import wbv.body.Spectra;
import wbv.body.law.LawAt;
import wbv.body.number.Modulator;
import wbv.recording.Channel;

/** What laws are multiplied by, as series at the free run's rate. */
final class Modulations {

    /** Below, what the integral of a gyroscope's wandering offset makes is more than any turn [Hz]. */
    private static final double SLOWEST_TURN = 0.03;
    /**
     * Below, what two integrals make of an accelerometer's noise is more than any sway [Hz]: from there on 200 µg/√Hz in each of two
     * sensors make a quarter of a millimetre.
     */
    private static final double LOWEST = 0.3;
    /** What another link does depends on the motion that depends on it: so often it is worked out anew. */
    private static final int ROUNDS = 2;

    private final Excitation excitation;

    Modulations(Excitation excitation) {
        this.excitation = excitation;
    }

    /** How often a run has to be repeated until the loads that laws go by are those of the motion that they make. */
    static int rounds(List<LawAt> laws) {
        return laws.stream().anyMatch(at -> at.law().modulator().otherLink().isPresent()) ? ROUNDS : 0;
    }

    /**
     * By law; empty where nothing modulates.
     *
     * @param links asked only for a law that goes by another link
     */
    double[][] of(List<LawAt> laws, Links links) {
        return laws.stream().map(at -> of(at.law().modulator(), links)).toArray(double[][]::new);
    }

    /** What links do, as spectra. */
    interface Links {
        double[] load(int link);

        double[] deflection(int link);
    }

    double[] of(Modulator modulator, Links links) {
        if (modulator instanceof Modulator.None) {
            return new double[0];
        }
        if (modulator instanceof Modulator.Measured measured) {
            return excitation.fineSeries(centred(measured.channel()));
        }
        if (modulator instanceof Modulator.Level level) {
            return Arrays.stream(excitation.level(level.channel())).map(level::of).toArray();
        }
        if (modulator instanceof Modulator.Angle angle) {
            return excitation.fineSeries(above(SLOWEST_TURN, Spectra.overJOmega(excitation.omega(), centred(angle.rate()))));
        }
        if (modulator instanceof Modulator.Lean lean) {
            double[] apart = excitation.other(lean.upper()).clone();
            Spectra.add(apart, excitation.other(lean.lower()), -1);
            double[] omega = excitation.omega();
            return excitation.fineSeries(above(LOWEST, Spectra.overJOmega(omega, Spectra.overJOmega(omega, apart))));
        }
        if (modulator instanceof Modulator.OtherLink other) {
            double[] moved = other.of() == Modulator.Of.LOAD ? links.load(other.link()) : links.deflection(other.link());
            return excitation.fineSeries(other.of() == Modulator.Of.SPEED ? Spectra.timesJOmega(excitation.omega(), moved) : moved);
        }
        if (modulator instanceof Modulator.PartOf part) {
            double[] whole = of(part.whole(), links);
            Arrays.setAll(whole, i -> part.of(whole[i]));
            return whole;
        }
        return ride(((Modulator.Ride) modulator).seconds());
    }

    /**
     * A channel without its mean, which is its sensor's offset as likely as not: over a record with silence behind it that would be a blow.
     */
    private double[] centred(Channel channel) {
        double[] series = excitation.series(excitation.other(channel));
        double mean = Arrays.stream(series).average().orElse(0);
        Arrays.setAll(series, i -> series[i] - mean);
        return excitation.spectrum(series);
    }

    /**
     * What is faster than a frequency [Hz].
     *
     * @param spectrum Modified.
     */
    private double[] above(double lowest, double[] spectrum) {
        for (int i = 0; i < spectrum.length; i++) {
            double u = Math.pow(excitation.omega()[i / 2] / (2 * Math.PI * lowest), 8);
            spectrum[i] *= u / (1 + u);
        }
        return spectrum;
    }

    private double[] ride(double seconds) {
        double[] out = excitation.fineSeries(excitation.baseSpectrum());
        double decay = Math.exp(-excitation.fineStep() / seconds);
        double square = 0;
        for (int i = 0; i < out.length; i++) {
            square = decay * square + (1 - decay) * out[i] * out[i];
            out[i] = Math.sqrt(square);
        }
        return out;
    }
}
