package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.network.WithEngine;

/** {@code net train} on recordings with labels. */
class NetLabelsTest {

    private static final String HEADER = "recording,from_s,to_s,damping,frequency_Hz\n";
    private static final String TWO = "recording,from_s,to_s,damping1,frequency1_Hz,damping2,frequency2_Hz\n";

    @TempDir
    private Path folder;

    /** Sixteen linear bodies teach a network to read four that it never saw, nearer to the truth than their mean is. */
    @Tag("slow")
    @Test
    void aNetworkTrainedOnLabelledRecordingsReadsOthersBetterThanTheMean() throws IOException {
        WithEngine.orSkip();
        List<String> words = new ArrayList<>(List.of("net", "train"));
        StringBuilder labels = new StringBuilder(HEADER);
        double sum = 0;
        for (int i = 0; i < 16; i++) {
            double frequency = 2.5 + 0.4 * i;
            double damping = 0.15 + 0.05 * (7 * i % 9);
            sum += frequency / 16;
            words.add(ride(i, frequency, damping).toString());
            labels.append(String.format(Locale.ROOT, "ride%d.csv,1,15,%s,%s%n", i, damping, frequency));
        }
        words.addAll(List.of("--labels", written("labels.csv", labels).toString(), "--input", "platform.acc.z", "--hop", "0.6", "--epochs",
                "10"));
        words.addAll(List.of("--out", folder.resolve("a").toString()));
        Run run = Run.of(words.toArray(String[]::new));
        assertEquals(0, run.code(), run.err());
        Path model = folder.resolve("a/model.safetensors");
        double network = 0;
        double mean = 0;
        for (int i = 0; i < 4; i++) {
            double frequency = 2.7 + 1.6 * i;
            Path out = folder.resolve("read" + i);
            Run read = Run.of("net", "predict", ride(100 + i, frequency, 0.3).toString(), "--model", model.toString(), "--input",
                    "platform.acc.z", "--out", out.toString());
            assertEquals(0, read.code(), read.err());
            double said = Files.readAllLines(out.resolve("readings.csv")).stream().skip(1)
                    .mapToDouble(line -> Double.parseDouble(line.split(",")[7])).average().orElseThrow();
            network += Math.pow(said - frequency, 2);
            mean += Math.pow(sum - frequency, 2);
        }
        assertTrue(network < 0.1 * mean, Math.sqrt(network / 4) + " Hz to " + Math.sqrt(mean / 4) + " of the mean");
        assertTrue(Files.readString(folder.resolve("a/report.html")).contains("windows of recordings with labels"));
    }

    /** The thesis' images take three axes at both places, of people, and two modes. */
    @Tag("slow")
    @Test
    void theThesisNetworkLearnsFromThreeAxesOfPeople() throws IOException {
        WithEngine.orSkip();
        List<String> words = new ArrayList<>(List.of("net", "train"));
        StringBuilder labels = new StringBuilder(TWO + "# slower first\n\n");
        for (int i = 0; i < 5; i++) {
            Path ride = folder.resolve("person" + i + ".csv");
            assertEquals(0, Run.of("simulate", "subject=random:" + i, "regime=" + (1 + i), "seconds=12",
                    "channels=seat.acc.x,seat.acc.y,seat.acc.z,sternum.acc.x,sternum.acc.y,sternum.acc.z", "--out", ride.toString())
                    .code());
            words.add(ride.toString());
            labels.append(ride).append(",0,11.9,0.").append(2 + i).append(',').append(4.5 + 0.2 * i).append(",0.3").append(i).append(',')
                    .append(10 + i).append('\n');
        }
        words.addAll(List.of("--labels", written("labels.csv", labels).toString(), "--output", "sternum.acc.z", "--network", "thesis-cnn",
                "--hop", "0.5", "--epochs", "2", "--out", folder.resolve("model").toString()));
        Run run = Run.of(words.toArray(String[]::new));
        assertEquals(0, run.code(), run.err());
        Run read = Run.of("net", "predict", folder.resolve("person0.csv").toString(), "--model",
                folder.resolve("model/model.safetensors").toString(), "--out", folder.resolve("out").toString());
        assertEquals(0, read.code(), read.err());
        assertTrue(Files.readString(folder.resolve("out/readings.csv")).startsWith("t,damping1,"));
    }

    @Test
    void whatDoesNotFitIsOneLine() throws IOException {
        WithEngine.orSkip();
        String ride = ride(0, 5, 0.3).toString();
        String good = "ride0.csv,0,14,0.3,5\n";
        fault("labels.csv:1: labels begin with the line recording,from_s", "recording;from\n", ride);
        fault("labels.csv: has no label", HEADER, ride);
        fault("labels.csv:2: a label has 5 cells", HEADER + "ride0.csv,0,14,0.3\n", ride);
        fault("labels.csv:3: is not a number: 'stiff'", HEADER + good + "ride0.csv,0,14,0.3,stiff\n", ride);
        fault("labels.csv:2: must be a finite number: 'NaN'", HEADER + "ride0.csv,0,14,NaN,5\n", ride);
        fault("labels.csv:2: a stretch must hold a window, 3.65 s: 0.0 to 2.0 s", HEADER + "ride0.csv,0,2,0.3,5\n", ride);
        fault("labels.csv:2: a damping ratio must be > 0 to 3: 30", HEADER + "ride0.csv,0,14,30,5\n", ride);
        fault("labels.csv:2: a frequency must be > 0 to 30 Hz: -5", HEADER + "ride0.csv,0,14,0.3,-5\n", ride);
        fault("labels.csv:3: overlaps line 2", HEADER + good + "ride0.csv,5,12,0.3,6\n", ride);
        fault("labels.csv:2: 'other.csv' is none of the recordings", HEADER + "other.csv,0,14,0.3,5\n", ride);
        fault("labels.csv:2: 'ride0.csv' is more than one of the recordings", HEADER + good, ride, ride);
        fault("ride1.csv: has no line in", HEADER + good, ride, ride(1, 6, 0.3).toString());
        fault("labels.csv:2: " + ride + " lasts from 0.0 to 15.98", HEADER + "ride0.csv,0,20,0.3,5\n", ride);
        fault("at least 4 recordings with labels", HEADER + good, ride);
        fault("labels.csv:2: the slower mode stands first", TWO + "ride0.csv,0,14,0.3,9,0.3,5\n", ride);
        List<String> four = new ArrayList<>();
        StringBuilder same = new StringBuilder(HEADER);
        for (int i = 0; i < 4; i++) {
            four.add(ride(i, 5, 0.3).toString());
            same.append("ride").append(i).append(".csv,0,14,0.3,5\n");
        }
        fault("have the same damping ratio", same.toString(), four.toArray(String[]::new));
        fault("needs at least 40 windows", same.toString().replace(",14,", ",4,"), four.toArray(String[]::new));
        Path labels = written("labels.csv", HEADER + good);
        assertEquals(2, Run.of("net", "train", ride).code());
        assertEquals(2, Run.of("net", "train", "--labels", labels.toString()).code());
        assertEquals(2, Run.of("net", "train", ride, "--labels", labels.toString(), "--images", "60").code());
        assertEquals(2, Run.of("net", "train", "--hop", "1").code());
        assertEquals(2, Run.of("net", "train", "--network", "thesis-cnn").code());
    }

    private void fault(String words, String labels, String... recordings) throws IOException {
        List<String> all = new ArrayList<>(List.of("net", "train"));
        all.addAll(Arrays.asList(recordings));
        Path out = folder.resolve("no");
        all.addAll(List.of("--labels", written("labels.csv", labels).toString(), "--input", "platform.acc.z", "--hop", "0.5", "--out",
                out.toString()));
        Run run = Run.of(all.toArray(String[]::new));
        assertEquals(1, run.code(), run.err());
        assertEquals(1, run.err().lines().count(), run.err());
        assertTrue(run.err().contains(words), run.err());
        assertFalse(Files.exists(out));
    }

    private Path written(String name, CharSequence text) throws IOException {
        return Files.writeString(folder.resolve(name), text);
    }

    private Path ride(int number, double frequency, double damping) {
        Path file = folder.resolve("ride" + number + ".csv");
        if (!Files.exists(file)) {
            Run run = Run.of("simulate", "sitter=one-dof", "f0=" + frequency, "zeta=" + damping, "seconds=16", "seed=" + (1 + number),
                    "--out", file.toString());
            assertEquals(0, run.code(), run.err());
        }
        return file;
    }
}
