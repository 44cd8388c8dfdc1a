package wbv.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import wbv.diagnosis.Pictures;

/** Both models against the recording: what is left in frequency and time, responses, and samples. */
final class DiagnosisCharts {

    private static final double LEAST_RANGE = 10;

    private final Pictures pictures;

    DiagnosisCharts(Pictures pictures) {
        this.pictures = pictures;
    }

    Section residuals() {
        double high = LEAST_RANGE;
        for (Pictures.View view : pictures.views()) {
            double[] sorted = Arrays.stream(view.map().before()).flatMapToDouble(Arrays::stream).filter(Double::isFinite).sorted().toArray();
            high = sorted.length == 0 ? high : Math.max(high, sorted[(int) (0.995 * (sorted.length - 1))]);
        }
        List<Block> blocks = new ArrayList<>();
        for (Pictures.View view : pictures.views()) {
            blocks.add(new Beside(map(view, view.map().before(), pictures.before(), high), map(view, view.map().after(), pictures.after(), high)));
        }
        return new Section("Mismatch", "Measured minus simulated by frequency and time, as power above that of the sensors' noise: 0 dB is "
                + "noise alone, 20 dB ten times its amplitude. One scale for all.", blocks);
    }

    private static Heatmap map(Pictures.View view, double[][] values, String model, double high) {
        return new Heatmap(view.channel() + ", " + model, Axis.linear("Time", "s"), Axis.linear("Frequency", "Hz"),
                Axis.linear("Above noise", "dB").within(0, high), view.map().time(), view.map().frequency(), values);
    }

    Section responses() {
        List<Block> blocks = new ArrayList<>();
        for (Pictures.View view : pictures.views()) {
            for (Pictures.Transfer h : view.transfer()) {
                double[] deviation = IntStream.range(0, h.measured().length)
                        .mapToDouble(i -> h.usable()[i] ? h.measured()[i] * h.error()[i] : Double.NaN).toArray();
                double top = IntStream.range(0, h.measured().length).filter(i -> h.usable()[i])
                        .mapToDouble(i -> Math.max(h.measured()[i], Math.max(h.before()[i], h.after()[i]))).max().orElse(1);
                blocks.add(new LineChart("Base to " + view.channel(), Axis.log("Frequency", "Hz"), Axis.linear("|H1|", "1").within(0, 1.1 * top),
                        List.of(Series.line("measured", h.frequency(), h.measured()).with(Band.deviations(h.measured(), deviation, 2, "±2σ")),
                                Series.line("model " + pictures.before(), h.frequency(), h.before()),
                                Series.dashed("model " + pictures.after(), h.frequency(), h.after())))
                        .shadedUnless(h.usable(), h.frequency(), "low coherence"));
            }
        }
        List<Block> rows = new ArrayList<>();
        for (int i = 0; i < blocks.size(); i += 2) {
            rows.add(i + 1 < blocks.size() ? new Beside(blocks.get(i), blocks.get(i + 1)) : blocks.get(i));
        }
        if (rows.isEmpty()) {
            rows.add(new Text("The recording is too short to average spectra."));
        }
        return new Section("Responses", "Moduli of frequency responses from the base. Those of the models are estimated in the same way, from their "
                + "samples on the same base motion, so that what is not linear shows alike.", rows);
    }

    Section histories() {
        List<Block> blocks = new ArrayList<>();
        for (Pictures.View view : pictures.views()) {
            Pictures.Traces traces = view.heldOut();
            double[] time = IntStream.range(0, traces.measured().length).mapToDouble(i -> traces.from() + i * traces.step()).toArray();
            blocks.add(new LineChart(view.channel(), Axis.linear("Time", "s"), Axis.linear(view.channel(), view.unit()),
                    List.of(Series.line("measured", time, traces.measured()), Series.line("model " + pictures.before(), time, traces.before()),
                            Series.dashed("model " + pictures.after(), time, traces.after()))).grouped("held out"));
        }
        return new Section("Held out", "Samples that took no part in the fit. Drag over a second or two to see one cycle.", blocks);
    }
}
