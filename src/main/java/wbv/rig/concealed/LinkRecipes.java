package wbv.rig.concealed;

import java.util.Map;
import java.util.function.DoubleFunction;
import java.util.function.DoubleUnaryOperator;
import org.apache.commons.math3.random.RandomGenerator;
import wbv.rig.concealed.law.LinkPhysics;
import wbv.rig.concealed.law.Lugre;
import wbv.rig.concealed.law.MaxwellArms;
import wbv.rig.concealed.law.Modulated;
import wbv.rig.concealed.law.Muscle;
import wbv.rig.concealed.law.PullingMuscle;
import wbv.rig.concealed.law.Sliders;
import wbv.rig.concealed.law.Springs;
import wbv.rig.concealed.law.Thixotropic;

/** Omissions in one link, sized by how the link moves when it is linear. */
final class LinkRecipes {

    private final RideScene scene;
    private final int link;
    private final String where;
    private final double k;
    private final double c;
    private final double travel;
    private final double speed;
    private final double force;
    private final RandomGenerator random;

    LinkRecipes(RideScene scene, int link, RandomGenerator random) {
        this.scene = scene;
        this.link = link;
        this.random = random;
        Chain chain = scene.chain();
        where = chain.link(link);
        k = chain.stiffness()[link];
        c = chain.damping()[link];
        double[] r = scene.calm().extension()[link];
        double[] v = scene.calm().rate()[link];
        travel = UniformSeries.rms(r);
        speed = UniformSeries.rms(v);
        double sum = 0;
        for (int i = 0; i < r.length; i++) {
            sum += Math.pow(k * r[i] + c * v[i], 2);
        }
        force = Math.sqrt(sum / r.length);
    }

    /** @param word of the mechanism, or of a kind that is in no library */
    OmissionRecipe of(String word) {
        double half = random.nextDouble();
        boolean coin = random.nextBoolean();
        double seconds = scene.shaking().length() / UniformSeries.RATE;
        return switch (word) {
            case "stiffness.softening" -> coin
                    ? law(0.05, 3, word, "tanh", a -> Map.of("k3_N_per_m3", -k * a * a / (3 * travel * travel), "knee_m",
                            travel / a),
                            a -> Springs.tanh(k, c, travel / a))
                    : law(0.01, 4, word, "rational", a -> Map.of("knee_m", travel / a), a -> Springs.rational(k, c, travel / a));
            case "stiffness.hardening" -> law(0.05, 6, word, "cubic, then straight",
                    a -> Map.of("k3_N_per_m3", k * a * a / (travel * travel)), a -> Springs.hardening(k, c, travel / a));
            case "stiffness.asymmetric" -> law(0.02, 5, word, "smooth bend", a -> Map.of("compression_ratio", a),
                    a -> Springs.asymmetric(k, c, a, 0.2 * travel));
            case "damping.quadratic" -> law(0.05, 10, word, "with the linear part kept", a -> Map.of("c2_Ns2_per_m2",
                    a * c / speed),
                    a -> Springs.quadratic(k, c, a * c / speed, 0.1 * speed));
            case "friction.coulomb" -> law(0.01, 2, word, "LuGre", a -> Map.of("friction_N", a * force),
                    a -> new Lugre(k, c, a * force, (1.1 + 0.3 * half) * a * force, 0.3 * speed, a * force / ((0.03
                            + 0.03 * half) * travel)));
            case "hysteresis" -> half < 0.5
                    ? law(0.05, 10, word, "five Jenkins sliders beside the spring", a -> Map.of("sticking_N_per_m", a * k),
                            a -> Sliders.soon(k, c, a * k, travel))
                    : law(0.03, 0.85, word, "five Jenkins sliders", a -> Map.of("share", a), a -> Sliders.late(k, c, a, travel));
            case "memory.viscoelastic" -> {
                double tau = 0.02 + 0.05 * half;
                yield law(0.02, 3, word, "two Maxwell arms", a -> Map.of("arm_stiffness_N_per_m", a * k, "relaxation_s", tau),
                        a -> new MaxwellArms(k, c, 0.65 * a * k, tau, 0.35 * a * k, 4 * tau));
            }
            case "contact.loss" -> law(0.25, 4, word, "soft edge", a -> Map.of("preload_N", force / a),
                    a -> Springs.contactLoss(k, c, force / a, 0.06 * force / a));
            case "contact.bumpstop" -> {
                double gap = (0.7 + 0.9 * half) * travel;
                yield law(0.03, 30, word, "Hertz, in compression",
                        a -> Map.of("gap_m", gap, "stop_stiffness_N_per_m", 1.5 * a * k * Math.sqrt(0.7)),
                        a -> Springs.hertz(k, c, a * k / Math.sqrt(travel), gap));
            }
            case "contact.backlash" -> law(0.03, 1.5, word, "soft edge", a -> Map.of("gap_m", a * travel),
                    a -> Springs.play(k, c, a * travel));
            case "drift.step" -> {
                double start = (0.2 + 0.4 * half) * seconds;
                double ramp = 1.5 + 2.5 * random.nextDouble();
                yield law(0.02, 0.8, word, "ramp of " + Math.round(ramp) + " s", a -> Map.of("time_s", start + ramp / 2,
                        "stiffness_factor", coin ? 1 - a : 1 + 1.5 * a),
                        a -> new Modulated(k, c,
                                Modulated.ramp(start, ramp, coin ? 1 - a : 1 + 1.5 * a), half < 0.5 ? 1 : 0.5));
            }
            case "drift.slow" -> law(0.02, 0.8, word, "creep", a -> Map.of("end_factor", 1 + (coin ? -a : 1.5 * a)
                    * (1 - Math.exp(-1 / (0.4 + half)))), a -> new Modulated(k, c,
                            Modulated.creep((0.4 + half) * seconds, coin ? 1 - a : 1 + 1.5 * a), 0.5));
            case "muscle.reflex" -> {
                double delay = 0.04 + 0.07 * half;
                if (coin) {
                    double twitch = 3 + 2 * half;
                    yield new OmissionRecipe(0.05, 8, a -> new Omission(word, where, "a muscle that only pulls",
                            Map.of("reflex_N_per_m", 0.2 * a * k, "reflex_Ns_per_m", a * c, "delay_s", delay, "twitch_hz", twitch),
                            setup -> setup.link(link, h -> new PullingMuscle(k, c, 0.2 * a * k, a * c, delay, twitch, h))));
                }
                yield new OmissionRecipe(0.02, 0.8, a -> new Omission(word, where, "delayed, then low-passed",
                        Map.of("reflex_N_per_m", a * k, "delay_s", delay + 0.025), setup -> setup.link(link,
                                h -> new Muscle(k, c, a * k, 0.3 * a * c, delay, h))));
            }
            case "unlisted.breathing" -> {
                double phase = 2 * Math.PI * half;
                DoubleFunction<DoubleUnaryOperator> breath = a -> t -> 1 + a * Math.sin(2 * Math.PI * 0.25 * t + phase);
                yield law(0.02, 0.85, word, "stiffness breathes at 0.25 Hz", a -> Map.of("depth", a),
                        a -> new Modulated(k, c, breath.apply(a), 0.5));
            }
            case "unlisted.thixotropy" -> law(0.05, 0.9, word, "stiffness lost to motion, regained in seconds", a -> Map.of("loss", a),
                    a -> new Thixotropic(k, c, a, speed * speed, 6));
            case "unlisted.sway" -> {
                double[] u = scene.fore().get("head").displacement();
                double scale = UniformSeries.rms(u);
                yield law(0.02, 0.45, word, "stiffness follows the lean of the head", a -> Map.of("depth", a),
                        a -> new Modulated(k, c, t -> 1 + a * Math.max(-2, Math.min(2,
                                u[(int) Math.min(u.length - 1, t * UniformSeries.RATE)] / scale)), 0.5));
            }
            default -> throw new IllegalArgumentException("no link can have '" + word + "'");
        };
    }

    private OmissionRecipe law(double least, double most, String word, String form, DoubleFunction<Map<String, Double>> parameters,
            DoubleFunction<LinkPhysics> physics) {
        String mechanism = word.startsWith("unlisted.") ? "unknown" : word;
        return new OmissionRecipe(least, most, a -> new Omission(mechanism, where, form, parameters.apply(a),
                setup -> setup.link(link, h -> physics.apply(a))));
    }
}
