package wbv.network;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Collectors;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;

/**
 * Windows of recordings whose bodies are known from elsewhere. They are divided by recording, for the windows of one are of one
 * body: a tenth of the recordings, one at least, is held back, a fifth, one at least, says how sure the model may be, and the rest is
 * learned from.
 */
public final class LabelledRecordings implements TrainingData {

    /** Recordings below which no division is left: two to learn from, one held back, one to calibrate by. */
    public static final int FEWEST = 4;

    private final List<Channel> channels;
    private final int modes;
    private final long seed;
    private final List<List<LabelledMotion>> learned;
    private final List<List<LabelledMotion>> held;
    private final List<List<LabelledMotion>> further;
    private final String words;

    private LabelledRecordings(List<Channel> channels, int modes, long seed, List<List<LabelledMotion>> recordings) {
        this.channels = channels;
        this.modes = modes;
        this.seed = seed;
        List<List<LabelledMotion>> all = new ArrayList<>(recordings);
        Collections.shuffle(all, new Random(seed));
        int back = Math.max(1, all.size() / TrainingOrder.HELD_BACK);
        int calibrating = Math.max(1, all.size() / 5);
        held = List.copyOf(all.subList(0, back));
        further = List.copyOf(all.subList(back, back + calibrating));
        learned = List.copyOf(all.subList(back + calibrating, all.size()));
        words = recordings.stream().map(each -> each.get(0).rig() + " " + each.size() + " "
                + each.stream().mapToInt(trial -> 31 * Arrays.deepHashCode(trial.motion()) + Arrays.hashCode(trial.truth())).sum())
                .collect(Collectors.joining("; "));
    }

    /** Gathers them, recording by recording. */
    public static final class Gathering {

        private final Architecture architecture;
        private final Channel input;
        private final Channel output;
        private final int modes;
        private final int hop;
        private final List<List<LabelledMotion>> recordings = new ArrayList<>();
        private String file = "labels";

        /**
         * Gathers from no recording yet.
         *
         * @param hop samples from one window to the next, &gt;= 1
         */
        public Gathering(Architecture architecture, Channel input, Channel output, int modes, int hop) {
            this.architecture = architecture;
            this.input = input;
            this.output = output;
            this.modes = modes;
            this.hop = hop;
        }

        /**
         * Adds the windows of a recording that lie within one of its labels.
         *
         * @param name   for messages
         * @param labels of this recording, of as many modes
         * @throws DataFault if the recording is nothing that networks look at, ends before a label does, or gives no window
         */
        public void add(String name, Recording recording, Labels labels) {
            file = labels.file();
            NetworkReadings.require(architecture, name, recording, input, output);
            double end = recording.clock().time(recording.length() - 1L);
            for (Labels.Label label : labels.list()) {
                if (label.from() < recording.clock().start() - recording.clock().step() || label.to() > end + recording.clock().step()) {
                    throw DataFault.at(labels.file(), label.line(), name + " lasts from " + recording.clock().start() + " to " + end
                            + " s; a label must lie within: " + label.from() + " to " + label.to() + " s");
                }
            }
            List<LabelledMotion> windows = new ArrayList<>();
            double slack = recording.clock().step() / 2;
            Sliding.over(NetworkReadings.columns(architecture, recording, input, output), hop, (last, motion) -> {
                double from = recording.clock().time(last - Imaging.SAMPLES + 1L);
                double to = recording.clock().time(last + 1L);
                motion.ifPresent(window -> labels.list().stream().filter(label -> label.from() <= from + slack && to <= label.to() + slack)
                        .findFirst().ifPresent(label -> windows.add(new LabelledMotion(window, label.truth(), name))));
            });
            if (windows.isEmpty()) {
                throw DataFault.in(name, "has no whole window within its labels: 3.65 s without a gap of more than 0.1 s");
            }
            recordings.add(List.copyOf(windows));
        }

        /**
         * What was gathered, divided.
         *
         * @param seed by which recordings are divided
         * @throws DataFault if there are too few recordings or windows, or all labels say the same
         */
        public LabelledRecordings finish(long seed) {
            if (recordings.size() < FEWEST) {
                throw DataFault.in(file, "a network needs at least " + FEWEST + " recordings with labels, of which some are held back: "
                        + recordings.size());
            }
            LabelledRecordings all = new LabelledRecordings(architecture.channels(input, output), modes, seed, recordings);
            if (all.images() < LEAST) {
                throw DataFault.in(file, "a network needs at least " + LEAST + " windows to learn from and hold back: the recordings have "
                        + all.images() + "; label longer stretches or more recordings, or take a smaller --hop");
            }
            List<LabelledMotion> learned = flat(all.learned);
            for (int j = 0; j < 2 * modes; j++) {
                int target = j;
                if (learned.stream().mapToDouble(trial -> trial.truth()[target]).distinct().count() < 2) {
                    throw DataFault.in(file, "the labels learned from all have the same " + (j % 2 == 0 ? "damping ratio" : "frequency")
                            + (modes == 1 ? "" : " of mode " + (1 + j / 2)) + "; a network needs bodies that differ");
                }
            }
            return all;
        }
    }

    @Override
    public List<Channel> channels() {
        return channels;
    }

    @Override
    public int modes() {
        return modes;
    }

    @Override
    public int images() {
        return flat(learned).size() + flat(held).size();
    }

    @Override
    public Split split(Trainer.Progress progress) {
        return new Split(flat(learned), flat(held));
    }

    @Override
    public List<LabelledMotion> further(Trainer.Progress progress) {
        return flat(further);
    }

    @Override
    public Map<String, String> card() {
        Map<String, String> card = new LinkedHashMap<>();
        card.put("data", "recordings with labels: " + learned.size() + " learned from, " + held.size() + " held back, " + further.size()
                + " for what is usual");
        card.put("bodies", "recordings");
        card.put("images", Integer.toString(images()));
        card.put("data seed", Long.toString(seed));
        card.put("split", "by recording: " + flat(learned).size() + " windows learned from, held back those of " + names(held) + ", "
                + flat(further).size() + " windows for what is usual, of " + names(further));
        card.put("limits", "It knows the bodies, levels and sensors of these recordings; windows that no linear body explains as well as "
                + "there are told");
        return card;
    }

    private static String names(List<List<LabelledMotion>> recordings) {
        return recordings.stream().map(each -> each.get(0).rig()).collect(Collectors.joining(" "));
    }

    private static List<LabelledMotion> flat(List<List<LabelledMotion>> recordings) {
        return recordings.stream().flatMap(List::stream).toList();
    }

    @Override
    public String title() {
        return images() + " windows of recordings with labels";
    }

    @Override
    public String toString() {
        return "LabelledRecordings[" + channels + ", " + modes + ", " + seed + ", " + words + "]";
    }
}
