package wbv.body.simulate;

import java.util.Arrays;
import java.util.List;
import wbv.body.LawAt;
import wbv.body.Spectra;
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

    private static final ModulatorSeries.Links UNKNOWN = new ModulatorSeries.Links() {
        @Override
        public double[] load(int link) {
            throw new IllegalStateException("what link " + (link + 1) + " carries is not known before it moves");
        }

        @Override
        public double[] displacement(int link) {
            throw new IllegalStateException("how link " + (link + 1) + " moves is not known before it does");
        }

        @Override
        public double[] velocity(int link) {
            return displacement(link);
        }
    };

    private final Excitation excitation;

    Modulations(Excitation excitation) {
        this.excitation = excitation;
    }

    /** By law; empty where nothing modulates, or another link does, which only a run knows. */
    double[][] of(List<LawAt> laws) {
        return laws.stream().map(at -> at.law().modulator()).map(modulator -> modulator.otherLink().isPresent() ? new double[0]
                : of(modulator, UNKNOWN)).toArray(double[][]::new);
    }

    double[] of(Modulator modulator, ModulatorSeries.Links links) {
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
            return switch (other.of()) {
                case LOAD -> links.load(other.link());
                case DEFLECTION -> links.displacement(other.link());
                case SPEED -> links.velocity(other.link());
            };
        }
        if (modulator instanceof Modulator.PartOf part) {
            double[] whole = of(part.whole(), links).clone();
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
