package wbv.body;

import java.util.Arrays;
import java.util.List;

/** What laws are multiplied by, as series at the free run's rate. */
final class Modulations {

    /** Below, what two integrals make of an accelerometer's noise is more than any sway [Hz]. */
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

    /** By law; empty where nothing modulates. @param links asked only for a law that goes by another link */
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
            return excitation.fineSeries(excitation.other(measured.channel()));
        }
        if (modulator instanceof Modulator.Angle angle) {
            return excitation.fineSeries(Spectra.overJOmega(excitation.omega(), excitation.other(angle.rate())));
        }
        if (modulator instanceof Modulator.Lean lean) {
            return excitation.fineSeries(moved(excitation.other(lean.upper()), excitation.other(lean.lower())));
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

    private double[] moved(double[] upper, double[] lower) {
        double[] omega = excitation.omega();
        double[] out = new double[upper.length];
        for (int k = 1; k < omega.length; k++) {
            double u = Math.pow(omega[k] / (2 * Math.PI * LOWEST), 8);
            double gain = -u / (1 + u) / (omega[k] * omega[k]);
            out[2 * k] = gain * (upper[2 * k] - lower[2 * k]);
            out[2 * k + 1] = gain * (upper[2 * k + 1] - lower[2 * k + 1]);
        }
        return out;
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
