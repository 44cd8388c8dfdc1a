package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;

/**
 * A trunk that leans 0.1 rad forward and a head that nods on it by 0.3 sin(2π 0.2 t), both shaken upwards; the head's sensor is
 * worn turned by 90° about the left. Five seconds at the beginning are still. All in closed form.
 */
class DeriveTest {

    private static final double G = 9.80665;
    private static final double RATE = 100;

    @TempDir
    private Path folder;

    private Path worn(boolean quaternions) throws IOException {
        StringBuilder text = new StringBuilder("t");
        for (String place : List.of("sternum", "head")) {
            text.append(String.format(",%1$s.accg.x,%1$s.accg.y,%1$s.accg.z,%1$s.gyr.x,%1$s.gyr.y,%1$s.gyr.z", place));
            text.append(quaternions ? String.format(",%1$s.quat.w,%1$s.quat.x,%1$s.quat.y,%1$s.quat.z", place) : "");
        }
        text.append('\n');
        for (int n = 0; n < 60 * RATE; n++) {
            double t = n / RATE;
            double[] row = new double[2 * (quaternions ? 10 : 6)];
            fill(row, 0, pitch(t, false), (pitch(t, false) - pitch(t - 1 / RATE, false)) * RATE, shake(t), 0, quaternions);
            fill(row, row.length / 2, pitch(t, true), (pitch(t, true) - pitch(t - 1 / RATE, true)) * RATE, shake(t), Math.PI / 2,
                    quaternions);
            text.append(String.format(Locale.ROOT, "%.2f", t));
            for (double value : row) {
                text.append(',').append(value);
            }
            text.append('\n');
        }
        return Files.writeString(folder.resolve("worn.csv"), text);
    }

    /** Upright in the still pose, then leaning and nodding. */
    private static double pitch(double t, boolean head) {
        double grown = Math.max(0, Math.min(1, (t - 6) / 2));
        return grown * (0.1 + (head ? 0.3 * Math.sin(2 * Math.PI * 0.2 * (t - 6)) : 0));
    }

    private static double shake(double t) {
        return t < 6 ? 0 : 0.8 * Math.sin(2 * Math.PI * 4 * t);
    }

    /** A sensor worn so that its own axes must be turned by {@code worn} about y to become the body's. */
    private static void fill(double[] row, int at, double pitch, double rate, double up, double worn, boolean quaternion) {
        double whole = pitch + worn;
        row[at] = -(G + up) * Math.sin(whole);     // R_y(whole)⁻¹ (0, 0, g + up)
        row[at + 2] = (G + up) * Math.cos(whole);
        row[at + 4] = rate;
        if (quaternion) {
            row[at + 6] = Math.cos(whole / 2);
            row[at + 8] = Math.sin(whole / 2);
        }
    }

    private Recording derived(Path file, String... options) throws IOException {
        Path out = folder.resolve("derived.csv");
        List<String> words = new ArrayList<>(List.of("convert", file.toString(), "--out", out.toString()));
        words.addAll(List.of(options));
        Run run = Run.of(words.toArray(String[]::new));
        assertEquals(0, run.code(), run.err());
        return new RecordingFile(out).load();
    }

    private static double value(Recording recording, String channel, int n) {
        return recording.values(Channel.parse(channel))[n];
    }

    @ParameterizedTest
    @CsvSource({"true, 1e-9, 1e-9", "false, 0.02, 0.15"})
    void theNeckAndTheFreeHead(boolean quaternions, double radians, double acceleration) throws IOException {
        Recording found = derived(worn(quaternions), "--still", "0:5", "--free", "head", "--joint", "sternum:head=neck");
        for (int n = (int) (20 * RATE); n < found.length(); n += 17) {
            double t = n / RATE;
            assertEquals(pitch(t, true) - pitch(t, false), value(found, "neck.ang.y", n), radians, "flexion at " + t + " s");
            assertEquals(0, value(found, "neck.ang.x", n), radians);
            assertEquals(0, value(found, "neck.ang.z", n), radians);
            assertEquals(shake(t) * Math.cos(pitch(t, true)), value(found, "head.acc.z", n), acceleration);
            assertEquals(-shake(t) * Math.sin(pitch(t, true)), value(found, "head.acc.x", n), acceleration);
        }
    }

    /** 0.2 m above the head's sensor, nodding at 0.2 Hz: a = a_O + θ'' × r - r θ'². */
    @Test
    void aPointOfTheHead() throws IOException {
        Recording found = derived(worn(true), "--still", "0:5", "--lever", "head:0:0:0.2=crown");
        double w = 2 * Math.PI * 0.2;
        for (int n = (int) (20 * RATE); n < 55 * RATE; n += 13) {
            double t = n / RATE - 0.5 / RATE;   // the rate of a step stands for its middle
            double turning = -0.3 * w * w * Math.sin(w * (t - 6));
            double rate = 0.3 * w * Math.cos(w * (t - 6));
            assertEquals(value(found, "head.accg.x", n) + 0.2 * turning, value(found, "crown.accg.x", n), 2e-3);
            assertEquals(value(found, "head.accg.z", n) - 0.2 * rate * rate, value(found, "crown.accg.z", n), 2e-3);
        }
        assertTrue(Double.isNaN(value(found, "crown.accg.x", 3)));
        assertTrue(Double.isNaN(value(found, "crown.accg.x", found.length() - 1)));
        assertFalse(Double.isNaN(value(found, "crown.accg.x", found.length() - 30)));
        assertEquals(6000, found.length());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "--free=knee               | all of knee.accg.xyz",
        "--still=10:20             | should be still",
        "--still=0:0.5             | too few",
        "--joint=sternum:knee=neck | knee",
        "--free=head --settling=0.01 | a settling time of 10 samples or more",
        "--lever=head:0:0:1=sternum | sternum.accg.x already"})
    void whatCannotBeDerivedIsSaid(String option, String said) throws IOException {
        Path out = folder.resolve("derived.csv");
        List<String> words = new ArrayList<>(List.of("convert", worn(false).toString(), "--out", out.toString()));
        words.addAll(List.of(option.trim().split(" ")));
        Run run = Run.of(words.toArray(String[]::new));
        assertEquals(1, run.code(), run.err());
        assertEquals(1, run.err().strip().lines().filter(line -> line.startsWith("wbv: ")).count(), run.err());
        assertTrue(run.err().contains(said.trim()), run.err());
        assertFalse(Files.exists(out));
    }

    @ParameterizedTest
    @ValueSource(strings = {"--still=5", "--still=5:1", "--lever=head:1:2=x", "--lever=head:1:2:a=x", "--joint=head:head=neck",
        "--joint=sternum:head=Neck", "--settling=0", "--settling=1e9", "--lever=head:1e308:0:0.3=x"})
    void wrongWordsAreWrongUsage(String option) {
        String out = folder.resolve("x.csv").toString();
        assertEquals(2, Run.of("convert", "data/arff/one-dof-linear.arff", option, "--out", out).code());
    }
}
