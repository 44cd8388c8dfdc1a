package wbv.export;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;
import wbv.recording.format.RecordingWriter;

/** Models with every law, drive and fault, and a recording that drives them. */
final class Cases {

    private static final List<String> CHANNELS = List.of("platform.acc.z", "platform.acc.x", "platform.gyr.y", "platform.vel.z",
            "platform.pos.z", "seat.force.z", "head.acc.x", "head.acc.y");

    private Cases() {}

    /** The models of src/test/resources/export/models.json. */
    static List<Model> models() throws IOException {
        List<Model> out = new ArrayList<>();
        for (JsonNode node : new ObjectMapper().readTree(Path.of("src/test/resources/export/models.json").toFile())) {
            out.add(ModelFile.parse(node.toString(), node.get("name").asText()));
        }
        return out;
    }

    /** Simulated: tones from 1 to 12 Hz of random phases, and a little noise; one gap of two samples. */
    static Recording recording(int samples, double rate, long seed) {
        Random random = new Random(seed);
        Map<Channel, double[]> values = new LinkedHashMap<>();
        for (String name : CHANNELS) {
            double[] x = new double[samples];
            double size = name.contains("force") ? 12
                    : name.contains("gyr") ? 0.1 : name.contains("vel") ? 0.02 : name.contains("pos") ? 2e-3 : 0.6;
            for (int tone = 0; tone < 12; tone++) {
                double phase = 2 * Math.PI * random.nextDouble();
                double frequency = 1 + 11 * random.nextDouble();
                for (int i = 0; i < samples; i++) {
                    x[i] += size * Math.sin(2 * Math.PI * frequency * i / rate + phase) / Math.sqrt(6);
                }
            }
            for (int i = 0; i < samples; i++) {
                x[i] = (float) (x[i] * Math.min(1, i / (0.5 * rate)) + 0.002 * size * random.nextGaussian());
            }
            values.put(Channel.parse(name), x);
        }
        values.get(Channel.parse("platform.acc.z"))[samples / 2] = Double.NaN;
        values.get(Channel.parse("platform.pos.z"))[samples / 2] = Double.NaN;
        return new Recording(new Clock(0, rate), values, Metadata.NONE.withRate(java.util.OptionalDouble.of(rate)));
    }

    static void write(Recording recording, Path file) throws IOException {
        List<Channel> channels = List.copyOf(recording.channels());
        try (RecordingWriter writer = RecordingWriter.create(file, channels, recording.metadata())) {
            double[] row = new double[1 + channels.size()];
            for (int i = 0; i < recording.length(); i++) {
                row[0] = recording.clock().time(i);
                for (int c = 0; c < channels.size(); c++) {
                    row[1 + c] = recording.values(channels.get(c))[i];
                }
                writer.write(row);
            }
            writer.finish();
        }
    }

    /** Whether a command runs here. */
    static boolean runs(String... command) {
        try {
            return new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD).start().waitFor()
                    == 0;
        } catch (IOException e) {
            return false;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    /** Runs a command in a folder. @return what it printed @throws AssertionError with that, if it failed */
    static String run(Path folder, String... command) throws IOException, InterruptedException {
        Path log = folder.resolve("log.txt");
        int code = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).redirectOutput(log.toFile()).start()
                .waitFor();
        if (code != 0) {
            throw new AssertionError(String.join(" ", command) + ": " + Files.readString(log));
        }
        return Files.readString(log);
    }
}
