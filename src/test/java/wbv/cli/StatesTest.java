package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The commands {@code states train} and {@code states apply}, and the MOA tasks and learner of the same. */
class StatesTest {

    private static final String TRAIN = "data/arff/states-train.arff";
    private static final String BARE = "data/arff/states-bare.arff";
    private static final String OTHER = "data/arff/states-other.arff";

    @TempDir
    private static Path shared;

    @TempDir
    private Path folder;

    private static Run trained;

    @BeforeAll
    static void train() {
        trained = Run.of("states", "train", TRAIN, BARE, "--out", shared.resolve("model").toString());
    }

    private static String model() {
        return shared.resolve("model/model.json").toString();
    }

    @Test
    void modelIsTrainedReadsBackAndLabelsAnotherPerson() throws IOException {
        assertEquals(0, trained.code(), trained.err());
        assertTrue(trained.out().contains("Against the rig's truth"), trained.out());
        Run again = Run.of("states", "apply", TRAIN, "--model", model(), "--out", folder.resolve("again").toString());
        assertEquals(0, again.code(), again.err());
        for (String file : new String[] {"labels.csv", "labels.arff", "bags.arff"}) {
            assertEquals(-1, Files.mismatch(shared.resolve("model").resolve(file), folder.resolve("again").resolve(file)), file);
        }
        Run other = Run.of("states", "apply", OTHER, "--model", model(), "--out", folder.resolve("other").toString());
        assertEquals(0, other.code(), other.err());
        JsonNode results = new ObjectMapper().readTree(folder.resolve("other/results.json").toFile());
        assertTrue(results.at("/against_truth/accuracy").asDouble() > 0.93, results.toString());
        assertTrue(results.at("/against_truth/forecasts/0/area_under_curve").asDouble() > 0.9, results.toString());
        assertTrue(results.at("/against_truth/forecasts/0/calibration_error").asDouble() < 0.05, results.toString());
        assertEquals(7201, Files.readString(folder.resolve("other/labels.csv")).lines().count());
        String html = Files.readString(folder.resolve("other/report.html"));
        assertTrue(html.contains("class=\"graph\"") && html.contains("Against the truth"));
    }

    @Test
    void tasksDoTheSameAndTheLearnerFollowsInMoa() throws IOException {
        Path model = folder.resolve("task.json");
        Run train = Run.of("task", "wbv.task.TrainStates -f " + TRAIN + "," + BARE + " -x single -m " + model);
        assertEquals(0, train.code(), train.err());
        assertEquals(new ObjectMapper().readTree(Path.of(model()).toFile()).get("training_rows"),
                new ObjectMapper().readTree(model.toFile()).get("training_rows"));
        Path labels = folder.resolve("labels.arff");
        Run apply = Run.of("task", "wbv.task.ApplyStates -f " + OTHER + " -m " + model + " -t " + labels);
        assertEquals(0, apply.code(), apply.err());
        assertTrue(apply.out().startsWith("state,seconds"), apply.out());
        for (String learner : new String[] {"wbv.learn.StateLearner", "(wbv.learn.StateLearner -m " + model + ")"}) {
            Run votes = Run.of("task", "EvaluatePrequential -l " + learner + " -s (ArffFileStream -f " + labels + ") -f 7200 -q "
                    + "7200 "
                    + "-e BasicClassificationPerformanceEvaluator");
            assertEquals(0, votes.code(), votes.err());
            // Two minutes of strong vibration, the learning included: what repeats the last label is right in 77 %.
            assertTrue(last(votes, "Kappa Temporal Statistic (percent)") > 30, learner + "\n" + votes.out());
            assertTrue(last(votes, "classifications correct (percent)") > (learner.contains("-m") ? 90 : 85), learner + "\n"
                    + votes.out());
        }
    }

    /** Against a guesser that repeats the last true label, which at 60 Hz is right nine times in ten. */
    @Test
    void followedInMoaTheStatesBeatTheLastLabel() {
        Run votes = Run.of("task", "EvaluatePrequential -l (wbv.learn.StateLearner -m " + model() + ") -s (wbv.stream.StateStream -e "
                + "'subject=4 excitation=ride:7 seconds=60' -r 5) -f 3600 -q 3600 -e BasicClassificationPerformanceEvaluator");
        assertEquals(0, votes.code(), votes.err());
        assertTrue(last(votes, "Kappa Temporal Statistic (percent)") > 30, votes.out());
    }

    /** An endless ride; what it says is what the recording's command says of as much of it. */
    @Test
    void lagIsFollowedInMoa() {
        Run lag = Run.of("task", "wbv.task.FollowLag -s (wbv.stream.RigStream -e 'excitation=ride:1 seconds=1000000' -r 3 -i "
                + "seat.acc.z) -e 20 -n 60");
        assertEquals(0, lag.code(), lag.err());
        assertEquals(4, lag.out().strip().lines().count(), lag.out());
        assertEquals(30, last(lag, "lag [ms]"), 5);
        assertTrue(last(lag, "jolts") > 4 && last(lag, "standard deviation of lag [ms]") < 3, lag.out());
        Run still = Run.of("task", "wbv.task.FollowLag -s (wbv.stream.RigStream -e 'excitation=regime:1 seconds=40' -i seat.acc.z)");
        assertTrue(Double.isNaN(last(still, "lag [ms]")), still.out());
        assertEquals(1, Run.of("task", "wbv.task.FollowLag -s (wbv.stream.RigStream -e 'excitation=ride:1 rate=10' -i seat.acc.z)").code());
    }

    private static double last(Run run, String column) {
        String[] head = run.out().lines().filter(line -> line.contains(column)).findFirst().orElseThrow().split(",");
        String[] last = run.out().strip().lines().reduce((a, b) -> b).orElseThrow().split(",");
        return Double.parseDouble(last[java.util.Arrays.asList(head).indexOf(column)].replace("?", "NaN"));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "idle | subject=1 excitation=idle seconds=20 | 'idle'",
        "short | subject=1 excitation=ride:1 seconds=0.2 | two kinds of motion",
        "channels | sitter=one-dof seconds=20 | no channel seat.acc.z"})
    void whatCannotBeLearnedFromIsOneLine(String name, String rig, String said) throws IOException {
        Path file = folder.resolve(name + ".csv");
        Run.of(("simulate " + rig + (name.equals("channels") ? "" : " channels=seat,head") + " --out " + file).split(" "));
        refused(said, "states", "train", file.toString(), "--out", folder.resolve("out").toString());
    }

    @Test
    void modelForOtherChannelsRatesOrFilesIsRefused() throws IOException {
        refused("seat.acc.z", "states", "apply", "data/arff/one-dof-linear.arff", "--model", model(), "--out",
                folder.resolve("out").toString());
        Path fast = folder.resolve("fast.csv");
        Run.of("simulate", "subject=1", "regime=1", "seconds=3", "rate=100", "channels=seat,head", "--out", fast.toString());
        refused("samples a second", "states", "apply", fast.toString(), "--model", model(), "--out", folder.resolve("out")
                .toString());
        Path silent = folder.resolve("silent.csv");
        Files.writeString(silent, "t,seat.acc.z,head.acc.z,seat.gyr.x,seat.gyr.y\n" + IntStream.range(0, 60)
                .mapToObj(i -> i / 60.0 + ",,,,\n").collect(Collectors.joining()));
        refused("no sample has all of", "states", "apply", silent.toString(), "--model", model(), "--out", folder.resolve("out")
                .toString());
        refused("is a folder", "states", "apply", TRAIN, "--model", shared.resolve("model").toString(), "--out",
                folder.resolve("out").toString());
        refused("no such file", "states", "apply", TRAIN, "--model", folder.resolve("none.json").toString(), "--out",
                folder.resolve("out").toString());
        for (String[] change : new String[][] {{"\"wbv_states\" : 2", "\"wbv_states\" : 1", "version"}, {"\"name\" : \"idle\"",
            "\"name\" : \"flying\"", "flying"}, {"\"rate_Hz\"", "\"rate\"", "rate_Hz"},
            {"\"mean\" : [ ", "\"mean\" : [ \"x\", ",
                "mean"}}) {
            Path spoilt = folder.resolve("spoilt.json");
            Files.writeString(spoilt, Files.readString(Path.of(model())).replace(change[0], change[1]));
            refused(change[2], "states", "apply", TRAIN, "--model", spoilt.toString(), "--out", folder.resolve("out").toString());
        }
    }

    @Test
    void channelThatIsGoneForSecondsLeavesLabelsAllTheSame() throws IOException {
        StringBuilder text = new StringBuilder();
        int row = 0;
        for (String line : Files.readAllLines(Path.of(OTHER))) {
            boolean data = !line.isEmpty() && !line.startsWith("%") && !line.startsWith("@");
            row += data ? 1 : 0;
            if (row > 3000) {
                break; // fifty seconds are enough
            }
            text.append(data && row > 1200 && row < 1500 ? line.replaceFirst("^([^,]*,[^,]*),[^,]*", "$1,?") : line).append('\n');
        }
        Path holes = Files.writeString(folder.resolve("holes.arff"), text.toString());
        Run run = Run.of("states", "apply", holes.toString(), "--model", model(), "--out", folder.resolve("out").toString());
        assertEquals(0, run.code(), run.err());
        assertFalse(Files.readString(folder.resolve("out/labels.csv")).contains("NaN"));
    }

    @Test
    void wrongUsage() {
        assertEquals(2, Run.of("states").code());
        assertEquals(2, Run.of("states", "train", TRAIN, "--mixture", "soup").code());
        assertEquals(2, Run.of("states", "train", TRAIN, "--jerk", "-1").code());
        assertEquals(2, Run.of("states", "apply", TRAIN).code());
    }

    private void refused(String said, String... words) {
        Run run = Run.of(words);
        assertEquals(1, run.code(), run.err());
        assertEquals(1, run.err().strip().lines().count(), run.err());
        assertTrue(run.err().contains(said), run.err());
        assertFalse(Files.exists(folder.resolve("out")));
    }
}
