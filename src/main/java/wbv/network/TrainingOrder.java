package wbv.network;

import java.util.List;
import wbv.recording.Channel;

/**
 * What is to be trained: the same order gives the same model, on the same kind of processor to the last bit.
 *
 * @param data         what is learned from
 * @param architecture of the network
 * @param settings     of the training; member i has their seed plus i
 * @param members      networks that will be asked together
 */
public record TrainingOrder(TrainingData data, Architecture architecture, Settings settings, int members) {

    /** One trial in so many is held back. */
    public static final int HELD_BACK = 10;

    public TrainingOrder {
        if (data.images() < TrainingData.LEAST) {
            throw new IllegalArgumentException("a network needs at least " + TrainingData.LEAST + " images: " + data.images());
        }
        if (architecture.imaging().channels() > data.channels().size()) {
            throw new IllegalArgumentException(architecture.word() + " needs " + architecture.imaging().channels() + " channels, as bodies "
                    + (architecture.others() > 0 ? "'" + Bodies.COUPLED.word() + "' have" : "of recordings with labels have") + ": "
                    + data.channels());
        }
        if (members < 1 || members > 20) {
            throw new IllegalArgumentException("members must be 1 to 20: " + members);
        }
    }

    /**
     * To be trained on simulated trials.
     *
     * @param dataSeed of the trials
     */
    public TrainingOrder(Bodies bodies, int images, long dataSeed, Architecture architecture, Settings settings, int members) {
        this(new SimulatedTrials(bodies, images, dataSeed), architecture, settings, members);
    }

    /** Those that the network looks at. */
    List<Channel> channels() {
        return data.channels().subList(0, architecture.imaging().channels());
    }
}
