package wbv.fmi;

import java.io.Closeable;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.Quantity;
import wbv.recording.Recording;

/**
 * A user's simulator, a functional mock-up unit of FMI 2.0 or 3.0, run on the inputs of a recording. Its time is 0 at the recording's first
 * sample; it begins with its own start values. Units that can be run both ways step themselves.
 *
 * <p>The mean of accelerations and angular rates is taken away before they go in, as wbv's own simulator does: it is the sensor's, and no
 * base moves off for as long as a recording lasts.
 *
 * <pre>{@code
 * try (FmuSimulation simulation = FmuSimulation.open(Path.of("rig.fmu"), recording, Map.of(), Map.of())) {
 *     Recording simulated = simulation.run(simulation.parameters());
 * }
 * }</pre>
 */
public final class FmuSimulation implements Closeable {

    /** Steps a sample that are tried first, and at most. */
    private static final int FIRST = 4;
    private static final int MOST = 256;
    /** Samples on which the step is chosen. */
    private static final int TRIED = 1500;
    /**
     * Change of an output at half the step, over its root mean square, below which the step is fine enough: a second-order method is then
     * off by a third.
     */
    private static final double ENOUGH = 5e-5;
    /** A change that shrinks less than this from step to step is the unit's own, and shrinks no more. */
    private static final double SHRINKS = 1.5;
    /** Steps a sample for a unit whose own step does not change. */
    private static final int OWN_STEPS = 16;
    /** Part of a parameter by which it is changed for a difference. */
    private static final double DIFFERENCE = 1e-3;

    private final String name;
    private final Recording recording;
    private final Description unit;
    private final UnpackedFmu unpacked;
    private final Binary binary;
    private final Wiring wiring;
    private final List<Variable> wired;
    private final List<InputSignal> signals = new ArrayList<>();
    private final List<Variable> tunable;
    private Optional<Fineness> fineness = Optional.empty();
    private double change = Double.NaN;

    private FmuSimulation(String name, Recording recording, Description unit, UnpackedFmu unpacked, Binary binary, Wiring wiring) {
        this.name = name;
        this.recording = recording;
        this.unit = unit;
        this.unpacked = unpacked;
        this.binary = binary;
        this.wiring = wiring;
        wired = List.copyOf(wiring.inputs().keySet());
        for (Variable each : wired) {
            Channel channel = wiring.inputs().get(each);
            boolean centred = channel.quantity() == Quantity.ACCELERATION || channel.quantity() == Quantity.ANGULAR_RATE;
            signals.add(new InputSignal(recording.values(channel), recording.clock().rate(), centred));
        }
        tunable = unit.tunable().stream().filter(each -> each.start().isPresent()).toList();
    }

    /**
     * Unpacks a unit and finds its inputs and outputs among the channels of a recording. The unit is not run yet.
     *
     * @param inputs  channels by name of an input, where the names do not say it
     * @param outputs likewise
     * @throws DataFault   if it is no unit that can be run here, or has no input and output in common with the recording
     * @throws IOException if the file cannot be read
     */
    public static FmuSimulation open(Path file, Recording recording, Map<String, Channel> inputs, Map<String, Channel> outputs)
            throws IOException {
        String name = file.toString();
        UnpackedFmu unpacked = UnpackedFmu.of(file);
        try {
            Description unit = DescriptionReader.read(unpacked.description(), name);
            Description.Kind kind = unit.coSimulation().or(unit::modelExchange).orElseThrow(() -> DataFault.in(name,
                    "can neither be simulated nor gives derivatives; export it for co-simulation or model exchange"));
            Wiring wiring = Wiring.of(unit, recording, inputs, outputs, name);
            Binary binary = new Binary(unpacked.binary(Binary.places(unit.version(), kind.identifier()), name), name);
            return new FmuSimulation(name, recording, unit, unpacked, binary, wiring);
        } catch (IOException | RuntimeException failed) {
            unpacked.close();
            throw failed;
        }
    }

    /** Whether a file's name says that it is a unit. */
    public static boolean isNamed(String file) {
        return file.toLowerCase(Locale.ROOT).endsWith(".fmu");
    }

    /** Tunable parameters with the values that they have, in their own units: what may be wrong. */
    public Map<String, Double> parameters() {
        Map<String, Double> out = new LinkedHashMap<>();
        tunable.forEach(each -> out.put(each.name(), each.start().orElseThrow()));
        return out;
    }

    /** The unit of a tunable parameter as it is declared; empty where none is. */
    public String unitOf(String parameter) {
        return variable(parameter).unit().name();
    }

    /** Inputs that are forces and were not recorded: where one may act that was left out. */
    public List<String> places() {
        return wiring.places().stream().map(Variable::name).toList();
    }

    /** Channels that were recorded and drive it. */
    public List<Channel> inputs() {
        return wired.stream().map(wiring.inputs()::get).toList();
    }

    /** Channels that it gives, whether they were recorded or not. */
    public List<Channel> outputs() {
        return List.copyOf(wiring.outputs().values());
    }

    /** What it is and what was assumed, a line each; how fine its steps are once it has run. */
    public List<String> notes() {
        List<String> notes = new ArrayList<>();
        notes.add(String.format(Locale.ROOT, "%s: FMI %d.0 %s '%s'%s", name, unit.version(),
                ownSteps() ? "co-simulation" : "model exchange", unit.model(), fineness.map(this::words).orElse("")));
        notes.addAll(wiring.notes());
        notes.add(tunable.isEmpty() ? "no tunable parameter: its values are taken as right"
                : "tunable, and so perhaps wrong: " + String.join(", ", parameters().keySet()));
        return List.copyOf(notes);
    }

    private String words(Fineness chosen) {
        return chosen.parts() == 0 ? String.format(Locale.ROOT, ", in its own steps of %.3g s", chosen.step())
                : String.format(Locale.ROOT, ", %d steps a sample; twice as many change its outputs by %.1g of their root mean square",
                        chosen.parts(), change);
    }

    private boolean ownSteps() {
        return unit.coSimulation().isPresent();
    }

    /**
     * Runs it over the whole recording.
     *
     * @param values of tunable parameters by name; those left out keep their start values
     * @return its outputs by channel on the recording's clock, in SI units
     * @throws DataFault if a call of it fails or its outputs leave all bounds
     */
    public Recording run(Map<String, Double> values) {
        return run(values, recording.length());
    }

    /** The same for the first samples alone. */
    public Recording run(Map<String, Double> values, int samples) {
        double[][] found = outputs(values, List.of(), List.of(), samples);
        Map<Channel, double[]> out = new LinkedHashMap<>();
        int o = 0;
        for (Channel channel : wiring.outputs().values()) {
            out.put(channel, found[o++]);
        }
        return new Recording(recording.clock(), out, Metadata.NONE);
    }

    /**
     * What a force would change that acts at a place beside all else.
     *
     * @param place one of {@link #places}
     * @param force [N], as long as the recording. Not modified.
     * @return by output the difference to the run without it, a series in its own unit, in the order of {@link #outputs}
     */
    public double[][] pushed(String place, double[] force) {
        Variable at = wiring.places().stream().filter(each -> each.name().equals(place)).findFirst()
                .orElseThrow(() -> new IllegalArgumentException("there are the places " + places() + ": " + place));
        double[][] with = outputs(Map.of(), List.of(at), List.of(new InputSignal(force, recording.clock().rate(), false)),
                recording.length());
        return less(with, outputs(Map.of(), List.of(), List.of(), recording.length()), 1);
    }

    /**
     * How outputs follow parameters: central differences of whole runs, each parameter changed by a thousandth.
     *
     * @param at values by name; those left out have their start values
     * @param of names of the parameters
     * @param samples from the start
     * @return by parameter, output and sample: SI units of the output per unit of the parameter
     */
    public double[][][] sensitivities(Map<String, Double> at, List<String> of, int samples) {
        Map<String, Double> all = new LinkedHashMap<>(parameters());
        all.putAll(at);
        double[][][] out = new double[of.size()][][];
        for (int p = 0; p < of.size(); p++) {
            double value = all.get(of.get(p));
            double step = DIFFERENCE * scale(of.get(p));
            double[][] up = changed(all, of.get(p), value + step, samples);
            out[p] = less(up, changed(all, of.get(p), value - step, samples), 1 / (2 * step));
        }
        return out;
    }

    /** What a parameter is counted in: its start value, or 1 where that is 0. */
    double scale(String parameter) {
        double start = Math.abs(variable(parameter).start().orElseThrow());
        return start > 0 ? start : 1;
    }

    /**
     * As {@link #sensitivities}, by differences to a run that is known: half the runs, an order less exact.
     *
     * @param from outputs at the values
     */
    double[][][] slopes(Map<String, Double> at, double[][] from, List<String> of, int samples) {
        Map<String, Double> all = new LinkedHashMap<>(parameters());
        all.putAll(at);
        double[][][] out = new double[of.size()][][];
        for (int p = 0; p < of.size(); p++) {
            double step = DIFFERENCE * scale(of.get(p));
            out[p] = less(changed(all, of.get(p), all.get(of.get(p)) + step, samples), from, 1 / step);
        }
        return out;
    }

    private double[][] changed(Map<String, Double> all, String parameter, double value, int samples) {
        Map<String, Double> values = new LinkedHashMap<>(all);
        values.put(parameter, value);
        return outputs(values, List.of(), List.of(), samples);
    }

    private static double[][] less(double[][] a, double[][] b, double factor) {
        double[][] out = new double[a.length][];
        for (int o = 0; o < a.length; o++) {
            out[o] = new double[a[o].length];
            for (int i = 0; i < out[o].length; i++) {
                out[o][i] = factor * (a[o][i] - b[o][i]);
            }
        }
        return out;
    }

    private Variable variable(String parameter) {
        return tunable.stream().filter(each -> each.name().equals(parameter)).findFirst()
                .orElseThrow(() -> DataFault.in(name, "has no tunable parameter " + parameter + "; there are " + parameters().keySet()));
    }

    /**
     * In SI units.
     *
     * @param more inputs beside those that are wired
     * @param driven by these, in SI units
     */
    private double[][] outputs(Map<String, Double> values, List<Variable> more, List<InputSignal> driven, int samples) {
        if (fineness.isEmpty()) {
            fineness = Optional.of(chosen());
        }
        double[][] out = raw(values, more, driven, samples, fineness.get());
        int o = 0;
        for (Variable output : wiring.outputs().keySet()) {
            double[] series = out[o++];
            for (int i = 0; i < series.length; i++) {
                if (!Double.isFinite(series[i])) {
                    throw DataFault.in(name, String.format(Locale.ROOT, "its outputs leave all bounds %.4g s after its start",
                            i / recording.clock().rate()));
                }
                series[i] = output.unit().toSi(series[i]);
            }
        }
        return out;
    }

    /** Halves the step until that changes nothing, on the first samples. */
    private Fineness chosen() {
        double rate = recording.clock().rate();
        OptionalDouble own = unit.coSimulation()
                .map(kind -> kind.fixedStep().isPresent() ? kind.fixedStep() : kind.variableStep() ? OptionalDouble.empty() : unit.step())
                .orElse(OptionalDouble.empty());
        if (own.isPresent() && own.getAsDouble() > 0) {
            double step = own.getAsDouble();
            if (step > 1 / rate) {
                throw DataFault.in(name, String.format(Locale.ROOT,
                        "steps by %.4g s alone, the recording by %.4g s; export it with a smaller step", step, 1 / rate));
            }
            return new Fineness(step * Math.max(1, Math.floor(1 / (OWN_STEPS * rate * step))), 0);
        }
        int samples = Math.min(TRIED, recording.length());
        double[][] coarse = raw(Map.of(), List.of(), List.of(), samples, Fineness.of(rate, FIRST));
        double before = Double.POSITIVE_INFINITY;
        for (int parts = 2 * FIRST; true; parts *= 2) {
            double[][] fine = raw(Map.of(), List.of(), List.of(), samples, Fineness.of(rate, parts));
            double difference = difference(coarse, fine);
            change = difference;
            boolean stuck = difference < 1 && difference > before / SHRINKS;
            if (difference < ENOUGH || stuck || 2 * parts > MOST) {
                // Half as many would do, but for one that the change is known of.
                return Fineness.of(rate, parts);
            }
            before = difference;
            coarse = fine;
        }
    }

    /** Largest root mean square of a difference over that of the output; infinite where one is not finite. */
    private static double difference(double[][] coarse, double[][] fine) {
        double largest = 0;
        for (int o = 0; o < fine.length; o++) {
            double sum = 0;
            double whole = 0;
            for (int i = 0; i < fine[o].length; i++) {
                sum += (coarse[o][i] - fine[o][i]) * (coarse[o][i] - fine[o][i]);
                whole += fine[o][i] * fine[o][i];
            }
            double relative = sum == 0 ? 0 : Math.sqrt(sum / whole);
            largest = Double.isNaN(relative) ? Double.POSITIVE_INFINITY : Math.max(largest, relative);
        }
        return largest;
    }

    /** In the unit's own units. */
    private double[][] raw(Map<String, Double> values, List<Variable> more, List<InputSignal> driven, int samples, Fineness steps) {
        values.keySet().forEach(this::variable);
        // All of them: what is described counts, whatever the binary begins with.
        VariableBlock parameters = VariableBlock.of(tunable);
        parameters.write(tunable.stream().mapToDouble(each -> values.getOrDefault(each.name(), each.start().orElseThrow())).toArray());
        List<Variable> entries = new ArrayList<>(wired);
        entries.addAll(more);
        List<InputSignal> all = new ArrayList<>(signals);
        all.addAll(driven);
        List<Variable> read = List.copyOf(wiring.outputs().keySet());
        double rate = recording.clock().rate();
        try (Instance instance = instance(entries.size())) {
            Run run = ownSteps() ? new CoSimulationRun(instance, rate, entries, all, read, interpolating(instance))
                    : new ModelExchangeRun(instance, binary, unit, rate, entries, all, read);
            run.prepare(signal -> signal.at(0));
            // A step beyond the last sample where the unit's own steps do not divide it.
            instance.begin((samples + 1) / rate, parameters, run.inputs);
            return run.outputs(samples, steps);
        } catch (IOException failed) {
            throw DataFault.in(name, "its resources cannot be laid out: " + failed.getMessage(), failed);
        }
    }

    private Optional<Instance.Interpolating> interpolating(Instance instance) {
        return unit.coSimulation().orElseThrow().interpolates() && instance instanceof Instance.Interpolating able ? Optional.of(able)
                : Optional.empty();
    }

    private Instance instance(int inputs) throws IOException {
        Instance.Way way = ownSteps() ? Instance.Way.CO_SIMULATION : Instance.Way.MODEL_EXCHANGE;
        Path resources = unpacked.resources();
        if (unit.version() == 3) {
            return new Fmi3Instance(binary, unit, way, resources);
        }
        // As file:///, which is what units take apart.
        String uri = resources.toUri().toString();
        return new Fmi2Instance(binary, unit, way, URI.create(uri.endsWith("/") ? uri.substring(0, uri.length() - 1) : uri), inputs);
    }

    /** Unloads the unit and removes what was unpacked. */
    @Override
    public void close() {
        binary.close();
        unpacked.close();
    }
}
