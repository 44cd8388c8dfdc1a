package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Readings;
import wbv.diagnosis.fit.Window;
import wbv.diagnosis.search.NoiseMetric;

/** Where a fit misses what was measured: by output, frequency and time. */
final class Mismatch {

    private final Evidence evidence;
    private final Fitter.State base;

    Mismatch(Evidence evidence, Fitter.State base) {
        this.evidence = evidence;
        this.base = base;
    }

    /** Every output over all noise that reaches it, each by itself. */
    List<Diagnosis.Located> located() {
        Window window = evidence.fit();
        double[] omega = evidence.whole().omega();
        double[][] read = new Readings(evidence).of(base);
        NoiseMetric noise = new NoiseMetric(evidence, evidence.whole(), base.candidate().at(base.x()));
        List<Diagnosis.Located> out = new ArrayList<>();
        for (int o = 0; o < read.length; o++) {
            double[] measured = evidence.measured(o);
            double[] own = read[o];
            double[] spectrum = window.spectrum(IntStream.range(0, own.length).mapToDouble(i -> measured[i] - own[i]).toArray(),
                    evidence.valid(o));
            double[] byLine = new double[window.lines()];
            double power = 0;
            for (int line = 0; line < byLine.length; line++) {
                int at = (int) Math.min(omega.length - 1, Math.round(2 * Math.PI * window.frequency(line) / omega[1]));
                double level = Math.sqrt(noise.variance(o, at));
                spectrum[2 * line] /= level;
                spectrum[2 * line + 1] /= level;
                double each = Math.pow(spectrum[2 * line], 2) + Math.pow(spectrum[2 * line + 1], 2);
                byLine[line] = Math.max(0, each - 2);
                power += each;
            }
            double[] byTime = Arrays.stream(window.series(spectrum)).map(value -> value * value).toArray();
            out.add(new Diagnosis.Located(evidence.outputs().get(o).toString(),
                    new double[] {window.frequency(at(byLine, 0.1)), window.frequency(at(byLine, 0.9))},
                    new double[] {evidence.recording().elapsed(window.start() + at(byTime, 0.1)),
                        evidence.recording().elapsed(window.start() + at(byTime, 0.9))},
                    power, power / (2 * byLine.length)));
        }
        double total = out.stream().mapToDouble(Diagnosis.Located::share).sum();
        return out.stream().map(one -> new Diagnosis.Located(one.channel(), one.band(), one.time(), one.share() / total, one.times()))
                .sorted(Comparator.comparingDouble(Diagnosis.Located::share).reversed()).toList();
    }

    /** Index at which a share of the sum is reached. */
    private static int at(double[] x, double share) {
        double total = Arrays.stream(x).sum();
        double sum = 0;
        for (int i = 0; i < x.length; i++) {
            sum += x[i];
            if (sum >= share * total) {
                return i;
            }
        }
        return x.length - 1;
    }
}
