package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.rig.RigFiles;
import wbv.rig.RigSpec;

/** The commands {@code poles} and {@code track --without}, and the MOA tasks of the same, from files to files. */
class PolesTest {

    @TempDir
    private Path folder;

    @Tag("slow")
    @Test
    void polygonsAreTrainedAndServeWithoutTheSensor() throws IOException {
        List<String> words = new ArrayList<>(List.of("poles"));
        for (String level : List.of("0.6", "1", "1.5")) {
            words.add(rig("ride" + level + ".csv", 1, level, "head").toString());
        }
        Path out = folder.resolve("out");
        Path stranger = rig("stranger.csv", 2, "0.9", "head");
        words.addAll(List.of("--absent", "head", "--window", "15", "--hop", "5", "--check", stranger.toString(), "--out",
                out.toString()));
        Run trained = Run.of(words.toArray(String[]::new));
        assertEquals(0, trained.code(), trained.err());
        assertTrue(trained.out().contains("Head.acc.z can be predicted without its sensor: "), trained.out());
        JsonNode results = new ObjectMapper().readTree(out.resolve("results.json").toFile());
        assertTrue(results.get("predicted").get(0).get("holds").asBoolean());
        assertTrue(results.get("predicted").get(0).get("most").asDouble() < 0.5);
        JsonNode file = new ObjectMapper().readTree(out.resolve("polygons.json").toFile());
        assertEquals("FeatureCollection", file.get("type").asText());
        assertTrue(file.get("features").size() > 16);
        assertTrue(Files.readString(out.resolve("poles.csv")).lines().count() > 15);
        assertTrue(Files.size(out.resolve("report.html")) > 10_000);

        Path without = rig("without.csv", 2, "0.9", "pelvis");
        Path predicted = folder.resolve("predicted");
        String polygons = out.resolve("polygons.json").toString();
        Run run = Run.of("track", without.toString(), "--without", "head", "--polygons", polygons, "--out", predicted.toString());
        assertEquals(0, run.code(), run.err());
        assertEquals(2400, Files.readString(predicted.resolve("prediction.csv")).lines().filter(line -> !line.startsWith("#"))
                .count() - 1);
        assertTrue(Files.readString(predicted.resolve("tracks.csv")).startsWith("t,head.frequency_Hz,head.frequency_lower_Hz"));
        assertTrue(new ObjectMapper().readTree(predicted.resolve("results.json").toFile()).get("poles_seen").asInt() > 0);

        Run task = Run.of("task", "wbv.task.PredictAbsent -f " + stranger + " -p " + polygons);
        assertEquals(0, task.code(), task.err());
        double error = task.out().lines().filter(line -> line.startsWith("error over variance,head.acc.z"))
                .mapToDouble(line -> Double.parseDouble(line.substring(line.lastIndexOf(',') + 1).strip())).findFirst()
                .orElseThrow();
        assertTrue(error < 0.1, task.out());

        Run other = Run.of("track", without.toString(), "--without", "sternum", "--polygons", polygons, "--out",
                folder.resolve("no").toString());
        assertEquals(1, other.code());
        assertEquals(1, other.err().lines().count(), other.err());
        assertFalse(Files.exists(folder.resolve("no")));
        Run linear = Run.of("track", "data/arff/one-dof-linear.arff", "--without", "head", "--polygons", polygons, "--out",
                folder.resolve("no").toString());
        assertEquals(1, linear.code());
        assertTrue(linear.err().contains("one-dof-linear.arff") && linear.err().contains("has no channel"), linear.err());
    }

    @Test
    void whatDoesNotFitIsOneLine() {
        assertEquals(2, Run.of("track", "data/arff/one-dof-linear.arff", "--without", "head").code());
        assertEquals(2, Run.of("poles", "data/arff/one-dof-linear.arff", "--axis", "q").code());
        Run run = Run.of("poles", "data/arff/one-dof-linear.arff", "--out", folder.resolve("out").toString());
        assertEquals(1, run.code());
        assertEquals(1, run.err().lines().count(), run.err());
        assertFalse(Files.exists(folder.resolve("out")));
        assertEquals(1, Run.of("track", "data/arff/one-dof-linear.arff", "--without", "head", "--polygons", "none.json").code());
    }

    private Path rig(String name, int subject, String level, String place) throws IOException {
        Path file = folder.resolve(name);
        RigFiles.write(RigSpec.parse("subject=" + subject + " excitation=random:z:0.5-12:" + level
                + " seconds=40 seed=" + (subject + level.length())
                + " channels=platform.acc.x,platform.acc.z,platform.gyr.y,seat.acc.z," + place + ".acc.z"), file, false);
        return file;
    }
}
