package wbv.bench;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.learn.AdwinAlarm;
import wbv.network.Architecture;
import wbv.network.Bodies;
import wbv.network.Evaluation;
import wbv.network.LabelledMotion;
import wbv.network.LabelledRecordings;
import wbv.network.Labels;
import wbv.network.Losses;
import wbv.network.Ridge;
import wbv.network.Score;
import wbv.network.Settings;
import wbv.network.TrainedNetwork;
import wbv.network.Trainer;
import wbv.network.TrainingData;
import wbv.network.TrainingOrder;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Recording;
import wbv.rig.RigRun;
import wbv.rig.RigSpec;

/**
 * The thesis' networks as it had them, for docs/thesis.md: people of the rig's population under its regimes, 2046 windows of three axes
 * at seat cushion and sternum, its Table 8-1. {@code MODES EPOCHS RIDES NETWORK…}; 82 rides make 2046 windows.
 */
public final class ThesisNetworks {

    private static final int WINDOWS = 31;
    private static final int HOP = 113;
    /** Of fresh rides, so that windows do not overlap: nine a ride. */
    private static final int FRESH_HOP = 400;
    private static final double SECONDS = 61;
    private static final int TEST_RIDES = 24;
    private static final Channel SEAT = Channel.parse("seat.acc.z");
    private static final Channel STERNUM = Channel.parse("sternum.acc.z");

    private ThesisNetworks() {}

    /** A ride with what is true of the sitter, on average: slowest two modes, damping ratio and pulsation [rad/s] each. */
    private record Ride(String name, Recording recording, double[] truth) {

        static Ride of(int person, int regime) {
            List<Channel> channels = Architecture.THESIS_CNN.channels(SEAT, STERNUM);
            RigRun run = RigSpec.parse(String.format(Locale.ROOT, "subject=random:%d regime=%d seconds=%s seed=%d", person, regime, SECONDS,
                    person)).withChannels(channels).run();
            int rows = (WINDOWS - 1) * HOP + 219;
            double[][] values = new double[channels.size()][rows];
            double[] row = new double[1 + channels.size()];
            double[] parameters = new double[run.parameters().size()];
            double[] truth = new double[4];
            int at = run.parameters().indexOf("zeta1");
            for (int i = 0; i < rows; i++) {
                run.read(row);
                run.parameters(parameters);
                for (int c = 0; c < values.length; c++) {
                    values[c][i] = row[1 + c];
                }
                for (int j = 0; j < truth.length; j++) {
                    truth[j] += parameters[at + j] / rows;
                }
            }
            Map<Channel, double[]> columns = new LinkedHashMap<>();
            IntStream.range(0, values.length).forEach(c -> columns.put(channels.get(c), values[c]));
            return new Ride("person " + person, new Recording(new Clock(0, 60), columns, run.metadata()), truth);
        }

        Labels label(int modes) {
            return new Labels("truth", modes, List.of(new Labels.Label(1, name, 0, recording.duration(), Arrays.copyOf(truth, 2 * modes))));
        }
    }

    public static void main(String[] words) throws IOException {
        int modes = Integer.parseInt(words[0]);
        int epochs = Integer.parseInt(words[1]);
        int count = Integer.parseInt(words[2]);
        List<Ride> rides = rides(1000, count);
        List<LabelledMotion> fresh = all(data(Architecture.THESIS_CNN, rides(9000, TEST_RIDES), modes, FRESH_HOP));
        System.out.println(count + " rides, " + fresh.size() + " fresh windows of " + TEST_RIDES + " others");
        List<TrainedNetwork> models = new ArrayList<>();
        for (String word : Arrays.asList(words).subList(3, words.length)) {
            Architecture architecture = Architecture.named(word).orElseThrow();
            long before = System.nanoTime();
            Settings settings = architecture.settings();
            TrainingData data = data(architecture, rides, modes, HOP);
            Trainer.Result result = new Trainer(
                    new TrainingOrder(data, architecture, epochs > 0 ? settings.withEpochs(epochs) : settings, 1),
                    Optional.empty(), (step, share) -> {}).train();
            List<Losses> losses = result.losses().get(0);
            System.out.printf(Locale.ROOT, "%s, %d images, %d epochs, %.0f s: loss %.4f, held back %.4f (first epoch %.4f, %.4f)%n", word,
                    data.images(), losses.size(), (System.nanoTime() - before) * 1e-9, losses.get(losses.size() - 1).train(),
                    losses.get(losses.size() - 1).held(), losses.get(0).train(), losses.get(0).held());
            models.add(result.model());
        }
        Map<String, Ridge> ridges = new LinkedHashMap<>();
        TrainingData.Split split = data(Architecture.THESIS_CNN, rides, modes, HOP).split((step, share) -> {});
        for (Architecture architecture : List.of(Architecture.THESIS_CNN, Architecture.POOLED)) {
            List<LabelledMotion> some = IntStream.range(0, split.learned().size()).filter(i -> i % 2 == 0).mapToObj(split.learned()::get)
                    .toList();
            ridges.put("ridge on images of " + architecture.word(), Ridge.fit(architecture.imaging(), some, split.held()));
        }
        Evaluation evaluation = Evaluation.of(modes == 1 ? Bodies.PEOPLE : Bodies.PEOPLE_AS_TWO, fresh, models, ridges,
                () -> new AdwinAlarm(0.002));
        double[] spread = models.get(0).scaling().deviation();
        System.out.println("spread of those learned from: " + Arrays.toString(spread));
        for (Evaluation.Row row : evaluation.rows()) {
            StringBuilder line = new StringBuilder("| " + row.method());
            for (int j = 0; j < 2 * modes; j++) {
                Score score = row.scores().get(j);
                double unit = j % 2 == 0 ? 1 : 2 * Math.PI;
                line.append(String.format(Locale.ROOT, " | %.3f | %.3f | %.3f | %.4f", score.standardised() * score.standardised(),
                        score.standardised(), score.deviation() / spread[j], score.rmse() / unit));
            }
            System.out.println(line + " |");
        }
    }

    private static List<Ride> rides(int first, int count) {
        return IntStream.range(0, count).parallel().mapToObj(i -> Ride.of(first + i, 1 + i % 8)).toList();
    }

    private static TrainingData data(Architecture architecture, List<Ride> rides, int modes, int hop) {
        LabelledRecordings.Gathering gathering = new LabelledRecordings.Gathering(architecture, SEAT, STERNUM, modes, hop);
        rides.forEach(ride -> gathering.add(ride.name(), ride.recording(), ride.label(modes)));
        return gathering.finish(1);
    }

    private static List<LabelledMotion> all(TrainingData data) {
        TrainingData.Split split = data.split((step, share) -> {});
        return Stream.of(split.learned(), split.held(), data.further((step, share) -> {})).flatMap(List::stream).toList();
    }
}
