package wbv.network;

import java.util.List;
import java.util.Map;
import wbv.recording.Channel;

/** What a network learns from. Its text says which: the same text, the same data. */
public sealed interface TrainingData permits SimulatedTrials, LabelledRecordings {

    /** Fewer images teach nothing. */
    int LEAST = 40;

    /** Excitation first, answer second; then what else may be looked at. */
    List<Channel> channels();

    /** Modes whose damping ratio and frequency are known. */
    int modes();

    /** Images that are learned from or held back. */
    int images();

    /** What is learned from, and what is held back: no body is in both. */
    Split split(Trainer.Progress progress);

    /** Trials more, of bodies in neither, by which a model learns how sure it may be. */
    List<LabelledMotion> further(Trainer.Progress progress);

    /** For the model's card: what, whence, how divided, and where it ends. */
    Map<String, String> card();

    /** In a few words, for a report. */
    String title();

    /**
     * Trials of bodies that stand on one side only.
     *
     * @param learned learned from
     * @param held held back
     */
    record Split(List<LabelledMotion> learned, List<LabelledMotion> held) {}
}
