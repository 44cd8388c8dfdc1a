package wbv.identify;

import java.util.Arrays;
import java.util.Locale;
import java.util.function.Function;

/**
 * Identification of a known body (5 Hz, damping ratio 0.35) over 50 seeds at 20 and 10 dB: the long proof, a command of its own.
 * {@code java -cp … wbv.identify.IdentifyProof}
 */
public final class IdentifyProof {

    private static final int SEEDS = 50;
    private static final int SAMPLES = 3600;
    private static final Orders ORDERS = new Orders(2, 3, 2, 0);

    private IdentifyProof() {}

    public static void main(String[] arguments) {
        System.out.println("| method | data | SNR [dB] | frequency, mean ± deviation [Hz] | damping ratio, mean ± deviation | no mode |");
        System.out.println("|---|---|---|---|---|---|");
        for (double decibel : new double[] {20, 10}) {
            row("prediction error", "ARMAX", decibel, samples -> new PredictionError(ORDERS).fit(samples).model().poles());
            row("extended least squares", "ARMAX", decibel, samples -> recursive(RecursiveArmax.Kind.EXTENDED_LEAST_SQUARES,
                    samples));
            row("recursive maximum likelihood", "ARMAX", decibel, samples -> recursive(RecursiveArmax.Kind.MAXIMUM_LIKELIHOOD,
                    samples));
            row("refined instruments", "body, white output noise", decibel, samples -> new RefinedInstruments(2, 1, 30)
                    .fit(samples).model().poles());
            row("prediction error", "body, white output noise", decibel, samples -> new PredictionError(ORDERS).fit(samples)
                    .model().poles());
        }
    }

    private static PoleSet recursive(RecursiveArmax.Kind kind, Samples samples) {
        RecursiveArmax filter = new RecursiveArmax(kind, ORDERS, 1, samples.rate(), 1);
        double[] u = new double[1];
        for (int k = 0; k < samples.length(); k++) {
            u[0] = samples.u()[0][k];
            filter.step(u, samples.y()[k]);
        }
        return filter.model().poles();
    }

    private static void row(String method, String data, double decibel, Function<Samples, PoleSet> identify) {
        double[] frequency = new double[SEEDS];
        double[] damping = new double[SEEDS];
        int found = 0;
        for (int seed = 0; seed < SEEDS; seed++) {
            Samples samples = data.equals("ARMAX") ? KnownSystem.armax(decibel, SAMPLES, seed) : KnownSystem.body(5, 0.35,
                    decibel, SAMPLES, seed);
            PoleSet poles = identify.apply(samples);
            if (!poles.modes().isEmpty()) {
                frequency[found] = poles.modes().get(0).frequency();
                damping[found] = poles.modes().get(0).damping();
                found++;
            }
        }
        System.out.printf(Locale.ROOT, "| %s | %s | %.0f | %s | %s | %d |%n", method, data, decibel, text(Arrays.copyOf(frequency,
                found)),
                text(Arrays.copyOf(damping, found)), SEEDS - found);
    }

    private static String text(double[] values) {
        double mean = Arrays.stream(values).average().orElse(Double.NaN);
        double square = Arrays.stream(values).map(v -> (v - mean) * (v - mean)).sum() / Math.max(1, values.length - 1);
        return String.format(Locale.ROOT, "%.4f ± %.4f", mean, Math.sqrt(square));
    }
}
