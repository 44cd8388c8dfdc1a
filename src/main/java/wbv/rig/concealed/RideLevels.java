package wbv.rig.concealed;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.apache.commons.math3.random.RandomGenerator;
import wbv.recording.Recording;
import wbv.rig.platform.Seeds;

/** One sitter on three rides of three levels, his sensors where they were: two are fitted together, the third proves. */
final class RideLevels {

    /** Levels over the usual one. */
    private static final double[] LEVELS = {0.4, 0.9, 1.8};
    private static final double SECONDS = 40;

    private RideLevels() {}

    static ConcealedCase make(ConcealedSpec spec) {
        Seeds seeds = new Seeds(spec.seed());
        RideScene usual = RideScene.of(spec.setting(), OptionalDouble.of(SECONDS), seeds.of("scene")).ride(LEVELS[1], SECONDS,
                seeds.of("ride 1"));
        Imus imus = new Imus(usual, false);
        RandomGenerator random = seeds.source("omissions");
        List<OmissionSize> hidden = new ArrayList<>();
        for (String word : spec.words()) {
            double share = Concealer.share(spec, random);
            hidden.add(OmissionSize.of(new Recipes(usual, random).of(word, Set.of()), usual, imus, share));
        }
        RandomGenerator order = seeds.source("order");
        List<Integer> levels = new ArrayList<>();
        for (int i = 0; i < LEVELS.length; i++) {
            levels.add(order.nextInt(levels.size() + 1), i);
        }
        double newtons = spec.setting().leastForce + (spec.setting().mostForce - spec.setting().leastForce) * order.nextDouble();
        List<Recording> sent = new ArrayList<>();
        List<Recording> clean = new ArrayList<>();
        double[] stirred = new double[0];
        for (int level : levels) {
            RideScene scene = level == 1 ? usual : usual.ride(LEVELS[level], SECONDS, seeds.of("ride " + level));
            double[] stir = Concealer.stirring(scene.shaking().length(), newtons, seeds.source("stirring " + level));
            stirred = level == 1 ? stir : stirred;
            Setup setup = new Setup(scene.chain());
            hidden.forEach(each -> each.omission().change().accept(setup));
            setup.push(scene.chain().body("torso"), stir);
            ChainPlant.Trace trace = scene.play(setup);
            Imus own = new Imus(scene, false);
            sent.add(Concealer.recording(own.sent(setup, trace, seeds.of("sensors"), seeds.of("noise " + level)), List.of(), Imus.RATE,
                    true));
            clean.add(Concealer.recording(own.clean(setup, trace), List.of(), Imus.RATE, false));
        }
        String model = Concealer.user(usual.chain(), spec.exact(), seeds.source("user")).json("case " + spec.name(), List.of())
                .toPrettyString() + "\n";
        ObjectNode key = ConcealedKey.json(spec, usual, hidden, newtons, Concealer.noise(usual, imus, stirred), Optional.empty());
        levels.forEach(level -> key.withArray("levels").add(LEVELS[level]));
        return new ConcealedCase(sent.get(0), clean.get(0), model, key.toPrettyString() + "\n", Optional.empty(),
                Map.of(ConcealedCase.WITH, sent.get(1), ConcealedCase.PROOF, sent.get(2)));
    }
}
