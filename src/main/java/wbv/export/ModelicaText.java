package wbv.export;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.LawAt;
import wbv.body.Model;
import wbv.body.SensorFault;
import wbv.body.Structure;
import wbv.body.law.Law;
import wbv.body.number.Modulator;
import wbv.recording.DataFault;

/** A model as Modelica: one flat model of plain equations, no library. Laws with memory stand there as differential equations. */
final class ModelicaText {

    private final Model model;
    private final Assembly assembly;
    private final Structure structure;
    private final Names names;
    private final StepInputs signals;
    private final Set<String> taken = new LinkedHashSet<>();
    private final Map<String, String> inputs = new HashMap<>();
    private final List<String> bodies;
    private final List<String> links;
    private final StringBuilder declared = new StringBuilder();
    private final StringBuilder initially = new StringBuilder();
    private final StringBuilder equations = new StringBuilder();

    private ModelicaText(Model model) {
        this.model = model;
        this.assembly = model.assembly();
        this.structure = assembly.structure();
        this.names = Names.of(model);
        this.signals = StepInputs.of(model, "Modelica");
        taken.add("time");
        signals.names().forEach(name -> inputs.put(name, identifier(name)));
        bodies = names.bodies().stream().map(this::identifier).toList();
        links = names.links().stream().map(this::identifier).toList();
    }

    static String of(Model model) {
        ModelicaText text = new ModelicaText(model);
        String name = text.identifier("Model " + model.name());
        text.base();
        text.structure();
        IntStream.range(0, text.assembly.laws().size()).forEach(text::law);
        text.forces();
        text.sensors();
        return "model " + name + " \"" + Names.plain(model.name()) + ": a lumped model of vibration along " + model.axis() + "\"\n"
                + text.declared + (text.initially.isEmpty() ? "" : "initial equation\n" + text.initially) + "equation\n"
                + text.equations + "end " + name + ";\n";
    }

    /** A name of its own that Modelica can read. */
    private String identifier(String name) {
        String plain = name.replaceAll("[^A-Za-z0-9]+", "_").replaceAll("^(?=[^A-Za-z])", "x");
        String own = plain;
        for (int i = 2; taken.contains(own.toLowerCase(Locale.ROOT)); i++) {
            own = plain + "_" + i;
        }
        taken.add(own.toLowerCase(Locale.ROOT));
        return own;
    }

    private void base() {
        signals.units().forEach((name, unit) -> declare("input Real " + inputs.get(name), unit, name));
        if (!structure.held() && model.base().sensor().isPresent()) {
            declare("Real base_velocity(start = 0, fixed = true)", "m/s", "of the base " + model.base().name());
            declare("Real base_position(start = 0, fixed = true)", "m", "of the base " + model.base().name());
            equation("der(base_velocity) = " + inputs.get(signals.names().get(0)));
            equation("der(base_position) = base_velocity");
        }
    }

    private void structure() {
        for (int b = 0; b < structure.bodies() && !structure.held(); b++) {
            String id = bodies.get(b);
            declare("parameter Real m_" + id + " = " + structure.mass()[b], "kg", "mass of " + names.bodies().get(b));
            declare("Real q_" + id + "(start = 0, fixed = true)", "m", "displacement against the base");
            double launch = 0;
            for (Assembly.DriveAt at : assembly.drives()) {
                launch += at.drive() instanceof Drive.Launch own && at.place() == b ? own.velocity() : 0;
            }
            declare("Real v_" + id + "(start = " + launch + ", fixed = true)", "m/s", "speed against the base");
            equation("der(q_" + id + ") = v_" + id);
        }
        for (int l = 0; l < structure.links(); l++) {
            String id = links.get(l);
            declare("parameter Real k_" + id + " = " + structure.stiffness()[l], "N/m", "stiffness of " + names.links().get(l));
            declare("parameter Real c_" + id + " = " + structure.damping()[l], "N.s/m", "damping of " + names.links().get(l));
            declare("Real r_" + id, "m", "deflection, positive in extension");
            declare("Real s_" + id, "m/s", "its speed");
            declare("Real load_" + id, "N", "force of spring, dashpot and laws, pulling the ends together");
            declare("Real force_" + id, "N", "the same with what drives it");
            equation("r_" + id + " = "
                    + (structure.held() ? "-" + inputs.get(signals.names().get(0)) : apart("q_", l) + lifted(l, this::risen)));
            equation("s_" + id + " = " + (structure.held() ? "-" + inputs.get(signals.names().get(1))
                    : apart("v_", l) + lifted(l, rotation -> inputs.get(rotation.rate().toString()))));
        }
    }

    /** What rotation lifts a link's lower end by is what the link is the shorter by. */
    private String lifted(int link, Function<Drive.Rotation, String> turned) {
        StringBuilder by = new StringBuilder();
        for (int d = 0; d < assembly.drives().size(); d++) {
            if (assembly.drives().get(d).place() == link && assembly.drives().get(d).drive() instanceof Drive.Rotation rotation) {
                by.append(" - drive").append(d).append("_lever_arm_m * ").append(turned.apply(rotation));
            }
        }
        return by.toString();
    }

    /** An angle since the start. */
    private String risen(Drive.Rotation rotation) {
        String angle = inputs.get(StepInputs.angle(rotation.rate()));
        String start = "start_" + angle;
        if (taken.add(start)) {
            declare("parameter Real " + start + "(fixed = false)", "rad", "where it is at the start");
            initially.append("  ").append(start).append(" = ").append(angle).append(";\n");
        }
        return "(" + angle + " - " + start + ")";
    }

    private String apart(String what, int link) {
        int from = structure.from()[link];
        return what + bodies.get(structure.to()[link]) + (from < 0 ? "" : " - " + what + bodies.get(from));
    }

    private void law(int i) {
        LawAt at = assembly.laws().get(i);
        Law law = at.law();
        LawForm form = LawForm.of(law);
        String own = "law" + i + "_";
        String link = links.get(at.link());
        boolean remembers = form.flow().stream().anyMatch(line -> line.name().equals("rate"));
        form.constants()
                .forEach((name, value) -> declare("parameter Real " + own + name + " = " + value, "",
                        name.equals(form.constants().keySet().iterator().next())
                                ? law.mechanism() + " in " + names.links().get(at.link()) : ""));
        if (remembers) {
            declare("parameter Real " + own + "memory_at_start = 0", "", "where it carries a force at rest");
            declare("Real " + own + "memory(start = " + own + "memory_at_start, fixed = true)", "", "what the law remembers");
        }
        Set<String> asked = LawForm.asked(form.flow(), form.constants());
        if (asked.contains("modulation")) {
            declare("Real " + own + "modulation", "", law.modulator().toString());
            equation(own + "modulation = " + value(law.modulator(), own));
        }
        UnaryOperator<String> rename = name -> switch (name) {
            case "r", "k", "c" -> name + "_" + link;
            case "v" -> "s_" + link;
            case "a" -> "der(s_" + link + ")";
            case "t" -> "time";
            case "late_r" -> "delay(r_" + link + ", " + own + "delay_s)";
            case "late_v" -> "delay(s_" + link + ", " + own + "delay_s)";
            case "pi" -> "pi";
            default -> own + name;
        };
        for (LawForm.Line line : form.flow()) {
            declare("Real " + own + line.name(), line.name().equals("force") ? "N" : "", "");
            equation(own + line.name() + " = " + Language.MODELICA.of(line.value().renamed(rename)));
        }
        if (remembers) {
            equation("der(" + own + "memory) = " + own + "rate");
        }
    }

    private String value(Modulator modulator, String own) {
        if (modulator instanceof Modulator.Ride ride) {
            declare("Real " + own + "square(start = 0, fixed = true)", "", "how hard the base was shaken of late, squared");
            equation("der(" + own + "square) = ("
                    + (structure.held() || model.base().sensor().isEmpty() ? "0" : inputs.get(signals.names().get(0)) + " ^ 2") + " - "
                    + own + "square) / " + ride.seconds());
            return "sqrt(max(0, " + own + "square))";
        }
        if (modulator instanceof Modulator.OtherLink other) {
            String link = links.get(other.link());
            return switch (other.of()) {
                case LOAD -> "load_" + link;
                case DEFLECTION -> "r_" + link;
                case SPEED -> "s_" + link;
            };
        }
        if (modulator instanceof Modulator.PartOf part) {
            String whole = value(part.whole(), own);
            return switch (part.part()) {
                case MAGNITUDE -> "abs(" + whole + ")";
                case POSITIVE -> "max(0, " + whole + ")";
                case NEGATIVE -> "max(0, -" + whole + ")";
            };
        }
        if (modulator instanceof Modulator.Level level) {
            return "max(-1, min(1, (2 * " + inputs.get(level.channel().toString()) + " - (" + (level.low() + level.high()) + ")) / "
                    + (level.high() - level.low()) + "))";
        }
        return StepInputs.named(modulator) ? inputs.get(modulator.toString()) : "1";
    }

    private void forces() {
        List<StringBuilder> onBody = new ArrayList<>();
        List<StringBuilder> inLink = new ArrayList<>();
        bodies.forEach(body -> onBody.add(new StringBuilder()));
        links.forEach(link -> inLink.add(new StringBuilder("load_" + link)));
        for (int d = 0; d < assembly.drives().size(); d++) {
            Assembly.DriveAt at = assembly.drives().get(d);
            String own = "drive" + d + "_";
            if (!(at.drive() instanceof Drive.Launch)) {
                LawForm.constants((Record) at.drive())
                        .forEach((name, value) -> declare("parameter Real " + own + name + " = " + value, "", at.drive().mechanism()));
                drive(at.drive(), own)
                        .ifPresent(force -> (at.drive().actsOnBody() ? onBody : inLink).get(at.place()).append(" + ").append(force));
            }
        }
        for (int l = 0; l < links.size(); l++) {
            StringBuilder load = new StringBuilder("load_" + links.get(l) + " = k_" + links.get(l) + " * r_" + links.get(l) + " + c_"
                    + links.get(l) + " * s_" + links.get(l));
            for (int i = 0; i < assembly.laws().size(); i++) {
                load.append(assembly.laws().get(i).link() == l ? " + law" + i + "_force" : "");
            }
            equation(load.toString());
            equation("force_" + links.get(l) + " = " + inLink.get(l));
        }
        for (int b = 0; b < bodies.size() && !structure.held(); b++) {
            declare("Real a_" + bodies.get(b), "m/s2", "acceleration of " + names.bodies().get(b));
            StringBuilder sum = new StringBuilder("m_" + bodies.get(b) + " * a_" + bodies.get(b) + " = 0");
            for (int l = 0; l < links.size(); l++) {
                sum.append(
                        structure.to()[l] == b ? " - force_" + links.get(l) : structure.from()[l] == b ? " + force_" + links.get(l) : "");
            }
            equation(sum.append(onBody.get(b)).toString());
            equation("der(v_" + bodies.get(b) + ") = a_" + bodies.get(b)
                    + (model.base().sensor().isPresent() ? " - " + inputs.get(signals.names().get(0)) : ""));
        }
    }

    /** Empty where it is no force. */
    private Optional<String> drive(Drive drive, String own) {
        if (drive instanceof Drive.Tone) {
            String phase = "(2 * 3.141592653589793 * " + own + "frequency_hz * time)";
            return Optional.of(own + "cosine_N * cos" + phase + " + " + own + "sine_N * sin" + phase);
        }
        if (drive instanceof Drive.Measured measured) {
            return Optional.of(inputs.get(measured.channel().toString()) + " - " + own + "offset_N");
        }
        if (drive instanceof Drive.Given given) {
            return Optional.of(own + "share * " + inputs.get(given.channel().toString()));
        }
        if (drive instanceof Drive.Across across) {
            return Optional.of(own + "coupled_mass_kg * " + inputs.get(across.across().toString()));
        }
        if (drive instanceof Drive.CrossAxis cross) {
            return Optional.of(own + "cross_stiffness_N_per_m * " + inputs.get(StepInputs.lean(cross.upper(), cross.lower())));
        }
        return Optional.empty();
    }

    private void sensors() {
        for (int o = 0; o < assembly.outputs().size(); o++) {
            Assembly.Output output = assembly.outputs().get(o);
            String id = identifier(model.outputs().get(o).toString());
            boolean base = model.base().sensor().isPresent();
            String reading = switch (output.reading()) {
                case ACCELERATION -> "a_" + bodies.get(output.place());
                case VELOCITY -> "v_" + bodies.get(output.place()) + (base ? " + base_velocity" : "");
                case POSITION -> "q_" + bodies.get(output.place()) + (base ? " + base_position" : "");
                case LINK_FORCE -> "force_" + links.get(output.place());
            };
            for (int f = 0; f < output.faults().size(); f++) {
                reading = fault(output.faults().get(f), reading, "sensor" + o + "_fault" + f + "_");
            }
            declare("output Real " + id, model.outputs().get(o).quantity().unit().replace("²", "2"), model.outputs().get(o).toString());
            equation(id + " = " + reading);
        }
    }

    private String fault(SensorFault fault, String reading, String own) {
        LawForm.constants((Record) fault)
                .forEach((name, value) -> declare("parameter Real " + own + name + " = " + value, "", fault.mechanism()));
        declare("Real " + own + "reading", "", "what the sensor should read");
        equation(own + "reading = " + reading);
        String y = own + "reading";
        if (fault instanceof SensorFault.MountResonance) {
            declare("Real " + own + "x(start = 0, fixed = true)", "", "state of the mount");
            declare("Real " + own + "y(start = 0, fixed = true)", "", "its derivative");
            declare("parameter Real " + own + "w = 2 * 3.141592653589793 * " + own + "frequency_hz", "rad/s", "");
            equation("der(" + own + "x) = " + own + "y");
            equation("der(" + own + "y) = " + y + " - " + own + "w ^ 2 * " + own + "x - 2 * " + own + "damping_ratio * " + own + "w * "
                    + own + "y");
            return own + "w ^ 2 * " + own + "x + 2 * " + own + "damping_ratio * " + own + "w * " + own + "y";
        }
        if (fault instanceof SensorFault.StiffeningMount) {
            declare("Real " + own + "x(start = 0, fixed = true)", "m", "stretch of the mount");
            declare("Real " + own + "y(start = 0, fixed = true)", "m/s", "its speed");
            declare("Real " + own + "bend", "m/s2", "what the mount passes on");
            declare("parameter Real " + own + "w = 2 * 3.141592653589793 * " + own + "frequency_hz", "rad/s", "");
            equation(own + "bend = 0 - 2 * " + own + "damping_ratio * " + own + "w * " + own + "y - " + own + "w ^ 2 * " + own + "x * (1 + "
                    + own + "cubic_per_m2 * "
                    + own + "x ^ 2)");
            equation("der(" + own + "x) = " + own + "y");
            equation("der(" + own + "y) = " + own + "bend - " + y);
            return own + "bend";
        }
        if (fault instanceof SensorFault.AcCoupling) {
            declare("Real " + own + "x(start = 0, fixed = true)", "", "what the coupling holds back");
            equation("der(" + own + "x) = 2 * 3.141592653589793 * " + own + "corner_hz * (" + y + " - " + own + "x)");
            return y + " - " + own + "x";
        }
        if (fault instanceof SensorFault.Delay delay) {
            return delay.drift() == 0 ? "delay(" + y + ", " + own + "delay_s)"
                    : "delay(" + y + ", " + own + "delay_s + " + own + "drift_s_per_s * time, " + own
                            + "delay_s + 36000 * " + own + "drift_s_per_s)";
        }
        if (fault instanceof SensorFault.WanderingDelay late) {
            String phase = "(2 * 3.141592653589793 * " + own + "wandering_hz * time)";
            return "delay(" + y + ", " + own + "delay_s + " + own + "cosine_s * cos" + phase + " + " + own + "sine_s * sin" + phase + ", "
                    + (late.delay() + late.swing()) + ")";
        }
        if (fault instanceof SensorFault.Gain) {
            return own + "factor * " + y;
        }
        if (fault instanceof SensorFault.Bias) {
            return y + " + " + own + "bias";
        }
        if (fault instanceof SensorFault.Beside beside) {
            return y + " + " + inputs.get(beside.channel().toString());
        }
        if (fault instanceof SensorFault.Clipping) {
            return "max(" + own + "low, min(" + own + "high, " + y + "))";
        }
        if (fault instanceof SensorFault.LeverArm lever) {
            return y + " + " + own + "lever_arm_m * " + inputs.get(StepInputs.angularAcceleration(lever.rate()));
        }
        if (fault instanceof SensorFault.Misalignment tilt) {
            return y + " * sqrt(1 + tan(" + own + "towards_x_rad) ^ 2 + tan(" + own + "towards_y_rad) ^ 2) + "
                    + inputs.get(tilt.across().toString()) + " * tan("
                    + own + "towards_x_rad) + " + inputs.get(tilt.beside().toString()) + " * tan(" + own + "towards_y_rad)";
        }
        if (fault instanceof SensorFault.Turned turned) {
            return y + " / cos(" + own + "angle_rad) + " + inputs.get(turned.across().toString()) + " * tan(" + own + "angle_rad)";
        }
        if (fault instanceof SensorFault.Quantised) {
            return own + "level + " + own + "step * floor((" + y + " - " + own + "level) / " + own + "step + 0.5)";
        }
        if (fault instanceof SensorFault.Rectifying) {
            return "abs(" + y + ")";
        }
        throw new DataFault("Modelica has no form here of the sensor fault " + fault.mechanism() + "; --to python has");
    }

    /** @param unit empty for none */
    private void declare(String what, String unit, String meaning) {
        String text = what;
        if (!unit.isEmpty()) {
            String named = "unit = \"" + unit + "\"";
            int space = what.indexOf(" = ");
            int open = what.indexOf('(');
            text = open > 0 ? what.substring(0, open + 1) + named + ", " + what.substring(open + 1)
                    : space < 0 ? what + "(" + named + ")" : what.substring(0, space) + "(" + named + ")" + what.substring(space);
        }
        declared.append("  ").append(text).append(meaning.isEmpty() ? "" : " \"" + Names.plain(meaning) + "\"").append(";\n");
    }

    private void equation(String text) {
        equations.append("  ").append(text).append(";\n");
    }
}
