package wbv.report.page;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import wbv.report.page.Figures.Figure;
import wbv.report.page.Findings.Finding;
import wbv.report.page.Findings.Severity;
import wbv.report.page.LineChart.Marker;
import wbv.report.page.LineChart.Shade;
import wbv.report.page.Table.Column;
import wbv.signal.CrossSpectrum;
import wbv.signal.Detrend;
import wbv.signal.Envelope;
import wbv.signal.FrequencyResponse;
import wbv.signal.PowerSpectrum;
import wbv.signal.Segmentation;
import wbv.signal.Spectrogram;

/** A page with every kind of block, of simulated data: a softening oscillator of 5 Hz on a base that sweeps from 1 to 9 Hz. */
final class DemoPage {

    private static final double RATE = 60;
    private static final int SAMPLES = 18_000;

    private final double[] base = new double[SAMPLES];
    private final double[] head = new double[SAMPLES];
    private final double[] natural = new double[SAMPLES];

    private DemoPage() {
        Random random = new Random(20);
        double displacement = 0;
        double velocity = 0;
        for (int n = 0; n < SAMPLES; n++) {
            double t = n / RATE;
            natural[n] = t < 180 ? 5.1 : 4.4;
            double omega = 2 * Math.PI * natural[n];
            double phase = 2 * Math.PI * (t + 4 * t * t / 300);
            base[n] = (0.1 + 2.4 * t / 300) * Math.sin(phase) + 0.25 * random.nextGaussian();
            for (int k = 0; k < 8; k++) { // relative motion by small steps
                velocity += (-base[n] - 2 * 0.35 * omega * velocity - omega * omega * displacement) / (8 * RATE);
                displacement += velocity / (8 * RATE);
            }
            head[n] = -2 * 0.35 * omega * velocity - omega * omega * displacement + 0.05 * random.nextGaussian();
        }
        Arrays.fill(head, 7200, 7290, Double.NaN);
    }

    static Page page() {
        DemoPage demo = new DemoPage();
        return new Page("haul-road-07.csv", "Simulated recording, 300 s at 60 Hz, 10 sensors · demonstration of the report",
                List.of(demo.summary(), demo.histories(), demo.spectra(), demo.response(), demo.tracks(), demo.plane(),
                        demo.provenance()));
    }

    private Section summary() {
        return new Section("Summary", "What was read, what came out of it, and how far to trust it.",
                new Figures(Figure.measured("Natural frequency", 4.4123, 0.0211, "Hz"),
                        Figure.measured("Damping ratio", 0.3482, 0.0089, ""),
                        Figure.measured("Peak transmissibility", 1.812, 0.031, ""),
                        Figure.of("Duration", 300, "s"), Figure.of("Missing", 0.5, "%")),
                new Findings(List.of(
                        new Finding(Severity.FAULT, "head.acc.z has no samples from 120.0 s to 121.5 s (90 rows).",
                                "Segments that touch the gap are left out of every spectrum."),
                        new Finding(Severity.WARNING, "The natural frequency fell from 5.1 Hz to 4.4 Hz at 181 s.",
                                "A single frequency response mixes two bodies: look at the tracks."),
                        new Finding(Severity.NOTE, "No clipping, no duplicates, clock jitter below 0.1 ms.", "")),
                        "Nothing found."),
                new Table("Channels", List.of(Column.words("Channel"), Column.words("Sensor"), Column.numbers("Mean [m/s²]"),
                        Column.numbers("RMS [m/s²]"), Column.numbers("Peak [m/s²]"), Column.numbers("Missing [%]")),
                        List.of(List.of("platform.acc.z", "00B42235", "0.002", "0.912", "3.41", "0.0"),
                                List.of("head.acc.z", "00B42241", "−0.011", "1.204", "5.87", "0.5"))));
    }

    /** Points in the plane and bars: a spring that softens, whose law is known here. */
    private Section plane() {
        Random random = new Random(3);
        double[] deflection = new double[2500];
        double[] force = new double[deflection.length];
        for (int i = 0; i < deflection.length; i++) {
            deflection[i] = 2.2 * random.nextGaussian();
            force[i] = 60 * deflection[i] / Math.sqrt(1 + deflection[i] * deflection[i]) + 6 * random.nextGaussian();
        }
        double[] x = IntStream.rangeClosed(-30, 30).mapToDouble(i -> 0.25 * i).toArray();
        double[] y = Arrays.stream(x).map(r -> 60 * r / Math.sqrt(1 + r * r)).toArray();
        double[] poles = {0.2, 0.4, 0.3, 0.2};
        return new Section("Plane", "What is not drawn over time or frequency.", new Lead("The spring softens beyond 1 mm."),
                new Beside(
                        new XyChart("Spring force over deflection", ChartAxis.linear("Deflection", "mm"), ChartAxis.linear("Force", "N"),
                                List.of(
                                        new XySeries("samples", deflection, force, XySeries.Style.CLOUD),
                                        new XySeries("law", x, y, XySeries.Style.LINE),
                                        new XySeries("linear", new double[] {-1.5, 1.5}, new double[] {-90, 90}, XySeries.Style.DASHED))),
                        new XyChart("Where poles are allowed", ChartAxis.linear("Real part", ""), ChartAxis.linear("Imaginary part", ""),
                                List.of(
                                        new XySeries("region", new double[] {0.1, 0.5, 0.35, 0.1}, new double[] {0.5, 0.55, 0.8, 0.5},
                                                XySeries.Style.AREA),
                                        new XySeries("poles", poles, new double[] {0.55, 0.6, 0.7, 0.75},
                                                new double[] {0.02, 0.02, 0.03, 0.01}, XySeries.Style.POINTS, XySeries.BY_NAME)))),
                new BarChart("Error by channel", ChartAxis.linear("Error over signal", "%"), List.of("seat.acc.z", "head.acc.z"),
                        List.of(
                                new BarChart.Bars("before", new double[] {24.3, 18.1}, 1),
                                new BarChart.Bars("after", new double[] {1.5, 0.85}, 2)),
                        "Lower is better."));
    }

    private Section histories() {
        return new Section("Time histories", "Accelerations along z, gravity removed.",
                history("Platform", base), history("Head", head).shaded(List.of(new Shade(120, 121.5, "no samples"))));
    }

    private LineChart history(String name, double[] samples) {
        Envelope envelope = new Envelope(10_000);
        Arrays.stream(samples).forEach(envelope::accept);
        Series series = Series.envelope(name, envelope, 0, 1 / RATE);
        return new LineChart(name, ChartAxis.linear("Time", "s"), ChartAxis.linear("Acceleration", "m/s²"), List.of(series))
                .grouped("time");
    }

    private Section spectra() {
        Segmentation segmentation = new Segmentation(RATE, 512, 0.5);
        PowerSpectrum in = new PowerSpectrum(segmentation, Detrend.MEAN);
        PowerSpectrum out = new PowerSpectrum(segmentation, Detrend.MEAN);
        Spectrogram spectrogram = new Spectrogram(new Segmentation(RATE, 256, 0.75), Detrend.MEAN, 600);
        for (int n = 0; n < SAMPLES; n++) {
            in.accept(base[n]);
            out.accept(head[n]);
            spectrogram.accept(head[n]);
        }
        double[] f = segmentation.frequencies();
        double[] times = new double[spectrogram.columns()];
        double[][] values = new double[times.length][];
        for (int c = 0; c < times.length; c++) {
            times[c] = spectrogram.time(c);
            values[c] = spectrogram.decibels(c);
        }
        return new Section("Spectra", "Welch's method, Hann windows of 8.5 s overlapping by half.",
                new LineChart("Power spectral density", ChartAxis.log("Frequency", "Hz").within(0.5, 30),
                        ChartAxis.log("PSD", "(m/s²)²/Hz"), List.of(Series.line("platform.acc.z", f, in.density()),
                                Series.line("head.acc.z", f, out.density()))),
                new Heatmap("Spectrogram of head.acc.z", ChartAxis.linear("Time", "s"), ChartAxis.linear("Frequency", "Hz").within(0, 20),
                        ChartAxis.linear("PSD", "dB re 1 (m/s²)²/Hz"), times, spectrogram.segmentation().frequencies(), values)
                        .grouped("time").noted("Blank columns touch missing samples."));
    }

    private Section response() {
        CrossSpectrum spectrum = new CrossSpectrum(new Segmentation(RATE, 512, 0.5), Detrend.MEAN, 1);
        for (int n = 0; n < SAMPLES; n++) {
            spectrum.accept(base[n], head[n]);
        }
        FrequencyResponse response = spectrum.response(0, FrequencyResponse.Excited.USUAL);
        double[] f = response.frequency();
        double[] h1 = response.h1().magnitudes();
        double[] deviation = new double[f.length];
        double[] phase = response.h1().phases();
        double[] model = new double[f.length];
        double[] modelPhase = new double[f.length];
        for (int k = 0; k < f.length; k++) {
            double r = f[k] / 4.85;
            double c = 4 * 0.36 * 0.36 * r * r;
            model[k] = Math.sqrt((1 + c) / ((1 - r * r) * (1 - r * r) + c));
            modelPhase[k] = Math.toDegrees(Math.atan(Math.sqrt(c)) - Math.atan2(Math.sqrt(c), 1 - r * r));
            deviation[k] = h1[k] * response.error()[k];
            phase[k] = Math.toDegrees(phase[k]);
        }
        ChartAxis frequency = ChartAxis.log("Frequency", "Hz").within(0.5, 20);
        LineChart modulus = new LineChart("Transmissibility, platform to head", frequency, ChartAxis.linear("|H|", ""),
                List.of(Series.line("H1", f, h1).with(Band.deviations(h1, deviation, 2, "±2σ")),
                        Series.line("Hv", f, response.hv().magnitudes()), Series.dashed("Estimator's model", f, model)))
                .marked(List.of(new Marker(4.85, "natural frequency 4.85 Hz")));
        LineChart angle = new LineChart("Phase", frequency, ChartAxis.linear("Phase", "°"),
                List.of(Series.line("H1", f, phase), Series.dashed("Estimator's model", f, modelPhase)));
        LineChart coherence = new LineChart("Coherence", frequency, ChartAxis.linear("γ²", "").within(0, 1),
                List.of(Series.line("γ²", f, response.coherence())));
        List<Block> charts = new ArrayList<>();
        for (LineChart chart : List.of(modulus, angle, coherence)) {
            charts.add(chart.shadedUnless(response.usable(), f, "coherence below 0.7").grouped("frequency"));
        }
        return new Section("Frequency response", "Shaded frequencies are not excited well enough to be believed.", charts);
    }

    private Section tracks() {
        int count = 1500;
        double[] t = new double[count];
        double[][] values = new double[4][count];
        Random random = new Random(5);
        double frequency = 3.2;
        double damping = 0.2;
        for (int i = 0; i < count; i++) {
            t[i] = i * 0.2;
            frequency += 0.03 * (natural[(int) (t[i] * RATE)] - frequency) + 0.01 * random.nextGaussian();
            damping += 0.03 * (0.35 - damping) + 0.002 * random.nextGaussian();
            double since = t[i] < 181 ? t[i] : t[i] - 181;
            values[0][i] = frequency;
            values[1][i] = 0.04 + 3 * Math.exp(-since / 6);
            values[2][i] = damping;
            values[3][i] = 0.012 + 0.4 * Math.exp(-since / 6);
        }
        List<Marker> cuts = List.of(new Marker(12.4, "cut"), new Marker(18.1, "cut"), new Marker(181.2, "cut"));
        ChartAxis time = ChartAxis.linear("Time", "s");
        return new Section("Body over time", "The estimator's natural frequency and damping; vertical lines are ADWIN's cuts.",
                new LineChart("Natural frequency", time, ChartAxis.linear("f₀", "Hz"), List.of(Series.line("f₀", t, values[0])
                        .with(Band.deviations(values[0], values[1], 2, "±2σ")))).marked(cuts).grouped("time"),
                new LineChart("Damping ratio", time, ChartAxis.linear("ζ", ""), List.of(Series.line("ζ", t, values[2])
                        .with(Band.deviations(values[2], values[3], 2, "±2σ")))).marked(cuts).grouped("time"));
    }

    private Section provenance() {
        return new Section("Provenance", "", new Table("", List.of(Column.words("What"), Column.words("Value")), List.of(
                List.of("Input", "haul-road-07.csv"),
                List.of("SHA-256", "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"),
                List.of("Seed", "1"))),
                new Code("The same as a MOA task", "EvaluatePrequentialRegression -l (wbv.learn.AdwinKalman -w 0.002) "
                        + "-s (wbv.stream.RecordingStream -f haul-road-07.csv) -f 600"));
    }
}
