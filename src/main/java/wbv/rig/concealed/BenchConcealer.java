package wbv.rig.concealed;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.DoubleFunction;
import java.util.function.UnaryOperator;
import org.apache.commons.math3.random.RandomGenerator;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.rig.platform.Seeds;

/** Makes recordings of a {@link Bench} in which something is concealed: one, or three at three levels. */
final class BenchConcealer {

    /** Levels over the usual one, in no order. */
    private static final double[] LEVELS = {0.45, 1, 2.2};
    /**
     * Noise of the force on a free mass over that of a sensor: it is what was commanded. A measured one's noise, integrated twice, would
     * carry the mass a hundred times as far as its sensor's noise says, and no model could follow.
     */
    private static final double COMMANDED = 0.01;
    /** More than this many times as lively as the linear one is another bench. */
    private static final double WILD = 9;

    /**
     * What is concealed, and what it does.
     *
     * @param change to the bench
     * @param faulty body whose sensor is at fault, -1 for none
     * @param fault of a series
     */
    private record Hidden(Omission omission, Consumer<Setup> change, int faulty, UnaryOperator<double[]> fault) {}

    /**
     * As sized.
     *
     * @param left missed variance over that of the output, of each
     */
    private record Sized(Hidden hidden, double share, double[] left) {}

    private final ConcealedSpec spec;
    private final Seeds seeds;
    private final Bench bench;
    private final Acquisition acquisition;
    private final double[] drive;
    private final ChainPlant.Trace calm;

    private BenchConcealer(ConcealedSpec spec) {
        this.spec = spec;
        seeds = new Seeds(spec.seed());
        bench = Bench.draw(kind(spec.words()), spec.setting() == Setting.BENCH_LEVELS, seeds.source("bench"));
        acquisition = bench.acquisition();
        drive = bench.drive(1, seeds.source("drive 1"));
        calm = bench.run(bench.setup(drive), drive, false);
    }

    static ConcealedCase make(ConcealedSpec spec) {
        return new BenchConcealer(spec).make();
    }

    /** A gain shows only against a base that was measured alike; what bends a spring needs one. */
    private static Bench.Kind kind(List<String> words) {
        return words.isEmpty() || List.of("friction.coulomb", "damping.quadratic").contains(words.get(0)) ? Bench.Kind.ANY
                : words.contains("sensor.gain") ? Bench.Kind.SHAKEN : Bench.Kind.HELD;
    }

    private ConcealedCase make() {
        Optional<Sized> sized = spec.words().stream().findFirst().map(this::sized);
        int[] order = spec.setting() == Setting.BENCH_LEVELS ? shuffled(seeds.source("order")) : new int[] {1};
        Recording[] sent = new Recording[order.length];
        Recording clean = null;
        Optional<String> force = Optional.empty();
        for (int i = 0; i < order.length; i++) {
            double level = LEVELS[order[i]];
            double[] own = level == 1 ? drive : bench.drive(level, seeds.source("drive " + level));
            Setup setup = bench.setup(own);
            sized.ifPresent(each -> each.hidden().change().accept(setup));
            ChainPlant.Trace trace = bench.run(setup, own, true);
            sent[i] = recording(own, trace, sized, true, level);
            if (i == 0) {
                clean = recording(own, trace, sized, false, level);
                force = spec.isOpen() ? Optional.of(force(sized.orElseThrow().hidden().omission().where(), trace)) : Optional.empty();
            }
        }
        Chain values = Concealer.user(bench.chain(), spec.exact(), seeds.source("user"));
        String model = bench.json("case " + spec.name(), values).toPrettyString() + "\n";
        Map<String, Recording> beside = order.length == 1 ? Map.of() : Map.of(ConcealedCase.WITH, sent[1], ConcealedCase.PROOF, sent[2]);
        return new ConcealedCase(sent[0], clean, model, key(sized, order, force).toPrettyString() + "\n", force, beside);
    }

    private Sized sized(String word) {
        RandomGenerator random = seeds.source("omissions");
        double wanted = Concealer.share(spec, random);
        int body = random.nextInt(bench.chain().size());
        double[] rows = acquisition.rows(drive);
        double[] left = fitted(rows, calm, new Hidden(Omission.told("", "", "", Map.of(), List.of()), setup -> {}, -1, x -> x));
        if (word.startsWith("sensor.")) {
            return fault(word, body, wanted, rows, left);
        }
        CoordinateLaw law = CoordinateLaw.of(word, coordinate(body), random);
        return OmissionSize.sized(law.least(), law.most(), wanted, size -> look(new Hidden(law.told(bench.link(body), size),
                setup -> setup.link(body, h -> law.physics().apply(size).apply(h)), -1, x -> x), rows, left), Sized::share);
    }

    private Coordinate coordinate(int link) {
        double speed = UniformSeries.rms(calm.rate()[link]);
        return bench.isFree()
                ? new Coordinate(0, bench.chain().damping()[0], speed / (2 * Math.PI * bench.first()), speed, UniformSeries.rms(drive),
                        false, bench.seconds())
                : new Coordinate(bench.chain().stiffness()[link], bench.chain().damping()[link], UniformSeries.rms(calm.extension()[link]),
                        speed, UniformSeries.rms(calm.force()[link]), false, bench.seconds());
    }

    private Sized fault(String word, int body, double wanted, double[] rows, double[] left) {
        String channel = bench.output(body).toString();
        double usual = UniformSeries.rms(bench.felt(calm, body, bench.quantity()));
        double f = bench.first();
        return switch (word) {
            case "sensor.delay" -> fault(word, channel, body, "late", "delay_s", 1e-3 / f, 0.3 / f, size -> x -> acquisition.late(x, size),
                    wanted, rows, left);
            case "sensor.gain" -> fault(word, channel, body, "constant", "factor_less_one", 0.01, 0.6,
                    size -> x -> UniformSeries.scaled(x, 1 + size), wanted, rows, left);
            case "sensor.ac-coupled" ->
                fault(word, channel, body, "first-order high-pass", "corner_hz", 0.003 * f, 0.6 * f, size -> x -> highPass(x, size), wanted,
                        rows, left);
            case "sensor.clipping" -> fault(word, channel, body, "both sides", "usual_over_limit", 0.3, 3,
                    size -> x -> Arrays.stream(x).map(each -> Math.max(-usual / size, Math.min(usual / size, each))).toArray(), wanted,
                    rows, left);
            default -> throw new IllegalArgumentException("no bench's sensor can have '" + word + "'");
        };
    }

    private Sized fault(String word, String channel, int body, String form, String parameter, double least, double most,
            DoubleFunction<UnaryOperator<double[]>> fault, double wanted, double[] rows, double[] left) {
        return OmissionSize.sized(least, most, wanted,
                size -> look(new Hidden(Omission.told(word, channel, form, Map.of(parameter, size), List.of()), setup -> {},
                        body, fault.apply(size)), rows, left),
                Sized::share);
    }

    /**
     * A capacitor and a resistor, by the bilinear transform.
     *
     * @param corner [Hz]
     */
    private double[] highPass(double[] x, double corner) {
        double w = Math.tan(Math.PI * corner / acquisition.fine());
        double[] out = new double[x.length];
        double before = x[0];
        double y = 0;
        for (int i = 0; i < x.length; i++) {
            y = ((1 - w) * y + x[i] - before) / (1 + w);
            before = x[i];
            out[i] = y;
        }
        return out;
    }

    /** @param calm what is left of the linear bench, where leakage has its part */
    private Sized look(Hidden hidden, double[] rows, double[] calm) {
        Setup setup = bench.setup(drive);
        hidden.change().accept(setup);
        ChainPlant.Trace trace = hidden.faulty() < 0 ? bench.run(setup, drive, false) : this.calm;
        for (int i = 0; i < bench.chain().size(); i++) {
            double lively = UniformSeries.rms(trace.rate()[i]) / UniformSeries.rms(this.calm.rate()[i]);
            if (!(lively * lively < WILD)) {
                return new Sized(hidden, Double.MAX_VALUE, calm);
            }
        }
        double[] left = fitted(rows, trace, hidden);
        double worst = 1e-12;
        for (int i = 0; i < left.length; i++) {
            left[i] = Math.max(0, left[i] - calm[i]);
            worst = Math.max(worst, left[i]);
        }
        return new Sized(hidden, worst, left);
    }

    /** Part of each output's variance that the best linear bench leaves. */
    private double[] fitted(double[] rows, ChainPlant.Trace trace, Hidden hidden) {
        double[][] outputs = new double[bench.chain().size()][];
        for (int i = 0; i < outputs.length; i++) {
            double[] felt = bench.felt(trace, i, bench.sized());
            outputs[i] = acquisition.rows(hidden.faulty() == i ? hidden.fault().apply(felt) : felt);
        }
        return bench.fit(rows, outputs).left(bench.chain());
    }

    /**
     * Gains and clocks stay what they are from one recording to the next, noise does not.
     *
     * @param noisy whether as real sensors send
     */
    private Recording recording(double[] drive, ChainPlant.Trace trace, Optional<Sized> sized, boolean noisy, double level) {
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        List<Channel> all = bench.channels();
        for (int i = 0; i < all.size(); i++) {
            RandomGenerator mounted = seeds.source("sensor " + i);
            RandomGenerator random = seeds.source("noise " + i + " " + level);
            int body = i - 1;
            double[] felt = i == 0 ? drive : bench.felt(trace, body, bench.quantity());
            double gain = 1 + spec.setting().gain * mounted.nextGaussian();
            double late = spec.setting().clock / bench.rate() * mounted.nextGaussian();
            if (noisy) {
                felt = acquisition.late(UniformSeries.scaled(felt, gain), late);
            }
            double[] rows = acquisition.rows(
                    i > 0 && sized.isPresent() && sized.get().hidden().faulty() == body ? sized.get().hidden().fault().apply(felt) : felt);
            // What a sensor's range allows: as fine as at the usual level.
            double sd = bench.noise() * spec.setting().noise * (i > 0 ? UniformSeries.rms(bench.felt(calm, body, bench.quantity()))
                    : bench.strength() * (bench.isFree() ? COMMANDED : 1));
            if (noisy) {
                Arrays.setAll(rows, s -> Math.rint((rows[s] + sd * random.nextGaussian()) / (sd / 20)) * (sd / 20) + 0.0);
            }
            channels.put(all.get(i), rows);
        }
        return Concealer.recording(channels, bench.rate());
    }

    /** By row: what the link carries less its linear part, its extension and rate. */
    private String force(String where, ChainPlant.Trace trace) {
        int link = 0;
        while (!bench.link(link).equals(where)) {
            link++;
        }
        double[] r = trace.extension()[link];
        double[] v = trace.rate()[link];
        double[] f = trace.force()[link].clone();
        for (int s = 0; s < f.length; s++) {
            f[s] -= bench.chain().stiffness()[link] * r[s] + bench.chain().damping()[link] * v[s];
        }
        double[] force = acquisition.rows(f);
        double[] extension = acquisition.rows(r);
        double[] rate = acquisition.rows(v);
        StringBuilder out = new StringBuilder(ConcealedForce.HEAD);
        for (int i = 0; i < force.length; i++) {
            out.append(String.format(Locale.ROOT, "%.9g,%.6g,%.6g,%.6g\n", i / bench.rate(), force[i], extension[i], rate[i]));
        }
        return out.toString();
    }

    private ObjectNode key(Optional<Sized> sized, int[] order, Optional<String> force) {
        ObjectNode root = new ObjectMapper().createObjectNode();
        root.put("case", spec.name());
        root.putArray("mechanisms");
        double excess = 0;
        if (sized.isPresent()) {
            ObjectNode one = root.withArray("mechanisms").addObject();
            ConcealedKey.write(sized.get().hidden().omission(), one);
            // Input and output have the same noise over what they measure.
            excess = Arrays.stream(sized.get().left()).average().orElse(0) / (2 * bench.noise() * bench.noise());
            one.put("share", Chain.rounded(sized.get().share())).put("linear_chi2", Chain.rounded(1 + excess));
        }
        root.put("strength", spec.strength()).put("setting", spec.setting().word()).put("exact_model", spec.exact());
        root.put("linear_chi2", Chain.rounded(1 + excess));
        root.set("true_linear_model", bench.json("true linear part", bench.chain()));
        root.put("first_resonance_hz", Chain.rounded(bench.first())).put("rate_hz", bench.rate()).put("seconds",
                Chain.rounded(bench.seconds()));
        root.put("free", bench.isFree()).put("sweeps", bench.sweeps()).put("noise_over_signal", Chain.rounded(bench.noise()));
        root.putArray("force_band_hz").add(Chain.rounded(bench.low())).add(Chain.rounded(bench.high()));
        if (order.length > 1) {
            Arrays.stream(order).forEach(i -> root.withArray("levels").add(LEVELS[i]));
        }
        root.put("seed", spec.seed());
        force.ifPresent(text -> root.put("force_sha256", ConcealedForce.digest(text)));
        return root;
    }

    private static int[] shuffled(RandomGenerator random) {
        int[] out = {0, 1, 2};
        for (int i = 2; i > 0; i--) {
            int j = random.nextInt(i + 1);
            int keep = out[i];
            out[i] = out[j];
            out[j] = keep;
        }
        return out;
    }
}
