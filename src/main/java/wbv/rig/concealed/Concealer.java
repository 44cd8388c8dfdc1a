package wbv.rig.concealed;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.apache.commons.math3.random.RandomGenerator;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Quantity;
import wbv.recording.Recording;
import wbv.rig.ImuErrors;
import wbv.rig.platform.Seeds;

/**
 * Makes a recording in which something is concealed, the model that lacks it, and the key. The same spec gives the same bytes.
 */
public final class Concealer {

    private static final double BOXCARS = 0.3;
    private static final int PLACES = 3;

    private final ConcealedSpec spec;
    private final Seeds seeds;
    private final RideScene scene;
    private final Imus imus;

    private Concealer(ConcealedSpec spec) {
        this.spec = spec;
        seeds = new Seeds(spec.seed());
        scene = RideScene.of(spec.setting(), seeds.of("scene"));
        imus = new Imus(scene, seeds.source("filter").nextDouble() < BOXCARS);
    }

    /** The case of a spec. */
    public static ConcealedCase make(ConcealedSpec spec) {
        return switch (spec.setting()) {
            case BENCH, BENCH_LEVELS -> BenchConcealer.make(spec);
            case RIDE_LEVELS -> RideLevels.make(spec);
            case PLANAR, JOINTED -> PlanarConcealer.make(spec);
            default -> spec.isUnrelated() ? Unrelated.make(spec) : new Concealer(spec).make();
        };
    }

    private ConcealedCase make() {
        RandomGenerator random = seeds.source("omissions");
        Recipes recipes = new Recipes(scene, random);
        List<OmissionSize> hidden = new ArrayList<>();
        Set<String> taken = new HashSet<>();
        for (String word : Recipes.choosyFirst(spec.words())) {
            double share = share(spec, random);
            OmissionSize sized = OmissionSize.of(recipes.of(word, taken), scene, imus, share);
            // Where it can hardly show, another place is tried.
            for (int attempt = 1; attempt < PLACES && sized.share() < share / 2; attempt++) {
                OmissionSize other = OmissionSize.of(recipes.of(word, taken), scene, imus, share);
                sized = other.share() > sized.share() ? other : sized;
            }
            taken.add(sized.omission().where());
            hidden.add(sized);
        }
        RandomGenerator body = seeds.source("stirring");
        double newtons = scene.setting().leastForce
                + (scene.setting().mostForce - scene.setting().leastForce) * body.nextDouble();
        double[] stir = stirring(scene.shaking().length(), newtons, body);
        Setup setup = new Setup(scene.chain());
        hidden.forEach(each -> each.omission().change().accept(setup));
        setup.push(scene.chain().body("torso"), stir);
        ChainPlant.Trace trace = scene.play(setup);
        Map<String, double[][]> sent = imus.sent(setup, trace, seeds.of("sensors"));
        Map<String, double[][]> clean = imus.clean(setup, trace);
        String model = user(scene.chain(), spec.exact(), seeds.source("user")).json("case " + spec.name(), scene.blind()).toPrettyString()
                + "\n";
        Optional<String> force = spec.isOpen() ? Optional.of(ConcealedForce.of(hidden.get(0).omission(), scene.chain(), trace, imus))
                : Optional.empty();
        return new ConcealedCase(recording(sent, scene.blind(), Imus.RATE, true), recording(clean, scene.blind(), Imus.RATE, false), model,
                ConcealedKey.json(spec, scene, hidden, newtons, noise(scene, imus, stir), force).toPrettyString() + "\n", force);
    }

    /**
     * Variance in the fit's band, by output, that no model can predict: the output's noise, the platform's through the chain,
     * stirring.
     */
    static double[] noise(RideScene scene, Imus imus, double[] stir) {
        Setup stirred = new Setup(scene.chain());
        stirred.push(scene.chain().body("torso"), stir);
        ChainPlant.Trace trace = scene.sketch(stirred);
        List<String> places = scene.outputs();
        Setup calm = new Setup(scene.chain());
        double[] platform = imus.vertical(calm, scene.calm(), Chain.PLATFORM);
        int[] body = places.stream().mapToInt(place -> scene.chain().rider(place)).toArray();
        double[] gain = new LinearFit(body, platform, new double[][] {platform}).gain(scene.chain());
        double density = Math.pow(scene.setting().noise * ImuErrors.TABLE_3_2.acceleration().noise(), 2);
        double[] out = new double[places.size()];
        for (int o = 0; o < out.length; o++) {
            double moved = UniformSeries
                    .rms(UniformSeries.less(imus.vertical(stirred, trace, places.get(o)), imus.vertical(calm, scene.calm(),
                            places.get(o))));
            out[o] = density * (LinearFit.HIGH - LinearFit.LOW) * (1 + gain[o]) + moved * moved;
        }
        return out;
    }

    /** Part of an output's variance that the best linear fit shall miss: 5 to 30 % times the strength. */
    static double share(ConcealedSpec spec, RandomGenerator random) {
        return spec.strength() * 0.05 * Math.pow(6, random.nextDouble());
    }

    /** A sitter's own force: white noise between half a hertz and five. */
    static double[] stirring(int length, double newtons, RandomGenerator random) {
        double[] out = new double[length];
        double slow = 0;
        double fast = 0;
        for (int i = 0; i < out.length; i++) {
            double white = random.nextGaussian();
            fast += 2 * Math.PI * 5 / UniformSeries.RATE * (white - fast);
            slow += 2 * Math.PI * 0.5 / UniformSeries.RATE * (fast - slow);
            out[i] = fast - slow;
        }
        return UniformSeries.scaled(out, newtons / UniformSeries.rms(out));
    }

    /** The chain as its user believes it to be. */
    static Chain user(Chain chain, boolean exact, RandomGenerator random) {
        int n = chain.size();
        double[] mass = chain.mass().clone();
        double[] stiffness = chain.stiffness().clone();
        double[] damping = chain.damping().clone();
        if (!exact) {
            for (int i = 0; i < n; i++) {
                mass[i] *= wrong(random);
                stiffness[i] *= wrong(random);
                damping[i] *= wrong(random);
            }
        }
        return new Chain(chain.names(), chain.parent(), mass, stiffness, damping);
    }

    private static double wrong(RandomGenerator random) {
        double size = 0.03 + 0.12 * random.nextDouble();
        return random.nextBoolean() ? 1 + size : 1 - size;
    }

    /**
     * @param blind places without a sensor
     * @param all whether all six channels of a place were recorded; else only the vertical
     */
    static Recording recording(Map<String, double[][]> six, List<String> blind, double rate, boolean all) {
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        for (String place : RideScene.PLACES) {
            for (int q = 0; q < 6 && !blind.contains(place); q++) {
                if (all || q == Fault.Z) {
                    channels.put(new Channel(place, q < 3 ? Quantity.ACCELERATION : Quantity.ANGULAR_RATE, "xyz".charAt(q % 3)),
                            six.get(place)[q]);
                }
            }
        }
        return recording(channels, rate);
    }

    /**
     * What says that it was simulated.
     *
     * @param channels in their order
     */
    static Recording recording(Map<Channel, double[]> channels, double rate) {
        return new Recording(new Clock(0, rate), channels, new Metadata(OptionalDouble.of(rate), Map.of(),
                Optional.empty(), Optional.empty(), OptionalDouble.empty(),
                Optional.of("simulated by wbv rig, not measured; AGPL-3.0-or-later"), Map.of()));
    }
}
