package wbv.export;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.LawAt;
import wbv.body.Model;
import wbv.body.SensorFault;
import wbv.body.Structure;
import wbv.body.number.Modulator;
import wbv.recording.DataFault;

/** A model as one C file with the interface of a functional mock-up unit. */
final class CSource {

    private static final List<
            String> MOTION = List.of("r", "v", "r_before", "memory", "t", "h", "k", "c", "modulation", "late_r", "late_v");
    /** Longest step [s] where a communication step is longer. */
    private static final double STEP = 1.0 / 240;

    private final Model model;
    private final Assembly assembly;
    private final Structure structure;
    private final Names names;
    private final StepInputs signals;
    private final StringBuilder out = new StringBuilder();
    /** Value by name, in the order of their index. */
    private final Map<String, Double> parameters = new LinkedHashMap<>();

    CSource(Model model) {
        this.model = model;
        this.assembly = model.assembly();
        this.structure = assembly.structure();
        this.names = Names.of(model);
        this.signals = StepInputs.of(model, "an FMU");
        number();
    }

    StepInputs signals() {
        return signals;
    }

    /** What can be set before a run: value by name with its unit. */
    Map<String, Double> parameters() {
        return parameters;
    }

    private void number() {
        for (int b = 0; b < structure.bodies(); b++) {
            parameters.put(names.bodies().get(b) + ".mass_kg", structure.mass()[b]);
        }
        links("stiffness_N_per_m", structure.stiffness());
        links("damping_Ns_per_m", structure.damping());
        for (int i = 0; i < assembly.laws().size(); i++) {
            record("law_" + i, (Record) assembly.laws().get(i).law());
        }
        for (int d = 0; d < assembly.drives().size(); d++) {
            record("drive_" + d, (Record) assembly.drives().get(d).drive());
        }
        for (int o = 0; o < assembly.outputs().size(); o++) {
            List<SensorFault> faults = assembly.outputs().get(o).faults();
            for (int f = 0; f < faults.size(); f++) {
                record(fault(o, f), (Record) faults.get(f));
            }
        }
        for (int i = 0; i < assembly.laws().size(); i++) {
            if (carries(i)) {
                parameters.put("law_" + i + ".force_at_start_N", 0.0);
            }
        }
        parameters.put(structure.held() ? "step_s" : "longest_step_s", structure.held() ? 0.01 : STEP);
    }

    private void links(String what, double[] values) {
        for (int l = 0; l < structure.links(); l++) {
            parameters.put("link_" + l + "." + what, values[l]);
        }
    }

    private void record(String prefix, Record record) {
        LawForm.constants(record).forEach((key, value) -> parameters.put(prefix + "." + key, value));
    }

    private static String fault(int output, int fault) {
        return "sensor_" + output + ".fault_" + fault;
    }

    /** Whether a law of a driven link is the first with memory there, and so may carry a force at the start. */
    private boolean carries(int i) {
        LawAt at = assembly.laws().get(i);
        return structure.held() && at.law().hasMemory()
                && assembly.laws().subList(0, i).stream().noneMatch(before -> before.link() == at.link() && before.law().hasMemory());
    }

    private String p(String name) {
        return "p[" + new ArrayList<>(parameters.keySet()).indexOf(name) + "]";
    }

    private String u(String signal) {
        return "u[" + signals.names().indexOf(signal) + "]";
    }

    /** @param token by which the unit is known */
    String text(String token) {
        head(token);
        tables();
        for (int i = 0; i < assembly.laws().size(); i++) {
            law(i);
        }
        dispatch("law", "const double *p, const Motion *m, double *remembered", "p, m, remembered", "*remembered = 0; (void) p, (void) m;");
        dispatch("first_memory", "const double *p, double force", "p, force", "(void) p, (void) force;");
        dispatch("lateness", "const double *p", "p", "(void) p;");
        String runtime = Parts.text("fmu.c");
        String before = out.toString();
        out.setLength(0);
        modulate();
        drive();
        sense();
        return before + "\n" + runtime.replace("/*MODEL*/", out.toString().strip());
    }

    private void head(String token) {
        line("/* " + Names.plain(model.name()) + ": a lumped model of vibration along " + model.axis() + ". All numbers are SI. */");
        model.source().ifPresent(source -> line("/* " + Names.plain(source) + " */"));
        line("\n#include <math.h>\n#include <stdlib.h>\n#include <string.h>\n");
        line("#define TOKEN \"" + token + "\"");
        define("PI", "3.141592653589793");
        define("BODIES", structure.bodies());
        define("LINKS", structure.links());
        define("LAWS", assembly.laws().size());
        define("INPUTS", signals.names().size());
        define("OUTPUTS", assembly.outputs().size());
        define("PARAMETERS", parameters.size());
        define("MOUNTS", count(SensorFault.MountResonance.class) + count(SensorFault.StiffeningMount.class));
        define("COUPLINGS", count(SensorFault.AcCoupling.class));
        define("DELAYS", count(SensorFault.Late.class));
        define("DRIVEN", structure.held() ? 1 : 0);
        define("BASE_MOVES", model.base().sensor().isPresent() ? 1 : 0);
        define("REMEMBERS", count(SensorFault.Late.class) > 0 || assembly.laws().stream().anyMatch(at -> at.law().lateness() > 0) ? 1 : 0);
    }

    private long count(Class<?> fault) {
        return assembly.outputs().stream().flatMap(output -> output.faults().stream()).filter(fault::isInstance).count();
    }

    private void define(String name, Object value) {
        line("#define " + name + " " + value);
    }

    private void tables() {
        line("\nstatic const double VALUES[PARAMETERS] = {");
        List<String> keys = new ArrayList<>(parameters.keySet());
        for (int i = 0; i < keys.size(); i++) {
            line("    " + parameters.get(keys.get(i)) + (i + 1 < keys.size() ? "," : "") + "  /* " + i + ": " + Names.plain(keys.get(i))
                    + " */");
        }
        line("};");
        line("enum { MASS = 0, STIFFNESS = BODIES, DAMPING = BODIES + LINKS };");
        line("enum { ACCELERATION, VELOCITY, POSITION, FORCE };");
        table("LOWER", java.util.Arrays.stream(structure.from()).boxed().toList(),
                "body at the lower end of each link, -1 is the base: " + String.join(", ", names.links()));
        table("UPPER", java.util.Arrays.stream(structure.to()).boxed().toList(), "body at its upper end");
        table("LAW_LINK", assembly.laws().stream().map(LawAt::link).toList(), "link of each law");
        List<Integer> carried = new ArrayList<>();
        for (int i = 0; i < assembly.laws().size(); i++) {
            carried.add(carries(i) ? keys.indexOf("law_" + i + ".force_at_start_N") : -1);
        }
        table("CARRIED", carried, "parameter with the force that each law carries at the start, -1 for none");
        table("PLACE", assembly.outputs().stream().map(Assembly.Output::place).toList(), "body or link of each sensor: "
                + model.outputs().stream().map(Object::toString).collect(Collectors.joining(", ")));
        table("READING", assembly.outputs().stream().map(output -> output.reading().name().replace("LINK_", "")).toList(),
                "what is read there");
        List<Integer> mounts = new ArrayList<>();
        for (int o = 0; o < assembly.outputs().size(); o++) {
            for (int f = 0; f < assembly.outputs().get(o).faults().size(); f++) {
                SensorFault fault = assembly.outputs().get(o).faults().get(f);
                if (fault instanceof SensorFault.MountResonance || fault instanceof SensorFault.StiffeningMount) {
                    mounts.add(keys.indexOf(fault(o, f) + ".frequency_hz"));
                }
            }
        }
        table("MOUNT", mounts, "parameter with the frequency of each sensor's mount");
        line("\n/* A link as a law sees it: deflection r [m] and speed v [m/s], r at the step's start, the law's memory, time t [s], "
                + "length of the step h [s],");
        line("   the link's stiffness k [N/m] and damping c [N s/m], what the law is multiplied by, r and v some time ago. */");
        line("typedef struct {\n    double " + String.join(", ", MOTION) + ";\n} Motion;");
        line("typedef struct Model Model;");
    }

    private void table(String name, List<?> values, String meaning) {
        line("static const int " + name + "[] = {"
                + (values.isEmpty() ? "0" : values.stream().map(Object::toString).collect(Collectors.joining(", ")))
                + "};  /* " + Names.plain(meaning) + " */");
    }

    private void law(int i) {
        LawAt at = assembly.laws().get(i);
        LawForm form = LawForm.of(at.law());
        line("\n/* " + at.law().mechanism() + " in " + Names.plain(names.links().get(at.link()))
                + ": force [N], and what it remembers. */");
        line("static double law_" + i + "(const double *p, const Motion *m, double *remembered_out) {");
        constants(i, form);
        Set<String> asked = LawForm.asked(form.steps(), form.constants());
        MOTION.stream().filter(asked::contains).forEach(name -> line("    const double " + name + " = m->" + name + ";"));
        form.steps().forEach(each -> line("    const double " + each.name() + " = " + Language.C.of(each.value()) + ";"));
        line("    *remembered_out = " + (at.law().hasMemory() ? "remembered" : "0") + ";\n    return force;\n}");
        line("\nstatic double first_memory_" + i + "(const double *p, double force) {");
        Set<String> used = form.start().map(Expression::names).orElse(new TreeSet<>());
        form.constants().keySet().stream().filter(used::contains)
                .forEach(name -> line("    const double " + name + " = " + p("law_" + i + "." + name) + ";"));
        line("    (void) p, (void) force;\n    return " + form.start().map(Language.C::of).orElse("0") + ";\n}");
        line("\nstatic double lateness_" + i + "(const double *p) {");
        line("    (void) p;\n    return " + (at.law().lateness() > 0 ? p("law_" + i + ".delay_s") : "0") + ";\n}");
    }

    private void constants(int i, LawForm form) {
        line("    (void) p, (void) m;");
        form.constants().keySet().forEach(name -> line("    const double " + name + " = " + p("law_" + i + "." + name) + ";"));
    }

    private void dispatch(String name, String parameterList, String arguments, String otherwise) {
        line("\nstatic double " + name + "(int i, " + parameterList + ") {\n    switch (i) {");
        for (int i = 0; i < assembly.laws().size(); i++) {
            line("        case " + i + ":\n            return " + name + "_" + i + "(" + arguments + ");");
        }
        line("        default:\n            " + otherwise + "\n            return 0;\n    }\n}");
    }

    private void modulate() {
        line("/* What each law is multiplied by; loads and motions of other links are those of the point before. */");
        line("static void modulate(Model *s, const double *u, double *out) {\n    (void) s, (void) u, (void) out;");
        for (int i = 0; i < assembly.laws().size(); i++) {
            line("    out[" + i + "] = " + value(assembly.laws().get(i).law().modulator(), i) + ";");
        }
        line("}\n");
    }

    private String value(Modulator modulator, int law) {
        if (modulator instanceof Modulator.Ride ride) {
            String decay = "exp(-s->h / " + ride.seconds() + ")";
            return "sqrt(s->square[" + law + "] = " + decay + " * s->square[" + law + "] + (1 - " + decay + ") * "
                    + (structure.held() || model.base().sensor().isEmpty() ? "0" : "u[0] * u[0]") + ")";
        }
        if (modulator instanceof Modulator.OtherLink other) {
            return switch (other.of()) {
                case LOAD -> "s->load[" + other.link() + "]";
                case DEFLECTION -> "s->link_r[" + other.link() + "]";
                case SPEED -> "s->link_v[" + other.link() + "]";
            };
        }
        if (modulator instanceof Modulator.PartOf part) {
            String whole = value(part.whole(), law);
            return switch (part.part()) {
                case MAGNITUDE -> "fabs(" + whole + ")";
                case POSITIVE -> "fmax(0, " + whole + ")";
                case NEGATIVE -> "fmax(0, -" + whole + ")";
            };
        }
        if (modulator instanceof Modulator.Level level) {
            return "fmax(-1, fmin(1, (2 * " + u(level.channel().toString()) + " - (" + (level.low() + level.high()) + ")) / "
                    + (level.high() - level.low()) + "))";
        }
        return StepInputs.named(modulator) ? u(modulator.toString()) : "1";
    }

    private void drive() {
        line("/* Forces beside the base and the laws: in links, pulling their ends together, and on bodies; "
                + "and what lifts links' lower ends. */");
        line("static void drive(Model *s, const double *u, double t) {\n    const double *p = s->p;\n    (void) p, (void) u, (void) t;");
        line("    memset(s->link_drive, 0, sizeof s->link_drive);\n    memset(s->body_drive, 0, sizeof s->body_drive);");
        line("    memset(s->lift, 0, sizeof s->lift);\n    memset(s->rise, 0, sizeof s->rise);");
        StringBuilder launched = new StringBuilder();
        for (int d = 0; d < assembly.drives().size(); d++) {
            Assembly.DriveAt at = assembly.drives().get(d);
            String own = "drive_" + d + ".";
            String target = (at.drive().actsOnBody() ? "s->body_drive[" : "s->link_drive[") + at.place() + "] ";
            if (at.drive() instanceof Drive.Tone) {
                String phase = "2 * PI * " + p(own + "frequency_hz") + " * t";
                line("    " + target + "+= " + p(own + "cosine_N") + " * cos(" + phase + ") + " + p(own + "sine_N") + " * sin(" + phase
                        + ");");
            } else if (at.drive() instanceof Drive.Launch) {
                launched.append("    s->x[BODIES + ").append(at.place()).append("] += s->").append(p(own + "velocity_m_per_s"))
                        .append(";\n");
            } else if (at.drive() instanceof Drive.Measured measured) {
                line("    " + target + "+= " + u(measured.channel().toString()) + " - " + p(own + "offset_N") + ";");
            } else if (at.drive() instanceof Drive.Given given) {
                line("    " + target + "+= " + p(own + "share") + " * " + u(given.channel().toString()) + ";");
            } else if (at.drive() instanceof Drive.Across across) {
                line("    " + target + "+= " + p(own + "coupled_mass_kg") + " * " + u(across.across().toString()) + ";");
            } else if (at.drive() instanceof Drive.CrossAxis cross) {
                line("    " + target + "+= " + p(own + "cross_stiffness_N_per_m") + " * " + u(StepInputs.lean(cross.upper(), cross.lower()))
                        + ";");
            } else if (at.drive() instanceof Drive.Rotation rotation) {
                String arm = " += " + p(own + "lever_arm_m") + " * ";
                line("    s->lift[" + at.place() + "]" + arm + u(StepInputs.angle(rotation.rate())) + ";");
                line("    s->rise[" + at.place() + "]" + arm + u(rotation.rate().toString()) + ";");
            }
        }
        line("}\n\nstatic void launch(Model *s) {\n    (void) s;\n" + launched + "}\n");
    }

    /** @param seconds and drift, expressions */
    private void delayed(int late, String seconds, String drift) {
        line("    append(&s->late[" + late + "], y);\n    y = s->h > 0 ? delayed(&s->late[" + late + "], " + seconds + " / s->h, " + drift
                + ") : 0;");
    }

    private void sense() {
        line("/* What the sensors make of the true readings. */");
        line("static void sense(Model *s, const double *u, double t, int first, const double *reading) {");
        line("    const double *p = s->p;\n    double y;\n    (void) p, (void) u, (void) t, (void) first;");
        int mount = 0;
        int coupling = 0;
        int late = 0;
        for (int o = 0; o < assembly.outputs().size(); o++) {
            line("    y = reading[" + o + "];  /* " + model.outputs().get(o) + " */");
            List<SensorFault> faults = assembly.outputs().get(o).faults();
            for (int f = 0; f < faults.size(); f++) {
                String own = fault(o, f) + ".";
                SensorFault fault = faults.get(f);
                if (fault instanceof SensorFault.MountResonance) {
                    line("    y = mounted(&s->mounts[" + mount++ + "], " + p(own + "frequency_hz") + ", " + p(own + "damping_ratio")
                            + ", y, first);");
                } else if (fault instanceof SensorFault.StiffeningMount) {
                    line("    y = stiffened(&s->mounts[" + mount++ + "], s->h, " + p(own + "frequency_hz") + ", " + p(own + "damping_ratio")
                            + ", "
                            + p(own + "cubic_per_m2") + ", y, first);");
                } else if (fault instanceof SensorFault.AcCoupling) {
                    line("    y = coupled(&s->couplings[" + coupling++ + "], s->h, " + p(own + "corner_hz") + ", y, first);");
                } else if (fault instanceof SensorFault.WanderingDelay) {
                    String phase = "(2 * PI * " + p(own + "wandering_hz") + " * t)";
                    delayed(late++, "(" + p(own + "delay_s") + " + " + p(own + "cosine_s") + " * cos" + phase + " + " + p(own + "sine_s")
                            + " * sin" + phase + ")", "0");
                } else if (fault instanceof SensorFault.Delay) {
                    delayed(late++, p(own + "delay_s"), p(own + "drift_s_per_s"));
                } else if (fault instanceof SensorFault.Beside beside) {
                    line("    y += " + u(beside.channel().toString()) + ";");
                } else if (fault instanceof SensorFault.Gain) {
                    line("    y *= " + p(own + "factor") + ";");
                } else if (fault instanceof SensorFault.Bias) {
                    line("    y += " + p(own + "bias") + ";");
                } else if (fault instanceof SensorFault.Clipping) {
                    line("    y = fmax(" + p(own + "low") + ", fmin(" + p(own + "high") + ", y));");
                } else if (fault instanceof SensorFault.Quantised) {
                    line("    y = " + p(own + "level") + " + " + p(own + "step") + " * rint((y - " + p(own + "level") + ") / "
                            + p(own + "step") + ");");
                } else if (fault instanceof SensorFault.Rectifying) {
                    line("    y = fabs(y);");
                } else if (fault instanceof SensorFault.LeverArm lever) {
                    line("    y += " + p(own + "lever_arm_m") + " * " + u(StepInputs.angularAcceleration(lever.rate())) + ";");
                } else if (fault instanceof SensorFault.Misalignment tilt) {
                    String x = "tan(" + p(own + "towards_x_rad") + ")";
                    String z = "tan(" + p(own + "towards_y_rad") + ")";
                    line("    y = y * sqrt(1 + pow(" + x + ", 2) + pow(" + z + ", 2)) + " + u(tilt.across().toString()) + " * " + x + " + "
                            + u(tilt.beside().toString()) + " * " + z + ";");
                } else if (fault instanceof SensorFault.Turned turned) {
                    line("    y = y / cos(" + p(own + "angle_rad") + ") + " + u(turned.across().toString()) + " * tan("
                            + p(own + "angle_rad") + ");");
                } else {
                    throw new DataFault("an FMU has no form of the fault " + fault.mechanism() + " of the sensor " + model.outputs().get(o)
                            + "; --to python has");
                }
            }
            line("    s->y[" + o + "] = y;");
        }
        line("}");
    }

    private void line(String text) {
        out.append(text).append('\n');
    }
}
