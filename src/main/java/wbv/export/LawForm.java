package wbv.export;

import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import wbv.body.law.CubicSpring;
import wbv.body.law.Law;
import wbv.body.law.LearnedCourse;
import wbv.body.law.LearnedKnee;
import wbv.body.law.LearnedLimited;
import wbv.body.law.LearnedMemory;
import wbv.body.law.LearnedTable;
import wbv.body.law.LearnedTerm;
import wbv.body.law.LearnedWave;
import wbv.body.law.MuscleReflex;
import wbv.body.law.ScheduledLink;
import wbv.body.number.Key;
import wbv.body.number.Shape;

/**
 * A law as lines of arithmetic, {@code name = expression} each, in the order in which they are worked out.
 *
 * <p>They may use the law's own numbers by their names in {@code model.json}, and: r, v deflection and speed of the link [m, m/s],
 * k, c its stiffness and damping [N/m, N s/m], t time [s], modulation what multiplies the law, memory the law's memory, late_r, late_v
 * deflection and speed some time ago; in steps also r_before the deflection at the step's start [m] and h its length [s].
 *
 * @param constants the law's numbers, by name
 * @param steps     end in {@code force} [N] and, with memory, {@code remembered}: exact over a step of monotone motion
 * @param flow      end in {@code force} and, with memory, {@code rate}: the same for a step that goes to 0
 * @param start     the memory that carries a force at rest, of {@code force}; none for a law without memory
 */
record LawForm(Map<String, Double> constants, List<Line> steps, List<Line> flow, Optional<Expression> start) {

    /** @param name of what it works out */
    record Line(String name, Expression value) {}

    /** Of an x without a sign yet: deflection, speed. */
    private static final String[] SMALL = {"1e-5", "1e-3"};

    LawForm {
        steps = List.copyOf(steps);
        flow = List.copyOf(flow);
    }

    static LawForm of(Law law) {
        Map<String, Double> constants = constants((Record) law);
        List<Line> steps = lines(sided(steps(law), law));
        String flow = sided(flow(law), law);
        return new LawForm(constants, steps, flow.isEmpty() ? steps : lines(flow),
                law.hasMemory() ? Optional.of(Expression.parse(start(law))) : Optional.empty());
    }

    /** The numbers of a record by their names in {@code model.json}, in its order. */
    static Map<String, Double> constants(Record record) {
        Map<String, Double> out = new java.util.LinkedHashMap<>();
        for (RecordComponent component : record.getClass().getRecordComponents()) {
            if (component.getType() == double.class) {
                out.put(component.getAnnotation(Key.class).value(), (Double) read(record, component));
            }
        }
        return out;
    }

    static Object read(Record record, RecordComponent component) {
        try {
            return component.getAccessor().invoke(record);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    /** What the lines ask for beside the law's numbers and each other. */
    static Set<String> asked(List<Line> lines, Map<String, Double> constants) {
        Set<String> out = new TreeSet<>();
        Set<String> known = new TreeSet<>(constants.keySet());
        for (Line line : lines) {
            out.addAll(
                    line.value().names().stream().filter(name -> !known.contains(name) && !name.equals("pi")).collect(Collectors.toSet()));
            known.add(line.name());
        }
        return out;
    }

    private static List<Line> lines(String text) {
        List<Line> out = new ArrayList<>();
        for (String line : text.strip().split("\n")) {
            int sign = line.indexOf(" = ");
            out.add(new Line(line.substring(0, sign).strip(), Expression.parse(line.substring(sign + 3))));
        }
        return out;
    }

    /** What pulls one way only. */
    private static String sided(String text, Law law) {
        return !(law instanceof MuscleReflex muscle) ? text : text.replace("SIDE", switch (muscle.side()) {
            case EXTENSION -> "max(0, told)";
            case COMPRESSION -> "min(0, told)";
            case BOTH -> "told";
        });
    }

    private static String steps(Law law) {
        String plain = PLAIN.get(law.getClass().getSimpleName());
        if (law instanceof ScheduledLink link) {
            return plain.replace("CARRIED", link.of() == ScheduledLink.Of.STIFFNESS ? "k * r" : "c * v");
        }
        if (plain != null) {
            return plain;
        }
        if (law instanceof CubicSpring cubic) {
            return cubic.cubic() >= 0 ? "force = k3_N_per_m3 * r * r * r" : """
                    flat = sqrt(k / (-3 * k3_N_per_m3))
                    held = max(-flat, min(flat, r))
                    force = k3_N_per_m3 * held * held * held + k * (held - r)
                    """;
        }
        if (law instanceof LearnedTerm term) {
            return "force = coefficient_N * modulation * (" + text(term.shape(), "r", "v") + ")";
        }
        if (law instanceof LearnedLimited limited) {
            return "force = coefficient_N * limit * tanh(modulation / limit) * (" + text(limited.shape(), "r", "v") + ")";
        }
        if (law instanceof LearnedKnee knee) {
            return "x = " + text(knee.of(), "r", "v") + "\nforce = coefficient_N * modulation * ("
                    + beyond("x", "knee", "x - knee", "x + knee", knee.side()) + ")";
        }
        if (law instanceof LearnedMemory memory) {
            return """
                    decay = exp(-h / memory_s)
                    middle = (r_before + r) / 2
                    speed = (r - r_before) / h
                    remembered = memory * decay + (1 - decay) * (%s)
                    force = coefficient_N * modulation * remembered * (%s)
                    """.formatted(text(memory.of(), "middle", "speed"), text(memory.shape(), "r", "v"));
        }
        if (law instanceof LearnedCourse course) {
            return "share = " + switch (course.course()) {
                case STEP -> "t < time_s ? 0 : 1";
                case SETTLING -> "-expm1(-t / time_s)";
                case GROWING -> "t / time_s";
            } + "\nforce = coefficient_N * share * (" + text(course.shape(), "r", "v") + ")";
        }
        if (law instanceof LearnedWave wave) {
            return "phase = 2 * pi * frequency_hz * t\nforce = (cosine_N * cos(phase) + sine_N * sin(phase)) * ("
                    + text(wave.shape(), "r", "v") + ")";
        }
        if (law instanceof LearnedTable table) {
            return table(table);
        }
        String stop = STOPS.get(law.getClass().getSimpleName());
        if (stop != null) {
            Law.Side side = law instanceof wbv.body.law.BumpStop bump ? bump.side() : ((wbv.body.law.HertzStop) law).side();
            String[] sides = stop.split("\\|");
            return "force = " + beyond("r", "gap_m", sides[0], sides[1], side);
        }
        throw new IllegalArgumentException("no form of the law " + law.getClass().getSimpleName());
    }

    /** Laws that are what they are whatever their words. */
    private static final Map<String, String> PLAIN = Map.ofEntries(
            Map.entry("SaturatingSpring", """
                    u = r / knee_m
                    force = k * r * (1 / sqrt(1 + u * u) - 1)
                    """),
            Map.entry("GradualSaturation",
                    "force = k * r * (pow(1 + pow(abs(r) / knee_m, sharpness), -1 / sharpness) - 1)"),
            Map.entry("PartialSaturation",
                    "force = (1 - kept_share) * k * r * (pow(1 + pow(abs(r) / knee_m, sharpness), -1 / sharpness) - 1)"),
            Map.entry("ProgressiveSpring", "force = added_stiffness_N_per_m * r * r * r / (r * r + knee_m * knee_m)"),
            Map.entry("GasSpring", """
                    height = max(0.05, 1 + r / column_m)
                    force = k * (column_m / 1.4 * (1 - pow(height, -1.4)) - r)
                    """),
            Map.entry("QuadraticSpring", "force = k2_N_per_m2 * r * r"),
            Map.entry("PolynomialSpring", "force = (k2_N_per_m2 + k3_N_per_m3 * r) * r * r"),
            Map.entry("AsymmetricSpring", "force = r < 0 ? compression_ratio * k * r : 0"),
            Map.entry("BendingSpring", """
                    ramp = (-r + sqrt(r * r + bend_m * bend_m)) / 2
                    force = -compression_ratio * k * (ramp - bend_m / 2)
                    """),
            Map.entry("Thinning", "force = coefficient_N * v / (1 + pow(abs(v) / speed_m_per_s, thinning))"),
            Map.entry("QuadraticDamping", "force = c2_Ns2_per_m2 * v * abs(v)"),
            Map.entry("CoulombFriction", """
                    x = v / transition_m_per_s
                    decay = exp(-2 * abs(x))
                    size = (1 - decay) / (1 + decay)
                    force = friction_N * (x < 0 ? -size : size)
                    """),
            Map.entry("BristleFriction", """
                    travel = r - r_before
                    speed = travel / h
                    g = friction_N + (breakaway_N - friction_N) * exp(-(speed / stribeck_m_per_s) * (speed / stribeck_m_per_s))
                    steady = (travel < 0 ? -g : g) / bristle_N_per_m
                    remembered = steady + (memory - steady) * exp(-abs(travel) * bristle_N_per_m / g)
                    force = bristle_N_per_m * remembered
                    """),
            Map.entry("EngagingFriction", """
                    remembered = max(-engagement_m, min(engagement_m, memory + r - r_before))
                    engaged = expm1(growth * abs(remembered) / engagement_m) / expm1(growth)
                    force = remembered > 0 ? extension_friction_N * engaged : -compression_friction_N * engaged
                    """),
            Map.entry("BoucWen", """
                    travel = r - r_before
                    sign = travel > 0 ? 1 : (travel < 0 ? -1 : 0)
                    free = memory * sign < 0 ? min(abs(memory), abs(travel)) : 0
                    unloaded = memory + sign * free
                    steady = sign * yield_m
                    remembered = steady + (unloaded - steady) * exp(-abs(travel - sign * free) / yield_m)
                    force = share * k * (remembered - r)
                    """),
            Map.entry("Slider", """
                    remembered = max(-slip_m, min(slip_m, memory + r - r_before))
                    force = sliding_share * k * (remembered - r)
                    """),
            Map.entry("JenkinsElement", """
                    remembered = max(-slip_m, min(slip_m, memory + r - r_before))
                    force = sticking_N_per_m * remembered
                    """),
            Map.entry("ContactLoss", "force = min(0, preload_N - k * r - c * v)"),
            Map.entry("RoundedContactLoss", """
                    pull = k * r + c * v - preload_N
                    force = -(pull + sqrt(pull * pull + edge_N * edge_N)) / 2
                    """),
            Map.entry("Backlash", "force = -k * max(-gap_m, min(gap_m, r))"),
            Map.entry("RoundedBacklash", """
                    over = r - gap_m
                    under = -r - gap_m
                    far = sqrt(over * over + edge_m * edge_m)
                    near = sqrt(under * under + edge_m * edge_m)
                    held = (1 + over / far) / 2 + (1 + under / near) / 2
                    force = -k * (r - (over + far) / 2 + (under + near) / 2) - slack_damping * c * v * (1 - held)
                    """),
            Map.entry("StepChange", """
                    share = max(0, min(1, (t - time_s) / h + 0.5))
                    force = share * ((stiffness_factor - 1) * k * r + (damping_factor - 1) * c * v)
                    """),
            Map.entry("Gradual", """
                    share = max(0, min(1, (t - time_s) / duration_s + 0.5))
                    force = share * ((stiffness_factor - 1) * k * r + (damping_factor - 1) * c * v)
                    """),
            Map.entry("ScheduledLink", """
                    g = max(-0.97, modulation * (linear_change + modulation * (square_change + modulation * (cube_change \
                    + modulation * fourth_change))))
                    force = g * CARRIED
                    """),
            Map.entry("ScheduledFriction", """
                    most = max(0, middle_N + modulation * (linear_N + modulation * (square_N + modulation * (cube_N \
                    + modulation * fourth_N))))
                    force = most * tanh(v / transition_m_per_s)
                    """),
            Map.entry("SlowDrift", """
                    late = t / 100
                    g = max(-0.97, linear_per_100s * late + quadratic_per_100s2 * late * late)
                    force = g * k * r + max(-0.97, damping_share * g) * c * v
                    """),
            Map.entry("Settling", """
                    g = settled_change * -expm1(-t / settling_s)
                    force = g * k * r + max(-0.97, damping_share * g) * c * v
                    """),
            Map.entry("MaxwellArm", """
                    u = h / relaxation_s
                    remembered = memory * exp(-u) + arm_stiffness_N_per_m * (r - r_before) * (-expm1(-u) / u)
                    force = remembered
                    """),
            Map.entry("Reflex", "force = reflex_N_per_m * late_r + reflex_Ns_per_m * late_v"),
            Map.entry("MuscleReflex", """
                    u = h / twitch_s
                    mean = -expm1(-u) / u
                    remembered = memory * exp(-u) + (late_r - h * late_v) * (mean - exp(-u)) + late_r * (1 - mean)
                    told = reflex_N_per_m * remembered + reflex_Ns_per_m * (late_r - remembered) / twitch_s
                    force = SIDE
                    """),
            Map.entry("LearnedInertance", """
                    remembered = 2 * v - memory
                    force = inertance_kg * 2 * (v - memory) / h
                    """));

    /** Force beyond the gap in extension, and in compression. */
    private static final Map<String, String> STOPS = Map.of(
            "BumpStop", "stop_stiffness_N_per_m * (r - gap_m)|stop_stiffness_N_per_m * (r + gap_m)",
            "HertzStop", "stop_N_per_m1_5 * pow(max(0, r - gap_m), 1.5)|-stop_N_per_m1_5 * pow(max(0, -r - gap_m), 1.5)");

    /** What laws with memory, or that go by steps, are for a step that goes to 0; of an inertance a is the relative acceleration. */
    private static String flow(Law law) {
        if (law instanceof LearnedMemory memory) {
            return "rate = ((" + text(memory.of(), "r", "v") + ") - memory) / memory_s\nforce = coefficient_N * modulation * memory * ("
                    + text(memory.shape(), "r", "v") + ")";
        }
        return switch (law.getClass().getSimpleName()) {
            case "BristleFriction" -> """
                    g = friction_N + (breakaway_N - friction_N) * exp(-(v / stribeck_m_per_s) * (v / stribeck_m_per_s))
                    rate = v - abs(v) * memory * bristle_N_per_m / g
                    force = bristle_N_per_m * memory
                    """;
            case "EngagingFriction" -> """
                    rate = memory > engagement_m ? min(0, v) : (memory < -engagement_m ? max(0, v) : v)
                    engaged = expm1(growth * min(1, abs(memory) / engagement_m)) / expm1(growth)
                    force = memory > 0 ? extension_friction_N * engaged : -compression_friction_N * engaged
                    """;
            case "BoucWen" -> """
                    rate = v * memory > 0 ? v * (1 - abs(memory) / yield_m) : v
                    force = share * k * (memory - r)
                    """;
            case "Slider" -> """
                    rate = memory > slip_m ? min(0, v) : (memory < -slip_m ? max(0, v) : v)
                    force = sliding_share * k * (memory - r)
                    """;
            case "JenkinsElement" -> """
                    rate = memory > slip_m ? min(0, v) : (memory < -slip_m ? max(0, v) : v)
                    force = sticking_N_per_m * memory
                    """;
            case "StepChange" -> """
                    share = t < time_s ? 0 : 1
                    force = share * ((stiffness_factor - 1) * k * r + (damping_factor - 1) * c * v)
                    """;
            case "MaxwellArm" -> """
                    rate = arm_stiffness_N_per_m * v - memory / relaxation_s
                    force = memory
                    """;
            case "MuscleReflex" -> """
                    rate = (late_r - memory) / twitch_s
                    told = reflex_N_per_m * memory + reflex_Ns_per_m * rate
                    force = SIDE
                    """;
            case "LearnedInertance" -> "force = inertance_kg * a";
            default -> "";
        };
    }

    private static String start(Law law) {
        return switch (law.getClass().getSimpleName()) {
            case "BristleFriction" -> "max(-breakaway_N, min(breakaway_N, force)) / bristle_N_per_m";
            case "JenkinsElement" -> "max(-slip_m, min(slip_m, force / sticking_N_per_m))";
            case "EngagingFriction" ->
                "(force < 0 ? -1 : 1) * engagement_m * log1p(min(1, abs(force) / max(force > 0 ? extension_friction_N : "
                        + "compression_friction_N, 1e-9)) * expm1(growth)) / growth";
            default -> "0.0";
        };
    }

    private static String beyond(String x, String gap, String above, String below, Law.Side side) {
        return switch (side) {
            case EXTENSION -> x + " > " + gap + " ? " + above + " : 0";
            case COMPRESSION -> x + " < -" + gap + " ? " + below + " : 0";
            case BOTH -> x + " > " + gap + " ? " + above + " : (" + x + " < -" + gap + " ? " + below + " : 0)";
        };
    }

    /** Straight lines between seven points. */
    private static String table(LearnedTable table) {
        String[] at = {"at_minus_3_N", "at_minus_2_N", "at_minus_1_N", "0", "at_1_N", "at_2_N", "at_3_N"};
        StringBuilder out = new StringBuilder("x = max(-3, min(3, (" + text(table.over(), "r", "v") + ") / step))\nforce = modulation * (");
        for (int i = 0; i < 6; i++) {
            int below = i - 3;
            String share = below == 0 ? "x" : below < 0 ? "(x + " + -below + ")" : "(x - " + below + ")";
            out.append(i < 5 ? "x < " + (below + 1) + " ? " : "").append(at[i]).append(" * (1 - ").append(share).append(") + ")
                    .append(at[i + 1])
                    .append(" * ").append(share).append(i < 5 ? " : (" : "");
        }
        return out.append("))))))").toString();
    }

    /** A shape of two names. */
    private static String text(Shape shape, String r, String v) {
        String first = part(shape.deflection(), r, SMALL[0]);
        String second = part(shape.speed(), v, SMALL[1]);
        return first.equals("1") ? second : second.equals("1") ? first : "(" + first + ") * (" + second + ")";
    }

    private static String part(Shape.Part part, String x, String small) {
        return switch (part) {
            case ONE -> "1";
            case PLAIN -> x;
            case MAGNITUDE -> "abs(" + x + ")";
            case SQUARE -> x + " * " + x;
            case SIGNED_SQUARE -> "abs(" + x + ") * " + x;
            case CUBE -> x + " * " + x + " * " + x;
            case SIGN -> x + " / sqrt(" + x + " * " + x + " + " + small + " * " + small + ")";
            case POSITIVE -> "max(" + x + ", 0)";
            case NEGATIVE -> "min(" + x + ", 0)";
            case POSITIVE_SQUARE -> x + " > 0 ? " + x + " * " + x + " : 0";
            case NEGATIVE_SQUARE -> x + " < 0 ? " + x + " * " + x + " : 0";
        };
    }
}
