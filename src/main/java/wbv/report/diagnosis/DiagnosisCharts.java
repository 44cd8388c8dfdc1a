package wbv.report.diagnosis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import wbv.diagnosis.picture.Pictures;
import wbv.report.page.Band;
import wbv.report.page.Beside;
import wbv.report.page.Block;
import wbv.report.page.ChartAxis;
import wbv.report.page.Heatmap;
import wbv.report.page.LineChart;
import wbv.report.page.Section;
import wbv.report.page.Series;
import wbv.report.page.Text;
import wbv.result.Digits;

/** Both models against the recording: what is left in frequency and time, responses, and samples. */
final class DiagnosisCharts {

    private static final double LEAST_RANGE = 20;
    /** Cycles of a close look. */
    private static final double CYCLES = 12;

    private final Pictures pictures;

    DiagnosisCharts(Pictures pictures) {
        this.pictures = pictures;
    }

    /** What the earlier of the two models is. */
    String before() {
        return pictures.completed() ? "fitted alone" : "as given";
    }

    /** What the later one is. */
    String after() {
        return pictures.completed() ? "completed" : "fitted";
    }

    Section residuals() {
        double high = LEAST_RANGE;
        for (Pictures.View view : pictures.views()) {
            double[] sorted = Arrays.stream(view.map().before()).flatMapToDouble(Arrays::stream).filter(Double::isFinite)
                    .sorted().toArray();
            high = sorted.length == 0 ? high : Math.max(high, sorted[(int) (0.995 * (sorted.length - 1))]);
        }
        List<Block> blocks = new ArrayList<>();
        for (Pictures.View view : pictures.views()) {
            blocks.add(new Beside(map(view, view.map().before(), before(), high), map(view, view.map().after(), after(), high)));
        }
        return new Section("Mismatch",
                "Measured minus simulated, as the sensors would read it, by frequency and time, as power above that of the noise: 0 dB is "
                        + "noise alone, 20 dB ten times its amplitude. One scale for all.",
                blocks);
    }

    private static Heatmap map(Pictures.View view, double[][] values, String model, double high) {
        return new Heatmap(view.channel() + ", " + model, ChartAxis.linear("Time", "s"), ChartAxis.linear("Frequency", "Hz"),
                ChartAxis.linear("Above noise", "dB").within(0, high), view.map().time(), view.map().frequency(), values);
    }

    Section responses() {
        List<Block> blocks = new ArrayList<>();
        for (Pictures.View view : pictures.views()) {
            for (Pictures.Transfer h : view.transfer()) {
                IntStream.range(0, h.usable().length).filter(i -> h.usable()[i]).max()
                        .ifPresent(last -> blocks.add(response(view, h, last)));
            }
        }
        List<Block> rows = new ArrayList<>();
        for (int i = 0; i < blocks.size(); i += 2) {
            rows.add(i + 1 < blocks.size() ? new Beside(blocks.get(i), blocks.get(i + 1)) : blocks.get(i));
        }
        if (rows.isEmpty()) {
            rows.add(new Text("The recording is too short to average spectra."));
        }
        return new Section("Responses",
                "Moduli of frequency responses. Those of the models are estimated in the same way, from their "
                        + "samples for the same input, so that what is not linear shows alike.",
                rows);
    }

    /** @param last index of the last usable frequency */
    private LineChart response(Pictures.View view, Pictures.Transfer h, int last) {
        double[] f = Arrays.copyOf(h.frequency(), last + 1);
        boolean[] usable = Arrays.copyOf(h.usable(), last + 1);
        double[] measured = where(usable, h.measured());
        double[] deviation = IntStream.rangeClosed(0, last).mapToDouble(i -> measured[i] * h.error()[i]).toArray();
        return new LineChart(h.input() + " to " + view.channel(), ChartAxis.log("Frequency", "Hz"), ChartAxis.linear("|H1|", h.unit()),
                List.of(Series.line("measured", f, measured).with(Band.deviations(measured, deviation, 2, "±2σ")),
                        Series.line("model " + before(), f, where(usable, h.before())),
                        Series.dashed("model " + after(), f, where(usable, h.after()))))
                .shadedUnless(usable, f, "low coherence, or not excited");
    }

    private static double[] where(boolean[] usable, double[] values) {
        return IntStream.range(0, usable.length).mapToDouble(i -> usable[i] ? values[i] : Double.NaN).toArray();
    }

    Section histories() {
        List<Block> blocks = new ArrayList<>();
        int all = pictures.views().get(0).heldOut().measured().length;
        int close = close();
        boolean closeUp = all > 2 * close;
        int from = worst(close);
        for (Pictures.View view : pictures.views()) {
            LineChart whole = traces(view, 0, all).grouped("held out");
            blocks.add(closeUp ? new Beside(traces(view, from, from + close).grouped("close"), whole) : whole);
        }
        String where = Digits.significant(close * pictures.views().get(0).heldOut().step(), 2) + " s in which the model "
                + before();
        return new Section("Held out",
                "Samples that took no part in the fit, those of models as the sensors would read them"
                        + (closeUp ? ": on the left the " + where
                                + " fails most, on the right all of them." : "."),
                blocks);
    }

    private LineChart traces(Pictures.View view, int from, int to) {
        Pictures.Traces traces = view.heldOut();
        double[] time = IntStream.range(from, to).mapToDouble(i -> traces.from() + i * traces.step()).toArray();
        return new LineChart(view.channel(), ChartAxis.linear("Time", "s"), ChartAxis.linear(view.channel(), view.unit()),
                List.of(Series.line("measured", time, Arrays.copyOfRange(traces.measured(), from, to)),
                        Series.line("model " + before(), time, Arrays.copyOfRange(traces.before(), from, to)),
                        Series.dashed("model " + after(), time, Arrays.copyOfRange(traces.after(), from, to))));
    }

    /** Samples of a close look at the output that swings fastest; its frequency is that of Rice (1945), from slope over size. */
    private int close() {
        double fastest = 0;
        for (Pictures.View view : pictures.views()) {
            double[] y = view.heldOut().after();
            double size = 0;
            double slope = 0;
            for (int i = 1; i < y.length; i++) {
                size += y[i] * y[i];
                slope += (y[i] - y[i - 1]) * (y[i] - y[i - 1]);
            }
            fastest = size > 0 ? Math.max(fastest, Math.sqrt(slope / size) / (2 * Math.PI)) : fastest;
        }
        return (int) Math.ceil(CYCLES / Math.max(fastest, 1e-3));
    }

    /** First sample of the seconds in which the earlier model fails most, each output in units of its own signal. */
    private int worst(int length) {
        double[] sum = new double[pictures.views().get(0).heldOut().measured().length];
        for (Pictures.View view : pictures.views()) {
            double[] y = view.heldOut().measured();
            double size = Arrays.stream(y).filter(Double::isFinite).map(v -> v * v).sum();
            for (int i = 0; i < sum.length; i++) {
                double error = y[i] - view.heldOut().before()[i];
                sum[i] += Double.isNaN(error) ? 0 : error * error / size;
            }
        }
        double[] running = new double[sum.length + 1];
        for (int i = 0; i < sum.length; i++) {
            running[i + 1] = running[i] + sum[i];
        }
        return IntStream.range(0, Math.max(1, sum.length - length)).boxed()
                .max(java.util.Comparator.comparingDouble(i -> running[Math.min(sum.length, i + length)] - running[i])).orElse(0);
    }
}
