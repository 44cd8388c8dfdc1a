package wbv.rig.concealed;

import java.util.List;
import java.util.Map;
import java.util.function.DoubleFunction;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import org.apache.commons.math3.random.RandomGenerator;
import wbv.rig.concealed.law.FadingDamper;
import wbv.rig.concealed.law.LaggedDrag;
import wbv.rig.concealed.law.LinkPhysics;
import wbv.rig.concealed.law.Mullins;
import wbv.rig.concealed.law.OpenLaws;
import wbv.rig.concealed.law.Orifice;
import wbv.rig.concealed.law.ParallelForce;
import wbv.rig.concealed.law.Term;
import wbv.rig.concealed.law.Term.Factor;

/** Laws of no library, sized by how link and neighbours move when they are linear. Each acts beside the link's own spring and dashpot. */
final class OpenRecipes {

    /** Speed at which dry friction is three quarters of itself, over the link's usual speed. */
    private static final double EDGE = 0.1;
    /** Where bolsters press: the sensor that no recording lacks. */
    private static final String SIDE = "pelvis";
    /** How much less a flap resists than an orifice: one five times as wide. */
    private static final double FLAP = 0.04;
    private static final Factor SPEED = Factor.of("speed", "itself");
    private static final Factor DEFLECTION = Factor.of("deflection", "itself");
    private static final Factor SLIDING = Factor.of("speed", "sign");

    private final RideScene scene;
    private final int link;
    private final int other;
    private final double k;
    private final double c;
    private final double travel;
    private final double speed;
    private final double force;
    private final RandomGenerator random;

    OpenRecipes(RideScene scene, int link, RandomGenerator random) {
        this.scene = scene;
        this.link = link;
        this.random = random;
        Chain chain = scene.chain();
        other = neighbour(chain, link);
        k = chain.stiffness()[link];
        c = chain.damping()[link];
        travel = UniformSeries.rms(scene.calm().extension()[link]);
        speed = UniformSeries.rms(scene.calm().rate()[link]);
        force = UniformSeries.rms(scene.calm().force()[link]);
    }

    /** The link below, or the next above where none is; never one under a body without a sensor. */
    private static int neighbour(Chain chain, int link) {
        if (chain.parent()[link] >= 0) {
            return chain.parent()[link];
        }
        for (int i = link + 1; i < chain.size(); i++) {
            if (chain.parent()[i] == link && !chain.place(i).isEmpty()) {
                return i;
            }
        }
        throw new IllegalArgumentException("link " + chain.link(link) + " has no neighbour");
    }

    OmissionRecipe of(String word) {
        double half = random.nextDouble();
        double phase = 2 * Math.PI * random.nextDouble();
        String beside = scene.chain().link(other);
        double edge = EDGE * speed;
        return switch (word) {
            case "open.damping.travel" -> law(0.05, 6, "damping that grows with the square of the deflection",
                    a -> Map.of("damping_Ns_per_m", a * c, "travel_m", travel),
                    Term.of(Factor.of("deflection", "square"), SPEED), a -> OpenLaws.travelDamping(a * c, travel));
            case "open.damping.breathing" -> {
                double hertz = 0.2 + 0.13 * half;
                yield law(0.1, 8, "damping that breathes", a -> Map.of("damping_Ns_per_m", a * c, "frequency_hz", hertz),
                        Term.of(Factor.of("time", "sine"), SPEED),
                        a -> OpenLaws.timedDamping(t -> a * c * 0.5 * (1 + Math.sin(2 * Math.PI * hertz * t + phase))));
            }
            case "open.damping.level" -> {
                double memory = 2 + 4 * half;
                yield law(0.1, 12, "a damper that fades with the motion of the last seconds",
                        a -> Map.of("damping_Ns_per_m", a * c, "speed_m_per_s", 0.5 * speed, "memory_s", memory),
                        Term.of(Factor.over("speed", "level, one over one plus it", memory), SPEED),
                        a -> new FadingDamper(a * c, 0.25 * speed * speed, memory));
            }
            case "open.damping.tilt" -> {
                double[] angle = scene.shaking().pitch();
                double usual = UniformSeries.rms(angle);
                yield law(0.1, 8, "damping while the platform is pitched forward", a -> Map.of("damping_Ns_per_rad_m", a * c / usual),
                        Term.of(Factor.at("tilt", "platform.gyr.y", "positive part"), SPEED),
                        a -> OpenLaws.timedDamping(t -> a * c * Math.max(0, at(angle, t) / usual)));
            }
            case "open.damping.rebound" -> law(0.1, 8, "a damper that works in rebound alone", a -> Map.of("damping_Ns_per_m", a * c),
                    Term.of(Factor.of("speed", "positive part")), a -> OpenLaws.rebound(a * c));
            case "open.damping.blow-off" -> {
                double opens = (0.1 + 0.3 * half) * speed;
                yield law(0.1, 12, "a damper that blows off in compression", a -> Map.of("damping_Ns_per_m", a * c, "opens_m_per_s", opens),
                        Term.of(Factor.of("speed", "negative part beyond a knee")), a -> OpenLaws.blowOff(a * c, opens));
            }
            case "open.damping.eddy" -> {
                double crest = (0.4 + 0.4 * half) * speed;
                yield law(0.1, 8, "an eddy-current brake past its crest", a -> Map.of("damping_Ns_per_m", a * c, "crest_m_per_s", crest),
                        Term.of(Factor.of("speed", "over one plus its square")), a -> OpenLaws.eddyBrake(a * c, crest));
            }
            case "open.drag.lagged" -> {
                double lag = 0.02 + 0.04 * half;
                yield law(0.05, 12, "drag with the square of speed, that answers late",
                        a -> Map.of("c2_Ns2_per_m2", a * c / speed, "memory_s", lag),
                        Term.lagged(lag, Factor.of("speed", "square with sign")), a -> new LaggedDrag(a * c / speed, lag));
            }
            case "open.stiffness.mullins" -> {
                double memory = 4 + 6 * half;
                yield new OmissionRecipe(0.03, 0.9, a -> omission("stiffness lost below the largest deflection of the last seconds",
                        Map.of("loss_N_per_m", a * k, "memory_s", memory),
                        Term.of(Factor.over("deflection", "magnitude over its peak", memory), DEFLECTION),
                        setup -> h -> new Mullins(a * k, memory, 0.05 * travel, h)));
            }
            case "open.friction.wedge" -> law(0.01, 1.2, "dry friction pressed by its own deflection",
                    a -> Map.of("friction_N_per_m", a * k), Term.of(Factor.of("deflection", "magnitude"), SLIDING),
                    a -> OpenLaws.wedge(a * k, edge));
            case "open.cushion.orifice" -> {
                double stiff = (0.5 + half) * travel / speed;
                yield law(0.02, 4, "a cushion whose fluid leaves through an orifice and comes back through a flap",
                        a -> Map.of("volume_N_per_m", a * k, "orifice_Ns2_per_m2", a * k * stiff / speed, "flap_Ns2_per_m2",
                                FLAP * a * k * stiff / speed),
                        Term.lagged(stiff, Factor.of("speed", "negative part")),
                        a -> new Orifice(a * k, a * k * stiff / speed, FLAP * a * k * stiff / speed, 0.05 * speed));
            }
            case "open.inerter" -> law(0.05, 3, "an inerter", a -> Map.of("inertance_kg", a * scene.chain().mass()[link]),
                    Term.of(Factor.of("acceleration", "itself")), a -> OpenLaws.inerter(a * scene.chain().mass()[link]));
            case "open.stiffness.load", "open.friction.load", "open.muscle.two-joint" -> neighbourly(word, beside, edge);
            case "open.stiffness.bolster", "open.friction.side" -> sideways(word, edge);
            case "open.slosh" -> slosh(half);
            default -> throw new IllegalArgumentException("no open law is called '" + word + "'");
        };
    }

    /** What another link does to this one. */
    private OmissionRecipe neighbourly(String word, String beside, double edge) {
        double load = UniformSeries.rms(scene.calm().force()[other]);
        double reach = travel / UniformSeries.rms(scene.calm().extension()[other]);
        Factor pressed = Factor.at("load", beside, "negative part");
        return switch (word) {
            case "open.stiffness.load" -> new OmissionRecipe(0.02, 4, a -> omission("stiffness that follows the load of " + beside,
                    Map.of("per_load_per_m", a * k / load), Term.of(pressed, DEFLECTION), setup -> h -> OpenLaws.loadedStiffness(
                            pressing(setup, a * k / load))));
            case "open.friction.load" -> new OmissionRecipe(0.02, 3, a -> omission("dry friction pressed by the load of " + beside,
                    Map.of("coefficient", a * force / load), Term.of(pressed, SLIDING), setup -> h -> OpenLaws.pressedFriction(
                            pressing(setup, a * force / load), edge)));
            default -> new OmissionRecipe(0.02, 2, a -> omission("a muscle over two joints, pulled taut by " + beside,
                    Map.of("stiffness_N_per_m", a * k * reach), Term.of(Factor.at("deflection", beside, "positive part")), setup -> h -> {
                        Neighbour next = Neighbour.of(setup.chain(), other, setup.bodies());
                        return OpenLaws.foreign(y -> a * k * reach * Math.max(0, next.deflection(y)));
                    }));
        };
    }

    /** So much per newton by which the other link is compressed. */
    private ToDoubleFunction<double[]> pressing(Setup setup, double per) {
        Neighbour next = Neighbour.of(setup.chain(), other, setup.bodies());
        return y -> per * Math.max(0, -next.load(y));
    }

    /** What motion across does to the link. */
    private OmissionRecipe sideways(String word, double edge) {
        double[] across = scene.side().get(SIDE).acceleration();
        double usual = UniformSeries.rms(across);
        String channel = SIDE + ".acc.y";
        return word.equals("open.stiffness.bolster")
                ? law(0.05, 5, "stiffness while a bolster is pressed sideways", a -> Map.of("stiffness_Ns2_per_m2", a * k / usual),
                        Term.of(Factor.at("channel", channel, "positive part"), DEFLECTION),
                        a -> OpenLaws.timedStiffness(t -> a * k * Math.max(0, at(across, t) / usual)))
                : law(0.02, 3, "dry friction pressed sideways", a -> Map.of("friction_Ns2_per_m", a * force / usual),
                        Term.of(Factor.at("channel", channel, "magnitude"), SLIDING),
                        a -> OpenLaws.timedFriction(t -> a * force * Math.abs(at(across, t)) / usual, edge));
    }

    /** A mass that nobody sees, hardly damped when it moves little and well when it moves much. */
    private OmissionRecipe slosh(double half) {
        Chain chain = scene.chain();
        double omega = 2 * Math.PI * (3 + 3 * half);
        // It swings against the body about as fast as the body itself moves.
        double swing = UniformSeries.rms(scene.calm().acceleration()[link]) / omega;
        return new OmissionRecipe(0.01, 0.3, a -> {
            double mass = a * chain.mass()[link];
            Setup.Rider rider = new Setup.Rider(link, mass, mass * omega * omega, 2 * 0.02 * mass * omega, 2 * 0.1 * mass * omega / swing);
            return new Omission("unknown", chain.names().get(link), "a mass that sloshes, damped with the square of its speed",
                    Map.of("mass_kg", mass, "frequency_hz", omega / (2 * Math.PI), "drag_Ns2_per_m2", rider.drag()),
                    List.of(Term.of(Factor.of("hidden mass", "square with sign of its speed"))), setup -> setup.ride(rider));
        });
    }

    private OmissionRecipe law(double least, double most, String form, DoubleFunction<Map<String, Double>> parameters, Term term,
            DoubleFunction<LinkPhysics> extra) {
        return new OmissionRecipe(least, most, a -> omission(form, parameters.apply(a), term, setup -> h -> extra.apply(a)));
    }

    /**
     * Beside the link's own spring and dashpot.
     *
     * @param extra for a setup and a step of so many seconds
     */
    private Omission omission(String form, Map<String, Double> parameters, Term term,
            Function<Setup, DoubleFunction<LinkPhysics>> extra) {
        return new Omission("unknown", scene.chain().link(link), form, parameters, List.of(term),
                setup -> setup.link(link, h -> new ParallelForce(k, c, extra.apply(setup).apply(h))));
    }

    /**
     * A series between its samples.
     *
     * @param t [s]
     */
    private static double at(double[] x, double t) {
        double sample = Math.min(x.length - 1, t * UniformSeries.RATE);
        int s = (int) sample;
        return s + 1 == x.length ? x[s] : x[s] + (x[s + 1] - x[s]) * (sample - s);
    }
}
