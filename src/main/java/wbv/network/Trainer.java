package wbv.network;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import wbv.recording.AtomicFile;
import wbv.recording.Channel;
import wbv.recording.DataFault;

/** Trains what an {@link TrainingOrder} says, from its data to a model with its card. */
public final class Trainer {

    private static final String ORDER = "order";
    private static final String LOSSES = "losses";

    private final TrainingOrder order;
    private final Optional<Path> checkpoint;
    private final Progress progress;
    private final List<Map<String, SafeTensors.Tensor>> done = new ArrayList<>();
    private final List<List<Losses>> losses = new ArrayList<>();

    /** Hears how far the work has come. */
    public interface Progress {
        /**
         * Tells how far a step is.
         *
         * @param share 0 to 1
         */
        void at(String step, double share);
    }

    /**
     * What came out.
     *
     * @param losses of every member, epoch by epoch
     * @param held images held back
     */
    public record Result(TrainedNetwork model, List<List<Losses>> losses, int held) {
        public Result {
            losses = losses.stream().map(List::copyOf).toList();
        }
    }

    /**
     * Nothing is trained before it is asked for.
     *
     * @param checkpoint file that keeps the state after every epoch; where there is one, training goes on from it
     */
    public Trainer(TrainingOrder order, Optional<Path> checkpoint, Progress progress) {
        this.order = order;
        this.checkpoint = checkpoint;
        this.progress = progress;
    }

    /**
     * Trains to the end. The checkpoint stays until {@link #forget}.
     *
     * @throws DataFault if PyTorch's library is missing, or the checkpoint is of another order
     */
    public Result train() throws IOException {
        PyTorch.engine(); // before minutes of simulation, not after
        TrainingData.Split split = order.data().split(progress);
        return train(split.learned(), split.held());
    }

    /**
     * The same from trials at hand.
     *
     * @param held trials held back
     */
    Result train(List<LabelledMotion> trials, List<LabelledMotion> held) throws IOException {
        Imaging imaging = order.architecture().imaging();
        Scaling scaling = Scaling.of(trials.stream().map(trial -> imaging.image(trial.motion())).toList(), trials);
        Examples learned = Examples.of(imaging, scaling, trials);
        Examples kept = Examples.of(imaging, scaling, held);
        Optional<SafeTensors> state = resume();
        while (done.size() < order.members()) {
            Settings settings = order.settings().withSeed(order.settings().seed() + done.size());
            try (Training training = new Training(order.architecture(), settings, learned, kept)) {
                state.ifPresent(found -> training.restore(checkpoint.orElseThrow().toString(), found));
                state = Optional.empty();
                while (losses.size() <= done.size()) {
                    losses.add(new ArrayList<>());
                }
                while (!training.finished()) {
                    losses.get(done.size()).add(training.next());
                    save(training);
                    progress.at("training", (done.size() + training.epochs() / (double) settings.epochs()) / order.members());
                }
                done.add(training.weights());
            }
        }
        double[] ones = new double[scaling.targets()];
        Arrays.fill(ones, 1);
        TrainedNetwork raw = new TrainedNetwork(order.architecture(), order.channels(), order.data().modes(), scaling, ones,
                Usual.unknown(ones.length), done, Map.of());
        return new Result(calibrated(raw, order.data().further(progress), card()), losses, held.size());
    }

    /** A model that knows what is usual in trials that it was not trained on. */
    static TrainedNetwork calibrated(TrainedNetwork raw, List<LabelledMotion> trials, Map<String, String> card) {
        List<double[][]> motions = trials.stream().map(LabelledMotion::motion).toList();
        double[] widening;
        try (Reader reader = new Reader(raw)) {
            widening = Usual.widening(reader.ask(motions), trials);
        }
        TrainedNetwork widened = raw.with(widening, raw.usual(), card);
        if (!raw.architecture().excited()) {
            return widened;
        }
        try (Reader reader = new Reader(widened)) {
            List<Estimate> asked = reader.ask(motions);
            FrequencyFit fit = new FrequencyFit(raw.modes(), raw.architecture().others());
            List<FrequencyFit.Found> found = new ArrayList<>();
            for (int i = 0; i < asked.size(); i++) {
                found.add(fit.from(motions.get(i), asked.get(i)));
            }
            return widened.with(widening, Usual.of(found, trials), card);
        }
    }

    private Map<String, String> card() {
        Map<String, String> card = new LinkedHashMap<>();
        Settings settings = order.settings();
        card.put("what", "Reads damping ratio and natural pulsation of a body from " + Imaging.SAMPLES + " samples at 60 Hz of "
                + String.join(", ", order.channels().stream().map(Channel::toString).toList()));
        card.putAll(order.data().card());
        card.put("training", settings.toString());
        List<String> ends = new ArrayList<>();
        losses.forEach(each -> ends.add(String.format(Locale.ROOT, "%.4f", each.get(each.size() - 1).rmse())));
        card.put("held back, standardised RMSE by member", String.join(" ", ends));
        return card;
    }

    private void save(Training training) throws IOException {
        if (checkpoint.isEmpty()) {
            return;
        }
        SafeTensors state = training.state();
        Map<String, String> words = new LinkedHashMap<>(state.words());
        words.put(ORDER, order.toString());
        words.put("done", Integer.toString(done.size()));
        Map<String, SafeTensors.Tensor> tensors = new LinkedHashMap<>(state.tensors());
        for (int i = 0; i < losses.size(); i++) {
            float[] flat = new float[3 * losses.get(i).size()];
            for (int e = 0; e < losses.get(i).size(); e++) {
                flat[3 * e] = (float) losses.get(i).get(e).train();
                flat[3 * e + 1] = (float) losses.get(i).get(e).held();
                flat[3 * e + 2] = (float) losses.get(i).get(e).rmse();
            }
            tensors.put(LOSSES + "." + i, new SafeTensors.Tensor(new long[] {losses.get(i).size(), 3}, flat));
        }
        for (int i = 0; i < done.size(); i++) {
            int member = i;
            done.get(i).forEach((name, tensor) -> tensors.put("done." + member + "." + name, tensor));
        }
        AtomicFile.write(checkpoint.get(), new SafeTensors(words, tensors).bytes());
    }

    private Optional<SafeTensors> resume() throws IOException {
        if (checkpoint.isEmpty() || !Files.exists(checkpoint.get())) {
            return Optional.empty();
        }
        String name = checkpoint.get().toString();
        SafeTensors state = SafeTensors.parse(name, Files.readAllBytes(checkpoint.get()));
        if (!order.toString().equals(state.words().get(ORDER))) {
            throw DataFault.in(name, "is the checkpoint of another training: " + state.words().getOrDefault(ORDER,
                    "none of ours"));
        }
        for (int i = 0; state.tensors().containsKey(LOSSES + "." + i); i++) {
            float[] flat = state.tensors().get(LOSSES + "." + i).values();
            List<Losses> each = new ArrayList<>();
            for (int e = 0; e < flat.length; e += 3) {
                each.add(new Losses(flat[e], flat[e + 1], flat[e + 2]));
            }
            losses.add(each);
        }
        for (int i = 0; i < Integer.parseInt(state.words().get("done")); i++) {
            String prefix = "done." + i + ".";
            Map<String, SafeTensors.Tensor> weights = new LinkedHashMap<>();
            state.tensors().forEach((key, tensor) -> {
                if (key.startsWith(prefix)) {
                    weights.put(key.substring(prefix.length()), tensor);
                }
            });
            done.add(weights);
        }
        return Optional.of(state);
    }

    /** Removes the checkpoint. To be called when the model is written, not before: until then it is all that there is. */
    public void forget() throws IOException {
        if (checkpoint.isPresent()) {
            Files.deleteIfExists(checkpoint.get());
        }
    }
}
