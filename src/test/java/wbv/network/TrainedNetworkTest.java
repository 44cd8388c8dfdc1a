package wbv.network;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import wbv.recording.Channel;
import wbv.recording.DataFault;

class TrainedNetworkTest {

    private static final Path PYTHON = Path.of("src/test/resources/wbv/network/python.safetensors");

    /** Written by the safetensors package of Python, save_file of arange(6).reshape(2, 3)/4 and [1.5, -2]. */
    @Test
    void readsWhatPythonWrites() throws IOException {
        SafeTensors file = SafeTensors.parse("python.safetensors", Files.readAllBytes(PYTHON));
        assertEquals(Map.of("who", "safetensors of Python"), file.words());
        assertArrayEquals(new long[] {2, 3}, file.tensors().get("a").shape());
        assertArrayEquals(new float[] {0, 0.25f, 0.5f, 0.75f, 1, 1.25f}, file.tensors().get("a").values());
        assertArrayEquals(new float[] {1.5f, -2}, file.tensors().get("b").values());
    }

    @Test
    void whatIsWrittenIsReadBack() {
        TrainedNetwork model = model();
        byte[] bytes = model.bytes();
        assertArrayEquals(bytes, TrainedNetwork.parse("again", bytes).bytes());
        assertEquals(model.channels(), TrainedNetwork.parse("again", bytes).channels());
        assertEquals(model.card(), TrainedNetwork.parse("again", bytes).card());
    }

    @Test
    void aFileCutShortIsRefusedWhereverItIsCut() {
        byte[] bytes = model().bytes();
        for (int length : new int[] {0, 5, 8, 100, bytes.length / 2, bytes.length - 1}) {
            DataFault fault = assertThrows(DataFault.class, () -> TrainedNetwork.parse("cut.safetensors", Arrays.copyOf(bytes, length)));
            assertTrue(fault.getMessage().startsWith("cut.safetensors: ") && fault.getMessage().lines().count() == 1,
                    fault.getMessage());
            assertTrue(fault.getMessage().contains("cut short"), fault.getMessage());
        }
    }

    @Test
    void otherVersionsAndOtherFilesAreRefusedInOneLine() throws IOException {
        String text = new String(model().bytes(), StandardCharsets.ISO_8859_1);
        byte[] newer = text.replace("\"wbv.network\":\"2\"", "\"wbv.network\":\"3\"").getBytes(StandardCharsets.ISO_8859_1);
        assertEquals("m: is a model of version 3; this wbv reads version 2",
                assertThrows(DataFault.class, () -> TrainedNetwork.parse("m", newer)).getMessage());
        assertEquals("python: is no model of wbv; a model is what 'wbv net train' writes",
                assertThrows(DataFault.class, () -> TrainedNetwork.parse("python", Files.readAllBytes(PYTHON))).getMessage());
        byte[] planes = text.replace("LEVEL 1 1", "LEVEL 2 2").getBytes(StandardCharsets.ISO_8859_1);
        assertTrue(assertThrows(DataFault.class, () -> TrainedNetwork.parse("m", planes)).getMessage().contains("other images"));
        byte[] damaged = text.replace("\"modes\":\"1\"", "\"modes\":\"x\"").getBytes(StandardCharsets.ISO_8859_1);
        assertTrue(assertThrows(DataFault.class, () -> TrainedNetwork.parse("m", damaged)).getMessage()
                .startsWith("m: its card is damaged"));
    }

    @Test
    void weightsOfAnotherNetworkAreRefused() {
        WithEngine.orSkip();
        String message = assertThrows(DataFault.class, () -> new Reader(model())).getMessage();
        assertTrue(message.contains("has no array") && message.lines().count() == 1, message);
    }

    private static TrainedNetwork model() {
        Map<String, SafeTensors.Tensor> weights = new LinkedHashMap<>();
        weights.put("first", new SafeTensors.Tensor(new long[] {2, 2}, new float[] {1, 2, 3, 4}));
        weights.put("second", new SafeTensors.Tensor(new long[] {}, new float[] {5}));
        double[] two = {0.1, 2};
        return new TrainedNetwork(Architecture.CNN, List.of(Channel.parse("seat.acc.z"), Channel.parse("head.acc.z")), 1,
                new Scaling(two, two, two, two), two, new Usual(0.02, 1.2, 3, two), List.of(weights, weights),
                Map.of("data", "nothing, \"quoted\""));
    }
}
