package wbv.export;

import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.LawAt;
import wbv.body.Model;
import wbv.body.SensorFault;
import wbv.body.Structure;
import wbv.body.number.Key;
import wbv.body.number.Modulator;

/** A model as a Python file that needs NumPy alone and does what {@code wbv simulate} does. */
final class PythonText {

    private static final List<
            String> MOTION = List.of("r", "v", "r_before", "memory", "t", "h", "k", "c", "modulation", "late_r", "late_v");

    private final Model model;
    private final Assembly assembly;
    private final Structure structure;
    private final Names names;
    /** Those that stand in the file. */
    private final List<LawAt> laws;
    private final StringBuilder out = new StringBuilder();

    private PythonText(Model model, List<LawAt> laws) {
        this.model = model;
        this.assembly = model.assembly();
        this.structure = assembly.structure();
        this.names = Names.of(model);
        this.laws = laws;
    }

    static String of(Model model) {
        Assembly assembly = model.assembly();
        boolean linear = !assembly.structure().held() && assembly.laws().stream().allMatch(at -> at.law().isLinear());
        PythonText text = new PythonText(model, linear ? List.of() : assembly.laws());
        text.head("a lumped model of vibration along " + model.axis() + ", as a Python function",
                "does what 'wbv simulate --model' does. It needs NumPy and nothing else");
        text.model();
        text.simulate();
        return text.out + "\n\n" + Parts.usedBy(text.out + "main", "runtime.py");
    }

    /**
     * What MuJoCo has not, for a model in an XML file.
     *
     * @param laws that MuJoCo has not
     */
    static String besideMujoco(Model model, List<LawAt> laws, String file) {
        PythonText text = new PythonText(model, laws);
        text.head("what " + file + " has not, for MuJoCo", "needs NumPy and mujoco (pip install mujoco)");
        text.line("\nAXIS = " + "xyz".indexOf(model.axis()));
        text.model();
        text.begin();
        text.line("    import os");
        text.line("    file = os.path.join(os.path.dirname(os.path.abspath(__file__)), " + quoted(file) + ")");
        text.line("    return in_mujoco(x, file, " + (laws.isEmpty() ? "[], []" : "LAWS, modulators()") + ", drives(x), SENSORS)");
        String runtime = Parts.usedBy(text.out.toString(), "mujoco.py");
        return text.out + "\n\n" + runtime.strip() + "\n\n\n" + Parts.usedBy(text.out + runtime + "main", "runtime.py");
    }

    private void model() {
        numbers();
        laws();
        drives();
        sensors();
    }

    /**
     * @param purpose behind the model's name
     * @param need of the file
     */
    private void head(String purpose, String need) {
        String inputs = model.excitations().stream().map(Object::toString).collect(Collectors.joining(", "));
        line("\"\"\"" + Names.plain(model.name()) + ": " + purpose + ".");
        line("");
        model.source().ifPresent(source -> line(Names.plain(source) + "\n"));
        line("    rate, time, channels = read_recording(\"recording.csv\")");
        line("    outputs = simulate(rate, channels)      # one array for each of OUTPUTS, at the times of the recording");
        line("");
        line("or, from a shell: python3 THIS_FILE.py recording.csv simulated.csv");
        line("It is driven by " + inputs + " and " + need + ". All numbers are SI.\"\"\"");
        line("import math");
        line("");
        line("import numpy as np");
    }

    private void numbers() {
        line("\n# Bodies.");
        line("MASS = np.array([");
        for (int b = 0; b < structure.bodies(); b++) {
            line("    " + structure.mass()[b] + ",  # [kg] " + b + ": " + Names.plain(names.bodies().get(b)));
        }
        line("])");
        line("\n# Links: lower and upper end as numbers of bodies, -1 is the base '" + Names.plain(model.base().name()) + "'.");
        line("LINKS = [");
        each(l -> "(" + structure.from()[l] + ", " + structure.to()[l] + "),  # " + l + ": " + Names.plain(names.links().get(l)));
        line("]");
        line("STIFFNESS = [");
        each(l -> structure.stiffness()[l] + ",  # [N/m] " + Names.plain(names.links().get(l)));
        line("]");
        line("DAMPING = [");
        each(l -> structure.damping()[l] + ",  # [N s/m] " + Names.plain(names.links().get(l)));
        line("]");
        line("OUTPUTS = [" + model.outputs().stream().map(channel -> quoted(channel.toString())).collect(Collectors.joining(", ")) + "]");
    }

    private void each(java.util.function.IntFunction<String> text) {
        IntStream.range(0, structure.links()).forEach(l -> line("    " + text.apply(l)));
    }

    private void laws() {
        if (laws.isEmpty()) {
            return;
        }
        for (int i = 0; i < laws.size(); i++) {
            law(out, i, laws.get(i), names, structure.held());
        }
        line("\n\n# Link, force, how long ago the motion was that it answers [s]"
                + (structure.held() ? ", memory for a force at the start." : "."));
        line("LAWS = [");
        for (int i = 0; i < laws.size(); i++) {
            LawAt at = laws.get(i);
            line("    (" + at.link() + ", law_" + i + ", " + at.law().lateness()
                    + (structure.held() ? ", " + (at.law().hasMemory() ? "start_" + i : "None") : "") + "),");
        }
        line("]");
        line("\n\ndef modulators():");
        line("    \"\"\"What each law is multiplied by beside the motion of its own link.\"\"\"");
        line("    return [");
        laws.forEach(at -> line("        " + modulator(at.law().modulator()) + ",  # " + Names.plain(at.law().modulator().toString())));
        line("    ]");
    }

    /**
     * A law as a function of the motion that gives force and memory.
     *
     * @param starts whether also what it remembers where it carries a force
     */
    static void law(StringBuilder out, int i, LawAt at, Names names, boolean starts) {
        LawForm form = LawForm.of(at.law());
        out.append("\n\ndef law_").append(i).append("(motion):\n    \"\"\"Force [N] of ").append(at.law().mechanism()).append(" in ")
                .append(Names.plain(names.links().get(at.link()))).append(", and what it remembers.\"\"\"\n");
        form.constants().forEach((name, value) -> out.append("    ").append(name).append(" = ").append(value).append('\n'));
        Set<String> asked = LawForm.asked(form.steps(), form.constants());
        List<String> motion = MOTION.stream().filter(asked::contains).toList();
        if (!motion.isEmpty()) {
            out.append("    ").append(String.join(", ", motion)).append(" = ")
                    .append(motion.stream().map(name -> "motion." + name).collect(Collectors.joining(", ")))
                    .append('\n');
        }
        form.steps().forEach(
                line -> out.append("    ").append(line.name()).append(" = ").append(Language.PYTHON.of(line.value())).append('\n'));
        out.append("    return force, ").append(at.law().hasMemory() ? "remembered" : "0.0").append('\n');
        if (starts && at.law().hasMemory()) {
            out.append("\n\ndef start_").append(i).append("(force):\n    \"\"\"Its memory where it carries a force at rest.\"\"\"\n");
            form.constants().forEach((name, value) -> out.append("    ").append(name).append(" = ").append(value).append('\n'));
            out.append("    return ").append(Language.PYTHON.of(form.start().orElseThrow())).append('\n');
        }
    }

    private void drives() {
        line("\n\ndef drives(x):");
        line("    \"\"\"Beside base and laws, as spectra: forces on bodies or pulling links together [N], and what lifts links [m].\"\"\"");
        line("    return [");
        for (Assembly.DriveAt at : assembly.drives()) {
            Drive drive = at.drive();
            String kind = drive instanceof Drive.Launch ? "launch"
                    : drive instanceof Drive.Rotation ? "lift" : drive.actsOnBody() ? "body" : "link";
            line("        (" + quoted(kind) + ", " + at.place() + ", " + call("x", (Record) drive) + "),  # "
                    + Names.plain((drive.actsOnBody() ? names.bodies() : names.links()).get(at.place())));
        }
        line("    ]");
    }

    private void sensors() {
        for (int o = 0; o < assembly.outputs().size(); o++) {
            line("\n\ndef sensor_" + o + "(x, reading):");
            line("    \"\"\"What the sensor " + model.outputs().get(o) + " makes of the true reading, both as spectra.\"\"\"");
            for (SensorFault fault : assembly.outputs().get(o).faults()) {
                line("    reading = " + call("x, reading", (Record) fault));
            }
            line("    return reading");
        }
        line("\n\n# Number of the body or the link, " + (structure.held() ? "channel, its bias" : "what is read there")
                + ", what the sensor makes of it.");
        line("SENSORS = [");
        for (int o = 0; o < assembly.outputs().size(); o++) {
            Assembly.Output output = assembly.outputs().get(o);
            double bias = output.faults().stream().filter(fault -> fault instanceof SensorFault.Bias)
                    .mapToDouble(fault -> ((SensorFault.Bias) fault).bias()).sum();
            String reading = output.reading() == Assembly.Reading.LINK_FORCE ? "force" : output.reading().name().toLowerCase(Locale.ROOT);
            line("    (" + output.place() + ", "
                    + (structure.held() ? quoted(model.outputs().get(o).toString()) + ", " + bias : quoted(reading)) + ", sensor_" + o
                    + "),");
        }
        line("]");
    }

    /** Down to the excitation x. */
    private void begin() {
        line("\n\ndef simulate(rate, channels):");
        line("    \"\"\"What the sensors read.");
        line("");
        line("    rate: samples per second [Hz]; channels: arrays of one length by name, NaN where a sample is missing, such as "
                + model.excitations().get(0) + ".\"\"\"");
        if (structure.held()) {
            return;
        }
        if (model.inputs().isEmpty()) {
            line("    x = moved_base(rate, channels, " + quoted(model.base().sensor().orElseThrow().toString())
                    + model.base().filter().map(filter -> ", of_rate=" + filter.ofRate() + ", gain=" + filter.gain()).orElse("") + ")");
        } else {
            line("    still = np.zeros(len(channels[" + quoted(model.excitations().get(0).toString()) + "]))");
            line("    x = Excitation(rate, still, channels, finer=4, pushing=["
                    + model.excitations().stream().map(channel -> quoted(channel.toString())).collect(Collectors.joining(", ")) + "])");
        }
    }

    private void simulate() {
        begin();
        String given = laws.isEmpty() ? "[], []" : "LAWS, modulators()";
        if (structure.held()) {
            line("    return driven(rate, channels, " + quoted(model.base().sensor().orElseThrow().toString()) + ", " + given
                    + ", drives, SENSORS)");
            return;
        }
        line("    further = [0.0] * len(LINKS)  # dynamic stiffness of linear laws [N/m]");
        for (LawAt at : laws.isEmpty() ? assembly.laws() : List.<LawAt>of()) {
            line("    further[" + at.link() + "] = further[" + at.link() + "] + "
                    + call(Names.snake(at.law()) + "_stiffness", "x.omega", (Record) at.law()));
        }
        boolean free = IntStream.range(0, structure.bodies()).anyMatch(b -> structure.unheld()[b]);
        line("    return run(x, " + (free ? "LinearFree" : "Linear") + ", further, " + given + ", drives(x), SENSORS)");
    }

    private static String modulator(Modulator modulator) {
        if (modulator instanceof Modulator.Measured measured) {
            return "measured_value(" + quoted(measured.channel().toString()) + ")";
        }
        if (modulator instanceof Modulator.Level level) {
            return "measured_level(" + quoted(level.channel().toString()) + ", " + level.low() + ", " + level.high() + ")";
        }
        if (modulator instanceof Modulator.Angle angle) {
            return "measured_angle(" + quoted(angle.rate().toString()) + ")";
        }
        if (modulator instanceof Modulator.Lean lean) {
            return "lean(" + quoted(lean.upper().toString()) + ", " + quoted(lean.lower().toString()) + ")";
        }
        if (modulator instanceof Modulator.Ride ride) {
            return "ride(" + ride.seconds() + ")";
        }
        if (modulator instanceof Modulator.OtherLink other) {
            return "other_link(" + quoted(other.of().name().toLowerCase(Locale.ROOT)) + ", " + other.link() + ")";
        }
        if (modulator instanceof Modulator.PartOf part) {
            return "part_of(" + quoted(part.part().name().toLowerCase(Locale.ROOT)) + ", " + modulator(part.whole()) + ")";
        }
        return "None";
    }

    /** The function of the same name with the record's values by their names. */
    private static String call(String first, Record record) {
        return call(Names.snake(record), first, record);
    }

    private static String call(String function, String first, Record record) {
        List<String> arguments = new ArrayList<>(List.of(first));
        for (RecordComponent component : record.getClass().getRecordComponents()) {
            Object value = LawForm.read(record, component);
            arguments.add(component.getAnnotation(Key.class).value() + "="
                    + (value instanceof Double ? value.toString() : quoted(value.toString())));
        }
        return function + "(" + String.join(", ", arguments) + ")";
    }

    private static String quoted(String text) {
        return "\"" + text + "\"";
    }

    private void line(String text) {
        out.append(text).append('\n');
    }
}
