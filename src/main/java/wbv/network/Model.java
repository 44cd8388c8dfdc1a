package wbv.network;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.InputFile;

/**
 * A trained network, or several of one architecture that were trained from different seeds and are asked together.
 *
 * <p>As a file it is one {@link SafeTensors}: the card, what standardises images and targets, and of member i the weights
 * {@code i.NAME}.
 *
 * @param architecture of all members
 * @param channels     the excitation, the answer and what else of the base's motion it was trained on
 * @param modes        of the body
 * @param scaling      of images and targets
 * @param widening     by which the stated deviations of each target are multiplied, so that 90 % intervals held on trials held
 * back
 * @param usual        what windows are held against
 * @param members      weights of each member by name
 * @param card         what a reader of the file should know: data, seed, split, figures, limits
 */
public record Model(Architecture architecture, List<Channel> channels, int modes, Scaling scaling, double[] widening,
                    Usual usual, List<Map<String, SafeTensors.Tensor>> members, Map<String, String> card) {

    /** Goes up whenever an older reader would misread a file. */
    private static final String VERSION = "2";
    private static final ObjectMapper MAPPER = new ObjectMapper();
    private static final String CARD = "card.";

    public Model {
        channels = List.copyOf(channels);
        members = List.copyOf(members);
        if (members.isEmpty() || modes < 1 || scaling.targets() != 2 * modes || widening.length != 2 * modes
                || usual.widening().length != 2 * modes) {
            throw new IllegalArgumentException("a model needs a member, a mode, and two targets for each mode");
        }
    }

    /** The model as a file. */
    public byte[] bytes() {
        Map<String, String> words = new LinkedHashMap<>();
        words.put("wbv.network", VERSION);
        words.put("architecture", architecture.word());
        words.put("channels", String.join(" ", channels.stream().map(Channel::toString).toList()));
        words.put("planes", String.join(",", architecture.imaging().planes().stream().map(Plane::toString).toList()));
        words.put("modes", Integer.toString(modes));
        words.put("members", Integer.toString(members.size()));
        words.put("plane_mean", json(scaling.planeMean()));
        words.put("plane_deviation", json(scaling.planeDeviation()));
        words.put("mean", json(scaling.mean()));
        words.put("deviation", json(scaling.deviation()));
        words.put("widening", json(widening));
        words.put("usual", json(new double[] {usual.left(), usual.coloured(), usual.moved()}));
        words.put("usual_widening", json(usual.widening()));
        card.forEach((name, text) -> words.put(CARD + name, text));
        Map<String, SafeTensors.Tensor> tensors = new LinkedHashMap<>();
        for (int i = 0; i < members.size(); i++) {
            int member = i;
            members.get(i).forEach((name, tensor) -> tensors.put(member + "." + name, tensor));
        }
        return new SafeTensors(words, tensors).bytes();
    }

    /** @throws DataFault if the file is no model of this version */
    public static Model read(Path file) throws IOException {
        return parse(file.toString(), InputFile.bytes(file, "a model is what 'wbv net train' writes"));
    }

    /** The model that comes with wbv for bodies of one mode, or of two. */
    public static Model shipped(int modes) {
        String name = "pooled-" + modes + "-dof.safetensors";
        try (InputStream in = Model.class.getResourceAsStream(name)) {
            if (in == null) {
                throw new DataFault("no model for " + modes + " modes comes with wbv; train one with 'wbv net train'");
            }
            return parse(name, in.readAllBytes());
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    /** @param name of the file, for messages */
    public static Model parse(String name, byte[] bytes) {
        SafeTensors file = SafeTensors.parse(name, bytes);
        Map<String, String> words = file.words();
        if (!VERSION.equals(words.get("wbv.network"))) {
            throw DataFault.in(name, words.containsKey("wbv.network")
                    ? "is a model of version " + words.get("wbv.network") + "; this wbv reads version " + VERSION
                    : "is no model of wbv; a model is what 'wbv net train' writes");
        }
        try {
            Architecture architecture = Architecture.named(words.get("architecture")).orElseThrow();
            List<Plane> planes = Arrays.stream(words.get("planes").split(",")).map(Plane::parse).toList();
            if (!planes.equals(architecture.imaging().planes())) {
                throw DataFault.in(name, "was trained on other images, " + planes + ", than this wbv makes, "
                        + architecture.imaging().planes());
            }
            List<Map<String, SafeTensors.Tensor>> members = new ArrayList<>();
            for (int i = 0; i < Integer.parseInt(words.get("members")); i++) {
                String prefix = i + ".";
                Map<String, SafeTensors.Tensor> weights = new LinkedHashMap<>();
                file.tensors().forEach((key, tensor) -> {
                    if (key.startsWith(prefix)) {
                        weights.put(key.substring(prefix.length()), tensor);
                    }
                });
                members.add(weights);
            }
            Map<String, String> card = new LinkedHashMap<>();
            words.forEach((key, text) -> {
                if (key.startsWith(CARD)) {
                    card.put(key.substring(CARD.length()), text);
                }
            });
            double[] usual = numbers(words, "usual");
            return new Model(architecture, Arrays.stream(words.get("channels").split(" ")).map(Channel::parse).toList(),
                    Integer.parseInt(words.get("modes")), new Scaling(numbers(words, "plane_mean"), numbers(words,
                    "plane_deviation"), numbers(words, "mean"), numbers(words, "deviation")), numbers(words, "widening"),
                    new Usual(usual[0], usual[1], usual[2], numbers(words, "usual_widening")), members, card);
        } catch (JsonProcessingException | RuntimeException wrong) {
            if (wrong instanceof DataFault fault) {
                throw fault;
            }
            throw DataFault.in(name, "its card is damaged: " + wrong.getMessage(), wrong);
        }
    }

    /** The same network with one of its members alone. */
    public Model member(int number) {
        return new Model(architecture, channels, modes, scaling, widening, usual, List.of(members.get(number)), card);
    }

    Model with(double[] widening, Usual usual, Map<String, String> card) {
        return new Model(architecture, channels, modes, scaling, widening, usual, members, card);
    }

    private static String json(double[] values) {
        return MAPPER.valueToTree(values).toString();
    }

    private static double[] numbers(Map<String, String> words, String key) throws JsonProcessingException {
        return MAPPER.readValue(words.get(key), double[].class);
    }
}
