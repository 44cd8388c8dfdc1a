package wbv.rig.concealed;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.DoubleFunction;
import org.apache.commons.math3.random.RandomGenerator;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.Recording;
import wbv.rig.platform.Seeds;

/**
 * Makes the recording of a {@link PlanarPerson} in whom something is concealed, and what his user's own simulator gave for the recorded
 * platform: the same person without it, exact or with values that are off.
 */
final class PlanarConcealer {

    private static final double SECONDS = 70;
    /** Channels of a sensor that say something of the plane. */
    private static final int[] SHOWN = {0, 2, 4};
    private static final double ACC_STEP = 1e4;
    private static final double GYR_STEP = 1e5;
    /** An output more than this many times as lively as the linear one is no sitter. */
    private static final double WILD = 9;

    /** Where a mechanism can be. */
    private record Place(String joint, int component) {}

    /**
     * What is concealed.
     *
     * @param change to the person
     */
    private record Hidden(Omission omission, Consumer<PlanarSetup> change) {}

    /**
     * As sized.
     *
     * @param share missed in the worst output
     * @param left missed variance, by body and channel shown [(m/s²)² or (rad/s)²]
     */
    private record Sized(Hidden hidden, double share, double[][] left) {}

    private final ConcealedSpec spec;
    private final Seeds seeds;
    private final PlanarPerson person;
    private final PlanarPlant.Base base;
    private final InertialSensors sensors;
    private final double[][] rows;
    private final PlanarPlant.Trace calm;

    private PlanarConcealer(ConcealedSpec spec) {
        this.spec = spec;
        seeds = new Seeds(spec.seed());
        person = PlanarPerson.draw(seeds.source("sitter"));
        base = shaken(seeds.of("shaking"));
        sensors = new InertialSensors(spec.setting(), false, InertialSensors.RATE);
        rows = new double[][] {sensors.thinned(base.x()), sensors.thinned(base.z()), sensors.thinned(base.spin())};
        calm = new PlanarPlant(new PlanarSetup(person), PlanarPlant.COARSE).run(base);
    }

    static ConcealedCase make(ConcealedSpec spec) {
        return new PlanarConcealer(spec).make();
    }

    private ConcealedCase make() {
        Optional<Sized> sized = spec.words().stream().findFirst().map(this::sized);
        RandomGenerator body = seeds.source("stirring");
        double newtons = spec.setting().leastForce + (spec.setting().mostForce - spec.setting().leastForce) * body.nextDouble();
        double[] stir = Concealer.stirring(base.length(), newtons, body);
        PlanarSetup setup = new PlanarSetup(person);
        sized.ifPresent(each -> each.hidden().change().accept(setup));
        setup.stir(stir);
        PlanarPlant.Trace trace = new PlanarPlant(setup, PlanarPlant.FINE).run(base);
        Map<String, double[][]> sent = sensors.sent(setup.faults(), PlanarPerson.PLACES, place -> motion(base, trace, place),
                seeds.of("sensors"), seeds.of("sensors"));
        Map<String, double[][]> clean = sensors.clean(setup.faults(), PlanarPerson.PLACES, place -> motion(base, trace, place));
        PlanarPerson believed = spec.exact() ? person : person.wrong(seeds.source("user"));
        boolean jointed = spec.setting() == Setting.JOINTED;
        ObjectNode model = jointed ? believed.plane("case " + spec.name()) : believed.chain("case " + spec.name());
        return new ConcealedCase(recording(sent, PlanarPerson.PLACES), recording(clean, PlanarPerson.PLACES), model.toPrettyString() + "\n",
                key(sized, newtons, noise(stir)).toPrettyString() + "\n", Optional.empty(),
                jointed ? Map.of() : Map.of(ConcealedCase.SIMULATION, simulated(believed, sent.get(PlanarPerson.PLACES.get(0)))));
    }

    /** The platform's program along z, at random along x and in pitch. */
    private static PlanarPlant.Base shaken(Seeds seeds) {
        Shaking shaking = Shaking.of(Setting.PLANAR, 0.9, OptionalDouble.of(SECONDS), seeds);
        RandomGenerator random = seeds.source("plane");
        int length = shaking.length();
        double[] x = UniformSeries.lines(length, 0.4, 8, -0.3, 0.25 + 0.25 * random.nextDouble(), random);
        double[] pitch = UniformSeries.lines(length, 0.4, 6, -1, 0.004 + 0.004 * random.nextDouble(), random);
        UniformSeries.fade(x, 1);
        UniformSeries.fade(pitch, 1);
        return PlanarPlant.Base.of(x, shaking.z(), UniformSeries.rate(pitch));
    }

    /** What the sensor at a place feels, six channels. */
    private static double[][] motion(PlanarPlant.Base base, PlanarPlant.Trace trace, String place) {
        int body = PlanarPerson.PLACES.indexOf(place) - 1;
        double[] none = new double[base.length()];
        double[][] felt = body < 0 ? new double[][] {base.x(), base.z(), base.rate()} : trace.felt()[body];
        return new double[][] {felt[0].clone(), none.clone(), felt[1].clone(), none.clone(), felt[2].clone(), none.clone()};
    }

    /**
     * What the user's simulator says for the platform as it was recorded.
     *
     * @param six rows of the platform's sensor
     */
    private static Recording simulated(PlanarPerson believed, double[][] six) {
        int ticks = (int) (UniformSeries.RATE / InertialSensors.RATE);
        PlanarPlant.Base recorded = PlanarPlant.Base.of(between(six[0], ticks), between(six[2], ticks), between(six[4], ticks));
        PlanarPlant.Trace trace = new PlanarPlant(new PlanarSetup(believed), PlanarPlant.FINE).run(recorded);
        Map<String, double[][]> out = new LinkedHashMap<>();
        for (String place : PlanarPerson.PLACES.subList(1, PlanarPerson.PLACES.size())) {
            double[][] felt = motion(recorded, trace, place);
            double[][] rows = new double[felt.length][six[0].length];
            for (int q = 0; q < felt.length; q++) {
                double step = q < 3 ? ACC_STEP : GYR_STEP;
                for (int i = 0; i < rows[q].length; i++) {
                    rows[q][i] = Math.rint(felt[q][i * ticks] * step) / step + 0.0;
                }
            }
            out.put(place, rows);
        }
        return recording(out, List.copyOf(out.keySet()));
    }

    /** Rows at so many times their rate: what has nothing above half of it goes through the rows. */
    static double[] between(double[] rows, int ticks) {
        int half = 16;
        double[][] weights = new double[ticks][2 * half + 1];
        for (int phase = 0; phase < ticks; phase++) {
            double sum = 0;
            for (int j = -half; j <= half; j++) {
                double away = j - (double) phase / ticks;
                weights[phase][j + half] = Math.abs(away) > half + 1 ? 0 : Kernel.value(0.5, 1, half, away);
                sum += weights[phase][j + half];
            }
            for (int j = 0; j < weights[phase].length; j++) {
                weights[phase][j] /= sum;
            }
        }
        double[] out = new double[rows.length * ticks];
        for (int i = 0; i < out.length; i++) {
            double sum = 0;
            for (int j = -half; j <= half; j++) {
                sum += weights[i % ticks][j + half] * rows[Math.max(0, Math.min(rows.length - 1, i / ticks + j))];
            }
            out[i] = sum;
        }
        return out;
    }

    private static Recording recording(Map<String, double[][]> six, List<String> places) {
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        for (String place : places) {
            for (int q : SHOWN) {
                channels.put(new Channel(place, q < 3 ? Quantity.ACCELERATION : Quantity.ANGULAR_RATE, "xyz".charAt(q % 3)),
                        six.get(place)[q]);
            }
        }
        return Concealer.recording(channels, InertialSensors.RATE);
    }

    /** Where it would be in a seat and a spine. */
    private static List<Place> places(String word) {
        Place cushion = new Place("cushion", PlanarPerson.Z);
        Place backrest = new Place("backrest", PlanarPerson.X);
        Place lumbar = new Place("lumbar", PlanarPerson.Z);
        Place stoop = new Place("lumbar", PlanarPerson.PITCH);
        Place nod = new Place("neck", PlanarPerson.PITCH);
        return switch (word) {
            case "contact.loss" -> List.of(backrest);
            case "friction.coulomb" -> List.of(new Place("backrest", PlanarPerson.Z), lumbar, stoop, nod);
            case "contact.bumpstop", "stiffness.asymmetric" -> List.of(cushion, lumbar);
            case "stiffness.hardening" -> List.of(cushion, backrest, lumbar, nod);
            default -> List.of(cushion, lumbar, stoop, nod);
        };
    }

    private Sized sized(String word) {
        RandomGenerator random = seeds.source("omissions");
        double wanted = Concealer.share(spec, random);
        if (word.startsWith("sensor.")) {
            String place = PlanarPerson.PLACES.get(1 + random.nextInt(person.size()));
            return fault(word, place, wanted, random);
        }
        List<Place> places = new ArrayList<>(places(word));
        Filters filters = new Filters(rows);
        Sized best = law(word, places.remove(random.nextInt(places.size())), wanted, filters, random);
        // Where it can hardly show, another place is tried.
        while (best.share() < wanted / 2 && !places.isEmpty()) {
            Sized other = law(word, places.remove(random.nextInt(places.size())), wanted, filters, random);
            best = other.share() > best.share() ? other : best;
        }
        return best;
    }

    private Sized law(String word, Place at, double wanted, Filters filters, RandomGenerator random) {
        int joint = person.joint(at.joint());
        CoordinateLaw law = CoordinateLaw.of(word, coordinate(joint, at.component()), random);
        PlanarPerson.Joint of = person.joints().get(joint);
        String where = spec.setting() == Setting.JOINTED ? of.where(at.component()) : of.where();
        double[][] linear = missed(filters, calm);
        return OmissionSize.sized(law.least(), law.most(), wanted, size -> look(new Hidden(told(law, where, at, size),
                setup -> setup.joint(joint, at.component(), law.physics().apply(size))), filters, linear), Sized::share);
    }

    /** With the coordinate in which it works. */
    private static Omission told(CoordinateLaw law, String where, Place at, double size) {
        Omission told = law.told(where, size);
        return Omission.told(told.mechanism(), where,
                told.form() + ", " + at.joint() + " " + List.of("along x", "along z", "in pitch").get(at.component()),
                told.parameters(), told.law());
    }

    private Coordinate coordinate(int joint, int component) {
        PlanarPerson.Joint of = person.joints().get(joint);
        return new Coordinate(of.stiffness()[component], of.damping()[component], UniformSeries.rms(calm.extension()[joint][component]),
                UniformSeries.rms(calm.rate()[joint][component]), UniformSeries.rms(calm.force()[joint][component]),
                component == PlanarPerson.PITCH, SECONDS);
    }

    private Sized fault(String word, String place, double wanted, RandomGenerator random) {
        double half = random.nextDouble();
        return switch (word) {
            case "sensor.delay" -> fault(word, place, "late", "delay_s", 5e-4, 0.06, wanted, size -> Fault.late(size, size));
            case "sensor.gain" -> fault(word, place, "constant", "factor_less_one", 0.01, 0.6, wanted, size -> Fault.gain(1 + size));
            case "sensor.misalignment" -> fault(word, place, "turned about y", "angle_rad", 0.01, 0.6, wanted, size -> Fault.turned(size));
            case "sensor.mount" ->
                fault(word, place, "strap", "stiffness_over_usual", 0.8, 6, wanted, size -> Fault.strap(30 / size, 0.15 + 0.2 * half));
            default -> throw new IllegalArgumentException("no sensor in the plane can have '" + word + "'");
        };
    }

    private Sized fault(String word, String place, String form, String parameter, double least, double most, double wanted,
            DoubleFunction<Fault> fault) {
        return OmissionSize.sized(least, most, wanted,
                size -> look(new Hidden(Omission.told(word, place + ".acc.z", form, Map.of(parameter, size), List.of()),
                        setup -> setup.fault(place, fault.apply(size))), place),
                Sized::share);
    }

    /** Of a law: what no linear filters of the platform's motion explain, beyond what they leave of the linear person. */
    private Sized look(Hidden hidden, Filters filters, double[][] linear) {
        PlanarSetup setup = new PlanarSetup(person);
        hidden.change().accept(setup);
        PlanarPlant.Trace trace = new PlanarPlant(setup, PlanarPlant.COARSE).run(base);
        double worst = 1e-12;
        for (int i = 0; i < person.size(); i++) {
            for (int q = 0; q < SHOWN.length; q++) {
                double lively = UniformSeries.rms(trace.felt()[i][q]) / UniformSeries.rms(calm.felt()[i][q]);
                if (!(lively * lively < WILD)) {
                    return new Sized(hidden, Double.MAX_VALUE, linear);
                }
            }
        }
        double[][] left = missed(filters, trace);
        for (int i = 0; i < person.size(); i++) {
            for (int q = 0; q < SHOWN.length; q++) {
                left[i][q] = Math.max(0, left[i][q] - linear[i][q]);
                worst = Math.max(worst, left[i][q] / Math.pow(UniformSeries.rms(trace.felt()[i][q]), 2));
            }
        }
        return new Sized(hidden, worst, left);
    }

    private double[][] missed(Filters filters, PlanarPlant.Trace trace) {
        double[][] left = new double[person.size()][SHOWN.length];
        for (int i = 0; i < person.size(); i++) {
            for (int q = 0; q < SHOWN.length; q++) {
                left[i][q] = filters.left(sensors.thinned(trace.felt()[i][q]));
            }
        }
        return left;
    }

    /** Of a sensor's fault: all that it changes. */
    private Sized look(Hidden hidden, String place) {
        PlanarSetup setup = new PlanarSetup(person);
        hidden.change().accept(setup);
        int body = PlanarPerson.PLACES.indexOf(place) - 1;
        double[][] faulty = motion(base, calm, place);
        setup.faults().forEach(at -> at.fault().whileSensing(faulty));
        double[][] left = new double[person.size()][SHOWN.length];
        double worst = 1e-12;
        for (int q = 0; q < SHOWN.length; q++) {
            double[] usual = calm.felt()[body][q];
            left[body][q] = Math.pow(UniformSeries.rms(UniformSeries.less(faulty[SHOWN[q]], usual)), 2);
            worst = Math.max(worst, left[body][q] / Math.pow(UniformSeries.rms(usual), 2));
        }
        return new Sized(hidden, worst, left);
    }

    /** Variance by body and channel that no model can predict: the sensor's noise and what the person does himself. */
    private double[][] noise(double[] stir) {
        PlanarSetup stirred = new PlanarSetup(person);
        stirred.stir(stir);
        PlanarPlant.Trace trace = new PlanarPlant(stirred, PlanarPlant.COARSE).run(base);
        double[][] out = new double[person.size()][SHOWN.length];
        for (int i = 0; i < person.size(); i++) {
            for (int q = 0; q < SHOWN.length; q++) {
                double own = UniformSeries.rms(UniformSeries.less(trace.felt()[i][q], calm.felt()[i][q]));
                out[i][q] = Math.pow(sensors.noise(SHOWN[q]), 2) + own * own;
            }
        }
        return out;
    }

    private ObjectNode key(Optional<Sized> sized, double stirring, double[][] noise) {
        ObjectNode root = new ObjectMapper().createObjectNode();
        root.put("case", spec.name());
        root.putArray("mechanisms");
        double excess = 0;
        if (sized.isPresent()) {
            ObjectNode one = root.withArray("mechanisms").addObject();
            ConcealedKey.write(sized.get().hidden().omission(), one);
            double[] over = new double[person.size() * SHOWN.length];
            Arrays.setAll(over, i -> sized.get().left()[i / SHOWN.length][i % SHOWN.length] / noise[i / SHOWN.length][i % SHOWN.length]);
            excess = Arrays.stream(over).average().orElse(0);
            one.put("share", Chain.rounded(sized.get().share())).put("linear_chi2", Chain.rounded(1 + excess));
        }
        root.put("strength", spec.strength()).put("setting", spec.setting().word()).put("exact_model", spec.exact());
        root.put("linear_chi2", Chain.rounded(1 + excess)).put("stirring_N", Chain.rounded(stirring));
        root.set("true_linear_model", person.chain("verticals of the true linear part"));
        ObjectNode joints = root.putObject("true_joints");
        person.joints().forEach(joint -> {
            ObjectNode one = joints.putObject(joint.name()).put("where", joint.where());
            Arrays.stream(joint.stiffness()).forEach(k -> one.withArray("stiffness_x_z_pitch").add(Chain.rounded(k)));
            Arrays.stream(joint.damping()).forEach(c -> one.withArray("damping_x_z_pitch").add(Chain.rounded(c)));
        });
        root.put("seed", spec.seed());
        return root;
    }
}
