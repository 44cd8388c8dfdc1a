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
 * @param widening     factors, one for each target, by which the stated deviations of each target are multiplied, so that 90 % intervals
 *                     held on trials held back
 * @param usual        what windows are held against
 * @param members      weights of each member by name
 * @param card         what a reader of the file should know: data, seed, split, figures, limits
 */
public record TrainedNetwork(Architecture architecture, List<Channel> channels, int modes, Scaling scaling, double[] widening,
        Usual usual, List<Map<String, SafeTensors.Tensor>> members, Map<String, String> card) {

    /** Goes up whenever an older reader would misread a file. */
    private static final String VERSION = "2";
    private static final ObjectMapper MAPPER = new ObjectMapper();
    private static final String CARD = "card.";
    private static final int MOST_MEMBERS = 100;

    public TrainedNetwork {
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
        words.put("planes", String.join(",", architecture.imaging().planes().stream().map(ImagePlane::toString).toList()));
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

    /**
     * Reads a model.
     *
     * @throws DataFault if the file is no model of this version
     */
    public static TrainedNetwork read(Path file) throws IOException {
        return parse(file.toString(), InputFile.bytes(file, "a model is what 'wbv net train' writes"));
    }

    /** The model that comes with wbv for bodies of one mode, or of two. */
    public static TrainedNetwork shipped(int modes) {
        String name = "pooled-" + modes + "-dof.safetensors";
        try (InputStream in = TrainedNetwork.class.getResourceAsStream(name)) {
            if (in == null) {
                throw new DataFault("no model for " + modes + " modes comes with wbv; train one with 'wbv net train'");
            }
            return parse(name, in.readAllBytes());
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    /**
     * Reads a model from the bytes of its file.
     *
     * @param name of the file, for messages
     * @param bytes Not modified.
     * @throws DataFault as {@link #read} does
     */
    public static TrainedNetwork parse(String name, byte[] bytes) {
        SafeTensors file = SafeTensors.parse(name, bytes);
        Map<String, String> words = file.words();
        if (!VERSION.equals(words.get("wbv.network"))) {
            throw DataFault.in(name, words.containsKey("wbv.network")
                    ? "is a model of version " + words.get("wbv.network") + "; this wbv reads version " + VERSION
                    : "is no model of wbv; a model is what 'wbv net train' writes");
        }
        try {
            return model(new Card(name, words), file);
        } catch (IllegalArgumentException wrong) {
            throw DataFault.in(name, "its card is damaged: " + wrong.getMessage(), wrong);
        }
    }

    private static TrainedNetwork model(Card card, SafeTensors file) {
        Architecture architecture = Architecture.named(card.text("architecture"))
                .orElseThrow(() -> card.fault("architecture", "must be one of " + Architecture.words()));
        List<ImagePlane> planes = Arrays.stream(card.text("planes").split(",")).map(ImagePlane::parse).toList();
        if (!planes.equals(architecture.imaging().planes())) {
            throw DataFault.in(card.file(), "was trained on other images, " + planes + ", than this wbv makes, "
                    + architecture.imaging().planes());
        }
        List<Map<String, SafeTensors.Tensor>> members = new ArrayList<>();
        int count = card.count("members", MOST_MEMBERS);
        for (int i = 0; i < count; i++) {
            String prefix = i + ".";
            Map<String, SafeTensors.Tensor> weights = new LinkedHashMap<>();
            file.tensors().forEach((key, tensor) -> {
                if (key.startsWith(prefix)) {
                    weights.put(key.substring(prefix.length()), tensor);
                }
            });
            members.add(weights);
        }
        Map<String, String> about = new LinkedHashMap<>();
        card.words().forEach((key, text) -> {
            if (key.startsWith(CARD)) {
                about.put(key.substring(CARD.length()), text);
            }
        });
        int modes = card.count("modes", 2);
        int images = planes.size();
        List<Channel> channels = Arrays.stream(card.text("channels").split(" ")).map(Channel::parse).toList();
        if (channels.size() != architecture.imaging().channels()) {
            throw card.fault("channels", "must be " + architecture.imaging().channels() + " for this architecture");
        }
        double[] usual = card.numbers("usual", 3, false);
        return new TrainedNetwork(architecture, channels, modes, new Scaling(card.numbers("plane_mean", images, false),
                card.numbers("plane_deviation", images, true), card.numbers("mean", 2 * modes, false),
                card.numbers("deviation", 2 * modes, true)), card.numbers("widening", 2 * modes, true),
                new Usual(usual[0], usual[1], usual[2], card.numbers("usual_widening", 2 * modes, true)), members, about);
    }

    /** The words of a file, each checked when it is asked for. */
    private record Card(String file, Map<String, String> words) {

        DataFault fault(String key, String message) {
            return DataFault.in(file, "its card is damaged: '" + key + "' " + message + (words.containsKey(key) ? ": '"
                    + words.get(key) + "'" : ", and is missing"));
        }

        String text(String key) {
            if (!words.containsKey(key)) {
                throw fault(key, "must be there");
            }
            return words.get(key);
        }

        int count(String key, int most) {
            try {
                int count = Integer.parseInt(text(key));
                if (count >= 1 && count <= most) {
                    return count;
                }
            } catch (NumberFormatException none) {
                // said below
            }
            throw fault(key, "must be a whole number from 1 to " + most);
        }

        /**
         * A list of finite numbers.
         *
         * @param positive true where each must be greater than 0
         */
        double[] numbers(String key, int count, boolean positive) {
            try {
                double[] values = MAPPER.readValue(text(key), double[].class);
                if (values != null && values.length == count && Arrays.stream(values).allMatch(value -> Double.isFinite(value)
                        && (!positive || value > 0))) {
                    return values;
                }
            } catch (JsonProcessingException none) {
                // said below
            }
            throw fault(key, "must be " + count + " numbers" + (positive ? " > 0" : ""));
        }
    }

    /** The same network with one of its members alone. */
    public TrainedNetwork member(int number) {
        return new TrainedNetwork(architecture, channels, modes, scaling, widening, usual, List.of(members.get(number)), card);
    }

    TrainedNetwork with(double[] widening, Usual usual, Map<String, String> card) {
        return new TrainedNetwork(architecture, channels, modes, scaling, widening, usual, members, card);
    }

    private static String json(double[] values) {
        return MAPPER.valueToTree(values).toString();
    }
}
