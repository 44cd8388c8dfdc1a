package wbv.network;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import wbv.recording.Channel;

/**
 * Trials of the virtual rig.
 *
 * @param bodies what they are drawn from
 * @param images trials, one image each; a tenth of them is held back
 * @param seed   of the trials
 */
public record SimulatedTrials(Bodies bodies, int images, long seed) implements TrainingData {

    private static final int MOST_FURTHER = 1000;
    /** Less the seed of the trials learned from: the seed of those by which is calibrated. */
    private static final long FURTHER = -1;

    @Override
    public List<Channel> channels() {
        return bodies.channels();
    }

    @Override
    public int modes() {
        return bodies.modes();
    }

    @Override
    public Split split(Trainer.Progress progress) {
        List<LabelledMotion> all = RigTrials.of(bodies, images, seed, share -> progress.at("simulating", share));
        int learned = all.size() - all.size() / TrainingOrder.HELD_BACK;
        return new Split(all.subList(0, learned), all.subList(learned, all.size()));
    }

    @Override
    public List<LabelledMotion> further(Trainer.Progress progress) {
        return RigTrials.of(bodies, count(), FURTHER - seed, share -> progress.at("calibrating", share));
    }

    private int count() {
        return Math.min(MOST_FURTHER, images / 2);
    }

    @Override
    public Map<String, String> card() {
        Map<String, String> card = new LinkedHashMap<>();
        card.put("data", "wbv's virtual rig; simulated, nobody was measured");
        card.put("bodies", bodies.word());
        card.put("images", Integer.toString(images));
        card.put("data seed", Long.toString(seed));
        card.put("split", "one tenth held back, " + count() + " further trials for what is usual; every trial has a "
                + "body, an excitation and sensors of its own");
        card.put("limits", "Linear bodies under " + (bodies == Bodies.COUPLED ? "three axes of" : "vertical")
                + " random motion from 0.5 Hz to 10-15 Hz at 0.3 to 2 m/s2. Elsewhere it is "
                + "wrong; windows that no linear body explains are told");
        return card;
    }

    @Override
    public String title() {
        return images + " simulated trials of bodies '" + bodies.word() + "'";
    }
}
