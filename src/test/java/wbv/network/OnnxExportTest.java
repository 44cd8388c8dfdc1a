package wbv.network;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Properties;
import org.junit.jupiter.api.Test;

/** The model that ships as ONNX: the very bytes that onnxruntime was given, and what it answered. */
class OnnxExportTest {

    private static final Path STORED = Path.of("src/test/resources/wbv/network/onnxruntime.properties");

    @Test
    void otherEnginesGiveWhatOursGives() throws IOException, NoSuchAlgorithmException {
        Properties stored = new Properties();
        try (var in = Files.newBufferedReader(STORED, StandardCharsets.UTF_8)) {
            stored.load(in);
        }
        byte[] bytes = OnnxExport.of(TrainedNetwork.shipped(1));
        assertEquals(stored.getProperty("sha256"), HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes)),
                "the file that onnxruntime was given is another; ask it again");
        WithEngine.orSkip();
        double[][] motion = new double[2][Imaging.SAMPLES];
        Arrays.setAll(motion[0], n -> Math.sin(0.21 * n) + 0.6 * Math.cos(0.57 * n + 1) + 0.3 * Math.sin(0.93 * n + 2));
        Arrays.setAll(motion[1], n -> 1.3 * Math.sin(0.21 * n - 0.4) + 0.7 * Math.cos(0.57 * n) + 0.1 * Math.sin(0.93 * n));
        try (Reader reader = new Reader(TrainedNetwork.shipped(1))) {
            Estimate estimate = reader.ask(List.<double[][]>of(motion)).get(0);
            assertArrayEquals(numbers(stored, "value"), estimate.value(), 1e-3);
            assertArrayEquals(numbers(stored, "deviation"), estimate.deviation(), 1e-3);
        }
    }

    private static double[] numbers(Properties stored, String key) {
        return Arrays.stream(stored.getProperty(key).split(" ")).mapToDouble(Double::parseDouble).toArray();
    }
}
