package wbv.diagnosis.surrogate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import wbv.body.Model;
import wbv.body.SensorFault;
import wbv.body.simulate.Excitation;
import wbv.diagnosis.Diagnosed;
import wbv.diagnosis.Diagnoser;
import wbv.diagnosis.Question;
import wbv.diagnosis.measured.AccelerationUnit;
import wbv.diagnosis.measured.Measured;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.Quantity;
import wbv.recording.Recording;

/**
 * The linear model that does what a simulation did of which only the outputs are known: bodies in a chain, one for each output,
 * and others where these alone do not do it, fitted to the simulation as driven by the recording's input.
 *
 * <p>What the model misses of the simulation is no error of the simulation: it is kept beside the model, as channels of the recording that
 * move the sensors too, so that both together are the simulation, whatever moved it; the model has to say only what changes where its
 * numbers do or something is added.
 *
 * <p>Accelerations know masses, stiffness and damping only up to a common factor: the mass of all bodies is assumed.
 *
 * @param model  with a sensor for every output that the recording has too, to which the recording's further channels add
 * @param errors root mean square of what the model misses of an output over that of the output, by channel of the simulation
 * @param recording the part of the recording that the simulation covers, with what the simulation gave beside the model
 * @param name   what messages call the simulation
 */
public record Surrogate(Model model, Map<Channel, Double> errors, Recording recording, String name) {

    /** What sits of a person of whom nothing is known [kg], and of one whose mass is [1]. */
    private static final double SITTING = 55;
    private static final double SITTING_SHARE = 0.73;
    /** A surrogate that misses more is none. */
    private static final double MOST = 0.1;
    /** What is missed beyond this may be the unit's fault, or that of an input held over each sample. */
    private static final double DOUBTFUL = 0.025;
    /** What the locations of channels end in that hold what the simulation gave beside the model. */
    private static final String BESIDE = "_beside";
    /** An output that differs less from the input moves with the base. */
    private static final double RIGID = 0.01;

    /**
     * Diagnoses what a simulation leaves out of a recording. First the two are held against each other as they are; only where sensors and
     * a person who sits still do not explain the difference is a model needed that does what the simulation did.
     *
     * @param simulation what a simulation gave, channels named as the recording's and on its clock; the rest is left out
     * @param name       what messages call the simulation
     * @param input      acceleration of the recording that drove the simulation
     * @param noise      standard deviation of a sample of the outputs where it is known
     * @param unitsKnown see {@link Question}
     * @param progress   told the step and the share of it that is done, 0 to 1 or NaN
     * @throws DataFault if the two have no output or no time in common, or differ and no chain does what the simulation did
     */
    public static Examined examine(Recording recording, Recording simulation, String name, Channel input, OptionalDouble noise,
            boolean unitsKnown, BiConsumer<String, Double> progress) {
        Driven driven = Driven.of(recording, simulation, name, input);
        Optional<InPlane> plane = driven.plane(simulation);
        Optional<Examined> silent = silent(driven, plane, noise, unitsKnown, progress);
        if (silent.isPresent()) {
            return silent.get();
        }
        Surrogate best = best(driven, plane, progress);
        best.require(input);
        return new Examined(best, Diagnoser.examine(best.question(noise, unitsKnown), progress));
    }

    /**
     * As {@link #examine}, where sensors and a person who sits still explain the difference; empty where they do not, and no more is looked
     * for.
     */
    public static Optional<Examined> unremarkable(Recording recording, Recording simulation, String name, Channel input,
            OptionalDouble noise, boolean unitsKnown, BiConsumer<String, Double> progress) {
        Driven driven = Driven.of(recording, simulation, name, input);
        return silent(driven, driven.plane(simulation), noise, unitsKnown, progress);
    }

    private static Optional<Examined> silent(Driven driven, Optional<InPlane> plane, OptionalDouble noise, boolean unitsKnown,
            BiConsumer<String, Double> progress) {
        Surrogate plain = plane.map(found -> driven.surrogate(found.simulated, found.plain)).filter(Surrogate::isGood)
                .orElseGet(() -> driven.surrogate(driven.plain()));
        return Diagnoser.silent(plain.question(noise, unitsKnown), progress).map(found -> new Examined(plain, found));
    }

    /** What a simulation did in a plane, and the measured bodies alone that come nearest to it. */
    private record InPlane(SimulatedPlane simulated, PlaneNet plain) {}

    /** A surrogate and what came of the recording with it. */
    public record Examined(Surrogate surrogate, Diagnosed diagnosed) {}

    /** The best surrogate of a simulation, however good it is. */
    static Surrogate of(Recording recording, Recording simulation, String name, Channel input, BiConsumer<String, Double> progress) {
        Driven driven = Driven.of(recording, simulation, name, input);
        return best(driven, driven.plane(simulation), progress);
    }

    /** Of bodies in the plane if they do what the simulation did, else of a chain. */
    private static Surrogate best(Driven driven, Optional<InPlane> plane, BiConsumer<String, Double> progress) {
        return plane.map(found -> driven.surrogate(found.simulated, found.simulated.best(found.plain, progress))).filter(Surrogate::isGood)
                .orElseGet(() -> driven.surrogate(driven.best(progress)));
    }

    private Question question(OptionalDouble noise, boolean unitsKnown) {
        return new Question(model, recording, Optional.empty(), noise, unitsKnown);
    }

    /**
     * A simulation over the input that drove it.
     *
     * @param driven the input as the simulation took it, and what it alone did to the outputs
     * @param simulated by output, as the simulation gave it
     * @param held   whether the input was held over each sample
     * @param others channels of the base that did the rest
     */
    private record Driven(Recording recording, Recording driven, Map<Channel, double[]> simulated, boolean held, List<Channel> others,
            String name, Channel input, List<Channel> outputs) {

        static Driven of(Recording recording, Recording simulation, String name, Channel input) {
            if (input.quantity() != Quantity.ACCELERATION || !recording.has(input)) {
                throw new DataFault("what drove the simulation must be an acceleration that was recorded: " + input + "; there are "
                        + along(recording, input));
            }
            List<Channel> outputs = new ArrayList<>(along(simulation, input));
            outputs.remove(input);
            if (outputs.stream().noneMatch(recording::has)) {
                throw DataFault.in(name, "has no acceleration along " + input.axis() + " that was recorded too; name its columns "
                        + "as the recording's channels: " + along(recording, input));
            }
            Recording driven = Surrogate.driven(recording, simulation, name, input, outputs);
            outputs.removeIf(output -> ChainSearch.error(driven.values(input), driven.values(output), 0) < RIGID);
            if (outputs.isEmpty()) {
                throw DataFault.in(name, "moves as " + input + " does, in all that was recorded too: there is nothing to identify");
            }
            try {
                Recording part = common(recording, driven);
                OtherInputs others = new OtherInputs(part, input);
                Map<Channel, double[]> simulated = new LinkedHashMap<>();
                Map<Channel, double[]> own = new LinkedHashMap<>(Map.of(input, driven.values(input)));
                for (Channel output : outputs) {
                    simulated.put(output, Excitation.bridged(driven.values(output)));
                    own.put(output, less(driven.values(output), others.partOf(simulated.get(output))));
                }
                Recording alone = new Recording(driven.clock(), own, Metadata.NONE);
                ChainSearch.Fitted plain = Surrogate.plain(alone, input, outputs);
                if (plain.worst() > DOUBTFUL) {
                    requireSameUnit(alone, input, outputs, plain.worst());
                }
                Recording steps = Surrogate.held(alone, input);
                boolean held = plain.worst() > DOUBTFUL && Surrogate.plain(steps, input, outputs).worst() < plain.worst() / 2;
                return new Driven(part, held ? steps : alone, simulated, held, others.channels(), name, input, List.copyOf(outputs));
            } catch (DataFault fault) {
                throw DataFault.in(name, fault.getMessage());
            }
        }

        private static double[] less(double[] a, double[] b) {
            return IntStream.range(0, a.length).mapToDouble(i -> a[i] - b[i]).toArray();
        }

        /** The measured bodies in a chain, and no more. */
        ChainSearch.Fitted plain() {
            return new ChainSearch(driven, input, outputs, (step, share) -> {}).plain();
        }

        /** The least arrangement that does what the simulation did. */
        ChainSearch.Fitted best(BiConsumer<String, Double> progress) {
            try {
                return new ChainSearch(driven, input, outputs, progress).best();
            } catch (DataFault fault) {
                throw DataFault.in(name, fault.getMessage());
            }
        }

        /** What the simulation did in a plane, if it gave that; nothing where what drove it was held over each sample. */
        Optional<InPlane> plane(Recording simulation) {
            Map<Channel, double[]> all = given(recording, simulation, name, recording::has);
            return held ? Optional.empty() : SimulatedPlane.of(recording, all, input, outputs.stream().map(Channel::location).toList())
                    .map(simulated -> new InPlane(simulated, simulated.plain()));
        }

        /** Bodies in a plane, with what the simulation gave beside them. */
        Surrogate surrogate(SimulatedPlane plane, PlaneNet net) {
            double mass = sitting(recording.metadata());
            Model found = plane.model(net, mass).seenBy(recording.channels());
            Model model = new Model("surrogate of " + name,
                    Optional.of(source(name, " in the plane of x and z", recording.metadata(), mass)), found.axis(),
                    found.base(), found.bodies(), found.links(), found.inputs(), found.declared(), found.sensors());
            double[][] own = SimulatedPlane.outputs(model, recording);
            Map<Channel, Double> errors = new LinkedHashMap<>();
            for (int o = 0; o < own.length; o++) {
                Channel sensor = model.outputs().get(o);
                errors.put(sensor, ChainSearch.error(plane.given(sensor), own[o], (int) (ChainSearch.SETTLING * recording.clock().rate())));
            }
            return with(model, own, plane::given, errors);
        }

        /**
         * With what the simulation gave beside a model.
         *
         * @param own what the model's sensors read, in its order
         * @param given what the simulation gave of each
         */
        private Surrogate with(Model model, double[][] own, Function<Channel, double[]> given, Map<Channel, Double> errors) {
            Map<Channel, double[]> channels = new LinkedHashMap<>();
            recording.channels().forEach(channel -> channels.put(channel, recording.values(channel)));
            for (int o = 0; o < own.length; o++) {
                Channel sensor = model.outputs().get(o);
                channels.put(beside(sensor), Measured.centred(less(given.apply(sensor), own[o])));
            }
            List<Model.Body> bodies = model.bodies().stream()
                    .map(body -> body.completed(body.mass(), body.sensor().map(Driven::besides).orElse(List.of()),
                            body.hidden(), body.forces()))
                    .toList();
            List<Model.Sensor> sensors = model.sensors().stream()
                    .map(sensor -> new Model.Sensor(sensor.channel(), sensor.reads(), besides(sensor.channel()),
                            sensor.at()))
                    .toList();
            Model complete = new Model(model.name(), model.source(), model.axis(), model.base(), bodies, model.links(), model.inputs(),
                    model.declared(), sensors);
            return new Surrogate(complete, errors, new Recording(recording.clock(), channels, recording.metadata()), name);
        }

        private static Channel beside(Channel sensor) {
            return new Channel(sensor.location() + BESIDE, sensor.quantity(), sensor.axis());
        }

        private static List<SensorFault> besides(Channel sensor) {
            return List.of(new SensorFault.Beside(beside(sensor)));
        }

        Surrogate surrogate(ChainSearch.Fitted chain) {
            String how = (held ? ", its input held over each sample" : "")
                    + (others.isEmpty() ? ""
                            : ", beside what " + others.stream().map(Channel::toString).collect(Collectors.joining(", ")) + " did");
            Model model = finished(chain.model(), name, how, recording.metadata()).seenBy(recording.channels());
            return with(model, SimulatedPlane.outputs(model, driven), simulated::get, chain.errors());
        }
    }

    private static ChainSearch.Fitted plain(Recording driven, Channel input, List<Channel> outputs) {
        return new ChainSearch(driven, input, outputs, (step, share) -> {}).plain();
    }

    /** The same with an input that is constant over each sample, as some simulations take it: half a sample late, nearly. */
    private static Recording held(Recording driven, Channel input) {
        Excitation whole = new Excitation(driven.clock().rate(), Excitation.bridged(driven.values(input)), Map.of());
        double[] spectrum = whole.baseSpectrum().clone();
        for (int k = 0; k < whole.omega().length; k++) {
            double angle = whole.omega()[k] / (2 * driven.clock().rate());
            double re = spectrum[2 * k];
            double im = spectrum[2 * k + 1];
            spectrum[2 * k] = re * Math.cos(angle) + im * Math.sin(angle);
            spectrum[2 * k + 1] = im * Math.cos(angle) - re * Math.sin(angle);
        }
        return with(driven, input, whole.series(spectrum));
    }

    private static Recording with(Recording driven, Channel channel, double[] values) {
        Map<Channel, double[]> all = new LinkedHashMap<>();
        driven.channels().forEach(each -> all.put(each, each.equals(channel) ? values : driven.values(each)));
        return new Recording(driven.clock(), all, driven.metadata());
    }

    /** Refuses a simulation that a chain does much better if it is taken for one in g or mg. */
    private static void requireSameUnit(Recording driven, Channel input, List<Channel> outputs, double missed) {
        for (Map.Entry<String, Double> unit : Map.of("g", AccelerationUnit.GRAVITY, "mg", AccelerationUnit.GRAVITY / 1000).entrySet()) {
            double[] scaled = Arrays.stream(driven.values(input)).map(value -> value / unit.getValue()).toArray();
            if (plain(with(driven, input, scaled), input, outputs).worst() < Math.min(MOST, missed / 2)) {
                throw new DataFault("looks to be in " + unit.getKey() + ", the recording in m/s2; save it in m/s2");
            }
        }
    }

    private static List<Channel> along(Recording recording, Channel input) {
        return recording.channels().stream().filter(c -> c.quantity() == Quantity.ACCELERATION && c.axis() == input.axis())
                .toList();
    }

    /** The simulation's outputs over the recording's input, as long as both last. */
    private static Recording driven(Recording recording, Recording simulation, String name, Channel input,
            List<Channel> outputs) {
        Covered covered = Covered.of(recording.clock(), recording.length(), simulation, name);
        Map<Channel, double[]> values = new LinkedHashMap<>();
        values.put(input, Arrays.copyOfRange(recording.values(input), covered.first, covered.first + covered.length));
        outputs.forEach(output -> values.put(output, covered.of(simulation, output)));
        return new Recording(new Clock(recording.clock().time(covered.first), recording.clock().rate()), values, Metadata.NONE);
    }

    /** All that a simulation gave over a recording of no more than it covers, gaps bridged. */
    private static Map<Channel, double[]> given(Recording recording, Recording simulation, String name, Predicate<Channel> wanted) {
        Covered covered = Covered.of(recording.clock(), recording.length(), simulation, name);
        Map<Channel, double[]> out = new LinkedHashMap<>();
        simulation.channels().stream().filter(wanted)
                .forEach(channel -> out.put(channel, Excitation.bridged(covered.of(simulation, channel))));
        return out;
    }

    /**
     * What a simulation covers of a recording.
     *
     * @param first sample of the recording
     * @param skipped samples of the simulation before it
     */
    private record Covered(int first, int skipped, int length) {
        static Covered of(Clock clock, int samples, Recording simulation, String name) {
            Clock other = simulation.clock();
            double shift = (other.start() - clock.start()) * clock.rate();
            double drift = (other.rate() / clock.rate() - 1) * Math.min(samples, simulation.length());
            if (Math.abs(shift - Math.rint(shift)) > 0.1 || Math.abs(drift) > 0.5) {
                throw DataFault.in(name, text("is not on the recording's clock: it begins at %.6g s with %.8g Hz, the recording at "
                        + "%.6g s with %.8g Hz; save it at the recording's times", other.start(), other.rate(), clock.start(),
                        clock.rate()));
            }
            int first = (int) Math.max(0, Math.rint(shift));
            int skipped = first - (int) Math.rint(shift);
            int length = Math.min(samples - first, simulation.length() - skipped);
            if (length <= 0) {
                throw DataFault.in(name, "ends before the recording begins, or begins after it ends");
            }
            return new Covered(first, skipped, length);
        }

        double[] of(Recording simulation, Channel channel) {
            return Arrays.copyOfRange(simulation.values(channel), skipped, skipped + length);
        }
    }

    /** The part of the recording that the simulation covers. */
    private static Recording common(Recording recording, Recording driven) {
        int first = (int) recording.clock().nearest(driven.clock().start());
        Map<Channel, double[]> values = new LinkedHashMap<>();
        recording.channels().forEach(channel -> values.put(channel, Arrays.copyOfRange(recording.values(channel), first,
                first + driven.length())));
        return new Recording(driven.clock(), values, recording.metadata());
    }

    /** What is assumed to sit [kg]. */
    private static double sitting(Metadata known) {
        OptionalDouble person = person(known);
        return person.isPresent() ? SITTING_SHARE * person.getAsDouble() : SITTING;
    }

    private static OptionalDouble person(Metadata known) {
        return known.subject().map(Metadata.Subject::mass).orElseGet(OptionalDouble::empty);
    }

    private static String source(String name, String how, Metadata known, double mass) {
        OptionalDouble person = person(known);
        return text("linear surrogate of %s%s, identified by wbv; its mass of %.1f kg is assumed%s", name, how, mass,
                person.isPresent() ? " for a person of " + person.getAsDouble() + " kg" : "");
    }

    /** With the mass that is assumed, and a source that says so. */
    private static Model finished(Model model, String name, String how, Metadata known) {
        double mass = sitting(known);
        double factor = mass / model.mass();
        List<Model.Body> bodies = model.bodies().stream().map(body -> new Model.Body(body.name(), factor * body.mass(),
                body.sensor(), body.faults(), body.hidden(), body.forces())).toList();
        List<Model.Link> links = model.links().stream().map(link -> new Model.Link(link.from(), link.to(),
                factor * link.stiffness(), factor * link.damping(), link.sensor(), link.laws(), link.drives())).toList();
        return new Model("surrogate of " + name, Optional.of(source(name, how, known, mass)), model.axis(), model.base(), bodies, links,
                model.inputs(), model.declared());
    }

    private boolean isGood() {
        return errors.values().stream().allMatch(error -> error <= MOST);
    }

    /** Refuses where nothing can be said of what a change of the simulation would do. */
    private void require(Channel input) {
        for (Map.Entry<Channel, Double> entry : errors.entrySet()) {
            if (entry.getValue() > MOST) {
                throw DataFault.in(name,
                        text("as it is, it leaves more of the recording than sensors do, and no chain of bodies driven by %s does what it "
                                + "does: the nearest, %s, misses %.3g %% of %s, %.0f %% may be missed; is it the right input? If the "
                                + "simulation is not linear, give a model "
                                + "(--model)", input, chain(), 100 * entry.getValue(), entry.getKey(), 100 * MOST));
            }
        }
    }

    /** {@code platform-pelvis, pelvis-head}. */
    private String chain() {
        return model.links().stream().map(link -> Model.whole(link.from()) + "-" + Model.whole(link.to())).distinct()
                .collect(Collectors.joining(", "));
    }

    /** What it is and how well it does, in a line. */
    public String sentence() {
        return model.source().orElse("") + ": " + chain() + "; misses " + errors.entrySet().stream()
                .map(entry -> percent(entry.getValue()) + " of " + entry.getKey()).collect(Collectors.joining(", "));
    }

    private static String percent(double share) {
        return share < 1e-4 ? "under 0.01 %" : text("%.2g %%", 100 * share);
    }

    private static String text(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
