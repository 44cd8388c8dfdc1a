package wbv.body;

import java.util.List;

/** What laws are multiplied by, as series at the free run's rate. */
final class Modulations {

    /** Below, what two integrals make of an accelerometer's noise is more than any sway [Hz]. */
    private static final double LOWEST = 0.3;
    /** A load depends on the motion that depends on the load: so often it is worked out anew. */
    private static final int ROUNDS = 2;

    private final Excitation excitation;

    Modulations(Excitation excitation) {
        this.excitation = excitation;
    }

    /** How often a run has to be repeated until the loads that laws go by are those of the motion that they make. */
    static int rounds(List<LawAt> laws) {
        return laws.stream().anyMatch(at -> at.law().modulator() instanceof Modulator.Load) ? ROUNDS : 0;
    }

    /** By law; empty where nothing modulates. @param loads force in each link, spectra; asked only for a law that goes by one */
    double[][] of(List<LawAt> laws, Loads loads) {
        return laws.stream().map(at -> of(at.law().modulator(), loads)).toArray(double[][]::new);
    }

    /** Spectrum of the force in a link. */
    interface Loads {
        double[] of(int link);
    }

    double[] of(Modulator modulator, Loads loads) {
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
        if (modulator instanceof Modulator.Load load) {
            return excitation.fineSeries(loads.of(load.link()));
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
