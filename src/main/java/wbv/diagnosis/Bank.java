package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import wbv.body.Assembly;
import wbv.body.AsymmetricSpring;
import wbv.body.Backlash;
import wbv.body.BendingSpring;
import wbv.body.BoucWen;
import wbv.body.BristleFriction;
import wbv.body.BumpStop;
import wbv.body.ContactLoss;
import wbv.body.CoulombFriction;
import wbv.body.CubicSpring;
import wbv.body.Drive;
import wbv.body.HertzStop;
import wbv.body.Law;
import wbv.body.MaxwellArm;
import wbv.body.Model;
import wbv.body.Numbers;
import wbv.body.ProgressiveSpring;
import wbv.body.QuadraticDamping;
import wbv.body.QuadraticSpring;
import wbv.body.Reflex;
import wbv.body.RoundedBacklash;
import wbv.body.RoundedContactLoss;
import wbv.body.SaturatingSpring;
import wbv.body.SensorFault;
import wbv.body.Settling;
import wbv.body.SlowDrift;
import wbv.body.StepChange;
import wbv.body.Structure;
import wbv.diagnosis.Hypothesis.Addition;
import wbv.diagnosis.Hypothesis.Number;
import wbv.diagnosis.Hypothesis.Start;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/**
 * Every mechanism of the library at every place where it makes sense, with bounds and starting points scaled to the motion.
 */
final class Bank {

    /** The least time in which a slow drift settles [s]: what a link loses in the first moments of motion is no drift. */
    private static final double SLOWLY = 12;

    /** At most so many moments at which a link may change are tried. */
    private static final int MOMENTS = 60;

    private final Evidence evidence;
    private final Assembly fitted;
    private final Motion motion;
    private final double[] lines;
    private final int fitEnd;
    private final List<Hypothesis> all = new ArrayList<>();

    /** @param fitted the baseline as fitted @param lines frequencies at which the residual stands out [Hz] */
    Bank(Evidence evidence, Assembly fitted, Motion motion, double[] lines) {
        this.evidence = evidence;
        this.fitted = fitted;
        this.motion = motion;
        this.lines = lines;
        double step = evidence.excitation().fineStep();
        this.fitEnd = (int) ((evidence.fit().start() + evidence.fit().length()) / evidence.recording().clock().rate() / step);
        for (int l = 0; l < evidence.model().links().size(); l++) {
            addLink(l);
        }
        for (int b = 0; b < evidence.model().bodies().size(); b++) {
            addBody(b);
        }
        for (int o = 0; o < evidence.outputs().size(); o++) {
            addSensor(o);
        }
    }

    List<Hypothesis> hypotheses() {
        return all;
    }

    private void addLink(int l) {
        Structure s = fitted.structure();
        double[] r = motion.displacement(l);
        double[] v = motion.velocity(l);
        double rms = Motion.rms(r, fitEnd);
        double speed = Motion.rms(v, fitEnd);
        // What a link was given without is no scale; a link of neither holds nothing that could be another law.
        double k = s.stiffness()[l] > 0 ? s.stiffness()[l] : s.damping()[l] * speed / rms;
        double c = s.damping()[l] > 0 ? s.damping()[l] : Baseline.USUAL_LOSS * k * rms / speed;
        double last = fitEnd * evidence.excitation().fineStep();
        String where = evidence.model().links().get(l).name();
        if (!(k > 0)) {
            addCoupling(l, where);
            return;
        }
        law(l, where, "", new SaturatingSpring(rms), List.of(factor(5e-5, 5e-2)),
                grid(new double[] {0.25, 0.6, 1.5, 4}, q -> fixed(q * rms)));
        double soft = 0.1 * k / (rms * rms);
        law(l, where, "", new CubicSpring(soft), List.of(sum(soft, 0, 30e6 * k)), List.of(scaled(soft)));
        law(l, where, "knee", new ProgressiveSpring(0.2 * k, rms), List.of(sum(0.2 * k, 0, 60 * k), factor(0.02 * rms, 20 * rms)),
                grid(new double[] {0.3, 1, 3}, q -> start(new double[] {0.2 * k, q * rms}, new int[] {0})));
        law(l, where, "", new AsymmetricSpring(0.1), List.of(sum(0.1, -0.97, 12)), List.of(scaled(0.1)));
        law(l, where, "round", new BendingSpring(0.1, rms), List.of(sum(0.1, -0.97, 12), factor(0.01 * rms, 20 * rms)),
                grid(new double[] {0.3, 1}, q -> start(new double[] {0.1, q * rms}, new int[] {0})));
        double bent = 0.1 * k / rms;
        law(l, where, "bent", new QuadraticSpring(bent), List.of(sum(bent, -300 * bent, 300 * bent)), List.of(scaled(bent)));
        double c2 = 0.1 * c / 0.03;
        law(l, where, "", new QuadraticDamping(c2), List.of(sum(c2, 0, 300 * c2)), List.of(scaled(c2)));
        law(l, where, "", new CoulombFriction(1, 1e-3), List.of(sum(1, 0, 300), factor(2e-5, 2e-2)),
                grid(new double[] {0.02, 0.15}, q -> start(new double[] {1, Math.max(3e-4, q * speed)}, new int[] {0})));
        law(l, where, "bristles", new BristleFriction(1, 1.05, 0.01, 1 / (0.2 * rms)), List.of(sum(1, 1e-3, 300), sum(1, 1e-3, 400),
                factor(1e-3, 0.1), factor(0.02 / rms, 2e4 / rms)), grid(new double[] {0.1, 0.5},
                    q -> start(new double[] {1, 1.05, 0.01, 1 / (q * rms)}, new int[] {0, 1, 3})));
        law(l, where, "", new BoucWen(0.1, rms), List.of(sum(0.1, 0, 1), factor(3e-5, 2e-2)),
                grid(new double[] {0.2, 0.7, 2}, q -> start(new double[] {0.1, q * rms}, new int[] {0})));
        double[] pull = new double[r.length];
        for (int i = 0; i < pull.length; i++) {
            pull[i] = k * r[i] + c * v[i];
        }
        double[] force = Motion.sorted(pull, fitEnd);
        law(l, where, "", new ContactLoss(100), List.of(factor(0.5, 1000)),
                Stream.concat(grid(new double[] {0.65, 0.85, 0.95, 0.99}, q -> fixed(Math.max(0.5, Motion.quantile(force, q)))).stream(),
                        DoubleStream.of(0.4, 0.6, 0.8, 0.95).mapToObj(q -> fixed(Math.max(0.5, q * Motion.quantile(force, 1))))).toList());
        law(l, where, "rounded", new RoundedContactLoss(100, 10), List.of(factor(0.5, 1000), factor(0.05, 300)),
                grid(new double[] {0.65, 0.85, 0.95, 0.99}, q -> {
                    double preload = Math.max(0.5, Motion.quantile(force, q));
                    return fixed(preload, 0.1 * preload);
                }));
        for (Law.Side side : Law.Side.values()) {
            double[] towards = Motion.sorted(Arrays.stream(r)
                    .map(x -> side == Law.Side.COMPRESSION ? -x : side == Law.Side.EXTENSION ? x : Math.abs(x)).toArray(), fitEnd);
            double[] shares = side == Law.Side.BOTH ? new double[] {0.3, 0.6, 0.85, 0.97} : new double[] {0.55, 0.75, 0.9, 0.98};
            law(l, where, side.name().toLowerCase(java.util.Locale.ROOT), new BumpStop(0.2 * k, rms, side),
                    List.of(sum(0.2 * k, 1e-6 * k, 40 * k), factor(2e-5, 2e-2)), grid(shares, q -> start(new double[] {0.2 * k,
                        Math.max(2.1e-5, Motion.quantile(towards, q))}, new int[] {0})));
            if (side == Law.Side.COMPRESSION) {
                double hertz = 0.5 * k / Math.sqrt(rms);
                law(l, where, "hertz", new HertzStop(hertz, rms, side), List.of(sum(hertz, 1e-6 * hertz, 100 * hertz), factor(1e-6, 2e-2)),
                        grid(new double[] {0.5, 0.8}, q -> start(new double[] {hertz, Math.max(2.1e-5, Motion.quantile(towards, q))},
                                new int[] {0})));
            }
        }
        law(l, where, "", new Backlash(rms), List.of(factor(1e-5, 1e-2)), grid(new double[] {0.05, 0.2, 0.6}, q -> fixed(q * rms)));
        law(l, where, "rounded", new RoundedBacklash(rms, 0.5 * rms, 0.3), List.of(factor(1e-5, 1e-2), factor(0.01 * rms, 3 * rms), sum(0.3, 0, 1)),
                grid(new double[] {0.1, 0.4, 0.8}, q -> fixed(q * rms, 0.5 * q * rms, 0.3)));
        List<Start> times = new ArrayList<>();
        for (double t = 5; t < last - 4; t += Math.max(2.5, last / MOMENTS)) {
            times.add(start(new double[] {t, 0.1, 0.1}, new int[] {1, 2}));
        }
        law(l, where, "", new StepChange(last / 2, 1.1, 1.1), List.of(sum(1, 4, last - 3), sum(0.1, 0.05, 6), sum(0.1, 0.05, 6)), times);
        law(l, where, "", new SlowDrift(0.1, 0, 1), List.of(sum(0.1, -3, 12), sum(0.1, -4, 12), sum(0.2, 0, 2)),
                List.of(start(new double[] {0.1, 0, 1}, new int[] {0})));
        law(l, where, "settling", new Settling(0.1, 30, 1), List.of(sum(0.1, -0.97, 12), factor(SLOWLY, 500), sum(0.2, 0, 2)),
                grid(new double[] {15, 35, 80}, q -> start(new double[] {0.1, q, 1}, new int[] {0})));
        law(l, where, "", new MaxwellArm(0.1 * k, 0.05), List.of(factor(1e-3 * k, 20 * k), factor(0.003, 3)),
                grid(new double[] {0.015, 0.05, 0.2}, t -> start(new double[] {0.1 * k, t}, new int[] {0})));
        law(l, where, "", new Reflex(0.05 * k, 0.05 * c, 0.1), List.of(sum(0.05 * k, -3 * k, 3 * k), sum(0.05 * c, -3 * c, 3 * c),
                factor(0.02, 0.4)), grid(new double[] {0.05, 0.1, 0.18}, t -> start(new double[] {0.05 * k, 0.05 * c, t}, new int[] {0},
                    new int[] {1})));
        addCoupling(l, where);
    }

    /** Hysteresis of a spring that gives way in two stages. @param share of its stiffness that yields @param yield deflection at which [m] */
    Hypothesis twoStages(int l, double share, double yield) {
        List<Number> numbers = new ArrayList<>();
        for (String stage : List.of("first", "second")) {
            numbers.add(new Number(stage + "_share", 0.1, 0, 1));
            numbers.add(new Number(stage + "_yield_m", 0, 3e-5, 2e-2));
        }
        return new Hypothesis("hysteresis", evidence.model().links().get(l).name(), "two stages",
                List.of(new Addition.InLink(l, new BoucWen(0.1, yield)), new Addition.InLink(l, new BoucWen(0.1, yield))), numbers,
                List.of(fixed(share / 2, yield / 2, share / 2, 2 * yield), fixed(0.7 * share, yield, 0.3 * share, 5 * yield),
                        fixed(0.3 * share, 0.3 * yield, 0.7 * share, 1.5 * yield)));
    }

    private void addCoupling(int l, String where) {
        Model model = evidence.model();
        String lower = place(model.links().get(l).from());
        String upper = place(model.links().get(l).to());
        List<Channel> rates = evidence.companions(lower.isEmpty() ? place(model.base().name()) : lower, Quantity.ANGULAR_RATE).stream()
                .sorted((a, b) -> b.axis() - a.axis()).toList();
        if (!rates.isEmpty()) {
            List<Addition> drives = new ArrayList<>();
            List<Number> numbers = new ArrayList<>();
            double[] values = new double[rates.size()];
            int[][] columns = new int[rates.size()][];
            for (int i = 0; i < rates.size(); i++) {
                drives.add(new Addition.Driven(l, new Drive.Rotation(rates.get(i), 0.02)));
                numbers.add(new Number("lever_arm_m on " + rates.get(i), 0.02, -1, 1));
                values[i] = 0.02;
                columns[i] = new int[] {i};
            }
            all.add(new Hypothesis("coupling.rotation", where, "", drives, numbers, List.of(start(values, columns))));
        }
        for (Channel across : evidence.companions(upper, Quantity.ACCELERATION)) {
            Channel below = new Channel(lower.isEmpty() ? across.location() : lower, Quantity.ACCELERATION, across.axis());
            if (!lower.isEmpty() && evidence.recording().has(below)) {
                double unit = 1000;
                all.add(new Hypothesis("coupling.axis", where, String.valueOf(across.axis()),
                        List.of(new Addition.Driven(l, new Drive.CrossAxis(across, below, unit))),
                        List.of(new Number("cross_stiffness_N_per_m", unit, -1e6, 1e6)), List.of(start(new double[] {unit}, new int[] {0}))));
            }
        }
        addPush(l, false, where, upper);
    }

    /** Acceleration across as a force, in a link or on a body: of what is measured at the base and at the place itself. */
    private void addPush(int at, boolean onBody, String where, String location) {
        Set<Channel> across = new LinkedHashSet<>(evidence.companions(place(evidence.model().base().name()), Quantity.ACCELERATION));
        across.addAll(evidence.companions(location, Quantity.ACCELERATION));
        for (Channel channel : across) {
            all.add(new Hypothesis("coupling.axis", where, "push " + channel,
                    List.of(new Addition.Driven(at, onBody ? new Drive.AcrossBody(channel, 1) : new Drive.AcrossLink(channel, 1))),
                    List.of(new Number("coupled_mass_kg", 1, -200, 200)), List.of(scaled(1))));
        }
    }

    /** The location of the sensor on a body or base; empty where there is none. */
    private String place(String body) {
        Model model = evidence.model();
        Optional<Channel> sensor = body.equals(model.base().name()) ? model.base().sensor() : model.bodies().get(model.index(body)).sensor();
        return sensor.map(Channel::location).orElse("");
    }

    private void addBody(int b) {
        Structure s = fitted.structure();
        String where = evidence.model().bodies().get(b).name();
        double total = Arrays.stream(s.mass()).sum();
        List<Start> starts = new ArrayList<>();
        for (double f : new double[] {3, 4.5, 6, 8, 11}) {
            starts.add(hidden(0.006 * total, f, 0.12));
        }
        if (new Place(Place.Kind.BODY, b).plain(fitted).kind() == Place.Kind.BODY) {   // on the base its link feels the same
            addPush(b, true, where, place(where));
        }
        double[] low = hidden(0.05, 1.2, 0.005).values();
        double[] high = hidden(40, 22, 1.2).values();
        all.add(new Hypothesis("mode.hidden", where, "", List.of(new Addition.Hidden(b, new Model.HiddenMode(0.006 * total, 5, 0.12))),
                List.of(new Number("mass_kg", 0, low[0], high[0]), new Number("stiffness_N_per_m", 0, low[1], high[1]),
                        new Number("damping_Ns_per_m", 0, low[2], high[2])), starts));
        if (lines.length > 0) {
            // Within half a line of its peak a tone's phase still runs away over the record: quarters of a line are near enough.
            List<Start> tones = Arrays.stream(lines).boxed().flatMap(f -> DoubleStream.of(0, -0.25, 0.25, -0.5, 0.5)
                    .mapToObj(q -> start(new double[] {1, 1, f + q * evidence.fit().spacing()}, new int[] {0}, new int[] {1}))).toList();
            all.add(new Hypothesis("input.unmeasured", where, "", List.of(new Addition.Driven(b, new Drive.Tone(1, 1, lines[0]))),
                    List.of(new Number("cosine_N", 1, -300, 300), new Number("sine_N", 1, -300, 300),
                            new Number("frequency_hz", 0.01, 0.4, 20)), tones));
        }
    }

    private static Start hidden(double mass, double frequency, double damping) {
        Model.HiddenMode mode = new Model.HiddenMode(mass, frequency, damping);
        return start(new double[] {mass, mode.stiffness(), mode.damping()}, new int[] {0, 1, 2});
    }

    private void addSensor(int o) {
        Channel channel = evidence.outputs().get(o);
        String where = channel.toString();
        sensor(o, where, new SensorFault.MountResonance(10, 0.3), List.of(factor(2.5, 60), factor(0.01, 2)),
                grid(new double[] {6, 10, 18}, f -> fixed(f, 0.3)));
        sensor(o, where, new SensorFault.Delay(0.004, 0), List.of(sum(0.001, -0.2, 0.3), sum(1e-5, -1e-9, 1e-9)),
                Stream.concat(Stream.of(start(new double[] {0.004, 0}, new int[] {0})),
                        DoubleStream.of(-0.05, 0.02, 0.05, 0.08, 0.12, 0.2).mapToObj(late -> fixed(late, 0))).toList());
        sensor(o, where, new SensorFault.Delay(0, 1e-5), List.of(sum(0.001, -0.2, 0.3), sum(1e-5, -0.005, 0.005)),
                List.of(start(new double[] {0, 1e-5}, new int[] {1})));
        sensor(o, where, new SensorFault.Gain(1.02), List.of(sum(0.01, 0.3, 3)), List.of(start(new double[] {1.02}, new int[] {0})));
        boolean accelerometer = channel.quantity() == Quantity.ACCELERATION;
        List<Channel> across = accelerometer ? evidence.companions(channel.location(), Quantity.ACCELERATION) : List.of();
        if (across.size() == 2) {
            sensor(o, where, new SensorFault.Misalignment(across.get(0), across.get(1), 0.02, 0.02), List.of(sum(0.02, -0.9, 0.9),
                    sum(0.02, -0.9, 0.9)), List.of(start(new double[] {0.02, 0.02}, new int[] {0}, new int[] {1})));
        }
        List<Channel> rates = accelerometer ? evidence.companions(channel.location(), Quantity.ANGULAR_RATE) : List.of();
        if (!rates.isEmpty()) {
            double[] arms = new double[rates.size()];
            int[][] columns = new int[rates.size()][];
            List<Addition> faults = new ArrayList<>();
            List<Number> numbers = new ArrayList<>();
            for (int i = 0; i < arms.length; i++) {
                arms[i] = 0.02;
                columns[i] = new int[] {i};
                faults.add(new Addition.AtSensor(o, new SensorFault.LeverArm(rates.get(i), 0.02)));
                numbers.add(new Number("lever_arm_m on " + rates.get(i), 0.02, -1, 1));
            }
            all.add(new Hypothesis("coupling.rotation", where, "", faults, numbers, List.of(start(arms, columns))));
        }
        double[] y = evidence.measured(o);
        double top = Arrays.stream(y).max().orElse(1);
        double bottom = Arrays.stream(y).min().orElse(-1);
        List<Start> levels = new ArrayList<>(grid(new double[] {0.98, 0.9, 0.8}, q -> fixed(q * bottom, q * top)));
        levels.add(fixed(10 * bottom, 0.9 * top));
        levels.add(fixed(0.9 * bottom, 10 * top));
        sensor(o, where, new SensorFault.Clipping(bottom, top), List.of(factor(0.01 * bottom, 40 * bottom), factor(0.01 * top, 40 * top)), levels);
    }

    private void law(int link, String where, String form, Law law, List<Number> bounds, List<Start> starts) {
        all.add(new Hypothesis(law.mechanism(), where, form, List.of(new Addition.InLink(link, law)), named(law.getClass(), bounds), starts));
    }

    private void sensor(int output, String where, SensorFault fault, List<Number> bounds, List<Start> starts) {
        all.add(new Hypothesis(fault.mechanism(), where, "", List.of(new Addition.AtSensor(output, fault)), named(fault.getClass(), bounds), starts));
    }

    /** The numbers of a record by its keys, with bounds given in order. */
    static List<Number> named(Class<?> type, List<Number> bounds) {
        List<String> keys = Numbers.keys(type);
        List<Number> out = new ArrayList<>();
        for (int i = 0; i < keys.size(); i++) {
            Number b = bounds.get(i);
            out.add(new Number(keys.get(i), b.unit(), b.low(), b.high()));
        }
        return out;
    }

    static Number factor(double low, double high) {
        return new Number("", 0, low, high);
    }

    static Number sum(double unit, double low, double high) {
        return new Number("", unit, low, high);
    }

    static Start fixed(double... values) {
        return new Start(values, List.of());
    }

    static Start scaled(double value) {
        return start(new double[] {value}, new int[] {0});
    }

    static Start start(double[] values, int[]... columns) {
        return new Start(values, List.of(columns));
    }

    static List<Start> grid(double[] at, java.util.function.DoubleFunction<Start> make) {
        return Arrays.stream(at).mapToObj(make).toList();
    }
}
