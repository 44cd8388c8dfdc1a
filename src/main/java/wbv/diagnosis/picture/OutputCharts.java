package wbv.diagnosis.picture;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Readings;
import wbv.diagnosis.fit.Window;
import wbv.diagnosis.search.NoiseMetric;
import wbv.recording.Channel;
import wbv.signal.CrossSpectrum;
import wbv.signal.Detrend;
import wbv.signal.FrequencyResponse;
import wbv.signal.LostSamples;
import wbv.signal.RealDft;
import wbv.signal.Segmentation;

/** Measured and simulated outputs, these as the sensors read them, side by side: over time, over frequency, and what is between them. */
final class OutputCharts {

    private static final double BLOCK = 2;
    private static final double LOWEST = 0.5;
    private static final int LEAST_SEGMENTS = 4;

    private final Evidence evidence;
    private final double rate;
    private final double[][] given;
    private final double[][] before;
    private final double[][] after;
    private final NoiseMetric noise;

    OutputCharts(Evidence evidence, Fitter.State given, Fitter.State before, Fitter.State after) {
        this.evidence = evidence;
        this.rate = evidence.recording().clock().rate();
        Readings readings = new Readings(evidence);
        this.before = readings.of(before);
        this.given = given.x() == before.x() ? this.before : readings.of(given);
        this.after = readings.of(after);
        this.noise = new NoiseMetric(evidence, evidence.whole(), after.candidate().at(after.x()));
    }

    List<Pictures.View> all() {
        return IntStream.range(0, evidence.outputs().size()).mapToObj(o -> new Pictures.View(evidence.outputs().get(o).toString(),
                evidence.outputs().get(o).quantity().unit(), traces(o), map(o), transfer(o).stream().toList(), nrmse(o),
                2 * evidence.fit().lines())).toList();
    }

    private Pictures.Traces traces(int o) {
        Window held = evidence.heldOut();
        int from = held.start();
        int to = Math.min(from + held.length(), evidence.recording().unbroken(from));
        return new Pictures.Traces(evidence.recording().elapsed(from), 1 / rate, Arrays.copyOfRange(counted(o), from, to),
                Arrays.copyOfRange(before[o], from, to), Arrays.copyOfRange(after[o], from, to));
    }

    private double[] counted(int o) {
        return LostSamples.marked(evidence.measured(o), evidence.valid(o));
    }

    private double nrmse(int o) {
        double error = 0;
        double size = 0;
        Window held = evidence.heldOut();
        for (int i = held.start(); i < held.start() + held.length(); i++) {
            if (evidence.valid(o)[i]) {
                error += Math.pow(evidence.measured(o)[i] - given[o][i], 2);
                size += Math.pow(evidence.measured(o)[i], 2);
            }
        }
        return Math.sqrt(error / size);
    }

    private Pictures.ResidualMap map(int o) {
        int length = RealDft.fitting((int) Math.round(BLOCK * rate));
        double highest = evidence.fit().frequency(evidence.fit().lines() - 1);
        int first = (int) Math.ceil(LOWEST * length / rate);
        int count = (int) Math.floor(highest * length / rate) - first + 1;
        int hop = length / 2;
        int columns = (evidence.recording().length() - length) / hop + 1;
        double[] time = IntStream.range(0, columns).mapToDouble(c -> evidence.recording().elapsed(c * hop + length / 2)).toArray();
        double[] frequency = IntStream.range(0, count).mapToDouble(k -> (first + k) * rate / length).toArray();
        double[] omega = evidence.whole().omega();
        double[] level = Arrays.stream(frequency)
                .map(f -> noise.variance(o, (int) Math.min(omega.length - 1, Math.round(2 * Math.PI * f / omega[1])))).toArray();
        return new Pictures.ResidualMap(time, frequency, power(o, before[o], length, first, level, columns),
                power(o, after[o], length, first, level, columns));
    }

    private double[][] power(int o, double[] simulated, int length, int first, double[] level, int columns) {
        RealDft transform = new RealDft(length);
        double[] taper = IntStream.range(0, length).mapToDouble(i -> Math.pow(Math.sin(Math.PI * (i + 0.5) / length), 2))
                .toArray();
        double[][] out = new double[columns][level.length];
        for (int c = 0; c < columns; c++) {
            double[] x = new double[length];
            double weight = 0;
            for (int i = 0; i < length; i++) {
                int at = c * (length / 2) + i;
                if (evidence.valid(o)[at]) {
                    x[i] = taper[i] * (evidence.measured(o)[at] - simulated[at]);
                    weight += taper[i] * taper[i];
                }
            }
            double[] spectrum = transform.forward(x);
            for (int k = 0; k < level.length; k++) {
                double re = spectrum[2 * (first + k)];
                double im = spectrum[2 * (first + k) + 1];
                double ratio = (re * re + im * im) / (weight * level[k]);
                out[c][k] = weight < 0.1 * length ? Double.NaN : 10 * Math.log10(Math.max(ratio, 1e-3));
            }
        }
        return out;
    }

    /** What excites the model: its first measured force, or its base. */
    private Channel input() {
        return evidence.model().inputs().isEmpty() ? evidence.model().base().sensor().orElseThrow()
                : evidence.model().inputs().get(0).sensor();
    }

    private static String unit(Channel output, Channel input) {
        return output.quantity() == input.quantity() ? "1" : whole(output.quantity().unit()) + "/"
                + whole(input.quantity().unit());
    }

    private static String whole(String unit) {
        return unit.contains("/") ? "(" + unit + ")" : unit;
    }

    private Optional<Pictures.Transfer> transfer(int o) {
        Channel input = input();
        double[] base = evidence.series(input);
        return response(base, new double[][] {counted(o), before[o], after[o]}, rate).map(h -> {
            int[] shown = IntStream.range(0, h.get(0).frequency().length).filter(k -> h.get(0).frequency()[k] >= LOWEST
                    && h.get(0).frequency()[k] <= evidence.fit().frequency(evidence.fit().lines() - 1)).toArray();
            boolean[] usable = new boolean[shown.length];
            IntStream.range(0, shown.length).forEach(i -> usable[i] = h.get(0).usable()[shown[i]]);
            return new Pictures.Transfer(input.toString(), unit(evidence.outputs().get(o), input),
                    pick(h.get(0).frequency(), shown),
                    pick(h.get(0).h1().magnitudes(), shown),
                    pick(h.get(0).error(), shown), usable, pick(h.get(1).h1().magnitudes(), shown),
                    pick(h.get(2).h1().magnitudes(), shown));
        });
    }

    /**
     * H1 from a signal to each of several, all over the same segments; none where the record is too short.
     *
     * @param y NaN does not count
     */
    static Optional<List<FrequencyResponse>> response(double[] x, double[][] y, double rate) {
        CrossSpectrum spectra = new CrossSpectrum(Segmentation.ofSitter(rate, x.length, LEAST_SEGMENTS, 32), Detrend.MEAN, y.length);
        double[] row = new double[y.length];
        for (int i = 0; i < x.length; i++) {
            for (int o = 0; o < row.length; o++) {
                row[o] = Double.isNaN(y[0][i]) ? Double.NaN : y[o][i];
            }
            spectra.accept(x[i], row);
        }
        if (spectra.averaged(0) == 0) {
            return Optional.empty();
        }
        List<FrequencyResponse> out = new ArrayList<>();
        for (int o = 0; o < row.length; o++) {
            out.add(spectra.response(o, FrequencyResponse.Excited.USUAL));
        }
        return Optional.of(out);
    }

    /** Usable lines from a frequency [Hz] to the highest that is fitted. */
    static int[] usable(Evidence evidence, FrequencyResponse h, double from) {
        double top = evidence.fit().frequency(evidence.fit().lines() - 1);
        return IntStream.range(0, h.frequency().length)
                .filter(k -> h.frequency()[k] >= from && h.frequency()[k] <= top && h.usable()[k]).toArray();
    }

    static double[] pick(double[] values, int[] at) {
        return Arrays.stream(at).mapToDouble(i -> values[i]).toArray();
    }
}
