package wbv.rig.concealed;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.DoubleFunction;
import java.util.function.DoubleUnaryOperator;
import org.apache.commons.math3.random.RandomGenerator;
import wbv.rig.concealed.law.LinkPhysics;
import wbv.rig.concealed.law.Lugre;
import wbv.rig.concealed.law.Modulated;
import wbv.rig.concealed.law.OpenLaws;
import wbv.rig.concealed.law.ParallelForce;
import wbv.rig.concealed.law.Sliders;
import wbv.rig.concealed.law.Springs;
import wbv.rig.concealed.law.Term;
import wbv.rig.concealed.law.Term.Factor;

/**
 * A law in one coordinate, of any size, in place of its spring and dashpot: times and lengths are those of the coordinate's own motion, so
 * that it may swing at 3 Hz or at 1000.
 *
 * @param mechanism in the vocabulary's words, {@code unknown} for what is to be learned
 * @param least
 * @param most sizes between which it is physics
 * @param law in neutral mathematics, of what is to be learned
 * @param physics of a size
 */
record CoordinateLaw(String mechanism, double least, double most, String form, DoubleFunction<Map<String, Double>> parameters,
        List<Term> law, DoubleFunction<DoubleFunction<LinkPhysics>> physics) {

    /** Speed at which dry friction is three quarters of itself, over the usual speed. */
    private static final double EDGE = 0.1;
    private static final Factor SPEED = Factor.of("speed", "itself");

    /** @param word a mechanism or an open law */
    static CoordinateLaw of(String word, Coordinate at, RandomGenerator random) {
        double k = at.k();
        double c = at.c();
        double travel = at.travel();
        double speed = at.speed();
        double half = random.nextDouble();
        String n = at.newtons();
        String m = at.metres();
        return switch (word) {
            case "stiffness.softening" ->
                named(word, 0.05, 3, "tanh", a -> Map.of("knee_" + m, travel / a), a -> Springs.tanh(k, c, travel / a));
            case "stiffness.hardening" ->
                named(word, 0.05, 6, "cubic, then straight", a -> Map.of("k3_" + n + "_per_" + m + "3", k * a * a / (travel * travel)),
                        a -> Springs.hardening(k, c, travel / a));
            case "stiffness.asymmetric" ->
                named(word, 0.02, 5, "smooth bend", a -> Map.of("compression_ratio", a), a -> Springs.asymmetric(k, c, a, 0.2 * travel));
            case "damping.quadratic" ->
                named(word, 0.05, 10, "with the linear part kept", a -> Map.of("c2_" + n + "s2_per_" + m + "2", a * at.drag() / speed),
                        a -> Springs.quadratic(k, c, a * at.drag() / speed, 0.1 * speed));
            case "friction.coulomb" -> named(word, 0.01, k > 0 ? 2 : 0.7, "LuGre", a -> Map.of("friction_" + n, a * at.force()),
                    a -> new Lugre(k, c, a * at.force(),
                            (1.1 + 0.3 * half) * a * at.force(), 0.3 * speed, a * at.force() / ((0.03 + 0.03 * half) * travel)));
            case "hysteresis" -> half < 0.5
                    ? named(word, 0.05, 10, "five Jenkins sliders beside the spring", a -> Map.of("sticking_" + n + "_per_" + m, a * k),
                            a -> Sliders.soon(k, c, a * k, travel))
                    : named(word, 0.03, 0.85, "five Jenkins sliders", a -> Map.of("share", a), a -> Sliders.late(k, c, a, travel));
            case "contact.loss" -> named(word, 0.25, 4, "soft edge", a -> Map.of("preload_" + n, at.force() / a),
                    a -> Springs.contactLoss(k, c, at.force() / a, 0.06 * at.force() / a));
            case "contact.bumpstop" -> {
                double gap = (0.7 + 0.9 * half) * travel;
                yield named(word, 0.03, 30, "Hertz, in compression", a -> Map.of("gap_" + m, gap),
                        a -> Springs.hertz(k, c, a * at.scale() / Math.sqrt(travel), gap));
            }
            case "contact.backlash" ->
                named(word, 0.03, 1.5, "soft edge", a -> Map.of("gap_" + m, a * travel), a -> Springs.play(k, c, a * travel));
            case "drift.step" -> {
                double start = (0.15 + 0.45 * half) * at.seconds();
                double ramp = Math.min(0.1 * at.seconds(), 2 * Math.pow(10, random.nextDouble()) * at.period());
                yield changing(word, "ramp of " + Math.round(ramp / at.period()) + " periods", at, random,
                        end -> Modulated.ramp(start, ramp, end), Map.of("time_s", start + ramp / 2));
            }
            case "drift.slow" -> random.nextBoolean()
                    ? changing(word, "creep", at, random, end -> Modulated.creep((0.3 + half) * at.seconds(), end), Map.of())
                    : changing(word, "half a cosine", at, random, end -> Modulated.ramp(0, at.seconds(), end), Map.of());
            case "open.damping.rebound" ->
                open(at, 0.1, 8, "a damper that works in rebound alone", Term.of(Factor.of("speed", "positive part")),
                        a -> OpenLaws.rebound(a * at.drag()));
            case "open.damping.blow-off" ->
                open(at, 0.1, 12, "a damper that blows off in compression", Term.of(Factor.of("speed", "negative part beyond a knee")),
                        a -> OpenLaws.blowOff(a * at.drag(), (0.1 + 0.3 * half) * speed));
            case "open.damping.eddy" ->
                open(at, 0.1, 8, "an eddy-current brake past its crest", Term.of(Factor.of("speed", "over one plus its square")),
                        a -> OpenLaws.eddyBrake(a * at.drag(), (0.4 + 0.4 * half) * speed));
            case "open.damping.travel" -> open(at, 0.05, 6, "damping that grows with the square of the deflection",
                    Term.of(Factor.of("deflection", "square"), SPEED), a -> OpenLaws.travelDamping(a * at.drag(), travel));
            case "open.friction.wedge" -> open(at, 0.01, 1.2, "dry friction pressed by its own deflection",
                    Term.of(Factor.of("deflection", "magnitude"), Factor.of("speed", "sign")),
                    a -> OpenLaws.wedge(a * at.scale(), EDGE * speed));
            default -> throw new IllegalArgumentException("no single coordinate can have '" + word + "'");
        };
    }

    private static CoordinateLaw named(String word, double least, double most, String form, DoubleFunction<Map<String, Double>> parameters,
            DoubleFunction<LinkPhysics> physics) {
        return new CoordinateLaw(word, least, most, form, parameters, List.of(), a -> h -> physics.apply(a));
    }

    /**
     * A spring, a dashpot or both that change with time, to less or to more.
     *
     * @param course factor at a time in s, of the factor in the end
     * @param further parameters that go by no size
     */
    private static CoordinateLaw changing(String word, String form, Coordinate at, RandomGenerator random,
            DoubleFunction<DoubleUnaryOperator> course, Map<String, Double> further) {
        boolean spring = random.nextDouble() < 2.0 / 3;
        boolean dashpot = !spring || random.nextBoolean();
        boolean less = random.nextDouble() < 0.7;
        DoubleFunction<Double> factor = a -> less ? 1 - a : 1 / (1 - a);
        DoubleFunction<Map<String, Double>> parameters = a -> {
            Map<String, Double> out = new TreeMap<>(further);
            out.put("stiffness_factor", spring ? factor.apply(a) : 1);
            out.put("damping_factor", dashpot ? factor.apply(a) : 1);
            return out;
        };
        return named(word, 0.05, spring ? 0.3 : 0.5, form + " of " + (!spring ? "damping" : dashpot ? "both" : "stiffness"), parameters,
                a -> new Modulated(at.k(), at.c(), course.apply(factor.apply(a)), spring ? 1 : 0, dashpot ? 1 : 0));
    }

    /** Beside spring and dashpot. */
    private static CoordinateLaw open(Coordinate at, double least, double most, String form, Term term, DoubleFunction<LinkPhysics> extra) {
        return new CoordinateLaw("unknown", least, most, form, a -> Map.of("size", a), List.of(term),
                a -> h -> new ParallelForce(at.k(), at.c(), extra.apply(a)));
    }

    /** What is told of a size of it. */
    Omission told(String where, double size) {
        return Omission.told(mechanism, where, form, parameters.apply(size), law);
    }
}
