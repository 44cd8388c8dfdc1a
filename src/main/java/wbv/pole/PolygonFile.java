package wbv.pole;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import wbv.filter.model.Bounds.Attribute;
import wbv.filter.model.Spec;
import wbv.identify.Pole;
import wbv.identify.PoleSet;
import wbv.identify.ScaledResponse;
import wbv.identify.SkyhookBody;
import wbv.identify.TransferModel;
import wbv.identify.TunedResponse;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.InputFile;
import wbv.recording.Quantity;

/**
 * Trained polygons as a file that people can read: a GeoJSON feature collection (RFC 7946 in shape; the axes are attributes of
 * poles, not degrees), every polygon a feature that says what its axes are, and a member {@code wbv} with all else.
 */
public final class PolygonFile {

    private static final ObjectMapper MAPPER = new ObjectMapper();
    private static final int VERSION = 3;

    /** Beyond all that a sitter's response has: fastest pole [Hz], and gain at the resonance, in the inputs' units. */
    private static final double MOST_FREQUENCY = 1e4;
    private static final double MOST_GAIN = 1e6;
    private static final double MOST_COEFFICIENT = 1e60;

    private PolygonFile() {}

    /**
     * The file's text.
     *
     * @param provenance what, and from what, it was made
     */
    public static String text(TrainedPoles trained, Map<String, String> provenance) {
        ObjectNode root = MAPPER.createObjectNode().put("type", "FeatureCollection");
        ObjectNode head = root.putObject("wbv").put("version", VERSION);
        Layout layout = trained.layout();
        strings(head.putArray("inputs"), layout.inputs());
        head.put("measured", layout.measured().toString());
        strings(head.putArray("absent"), layout.absent());
        head.putObject("windows").put("length_s", trained.windows().length()).put("hop_s", trained.windows().hop())
                .put("poles", trained.windows().poles());
        head.putObject("plane").put("centre_re_rad_per_s", trained.plane().centreRe()).put("spread_re_rad_per_s", trained.plane()
                .spreadRe())
                .put("centre_im_rad_per_s", trained.plane().centreIm()).put("spread_im_rad_per_s", trained.plane().spreadIm())
                .put("epsilon_spreads", trained.epsilon());
        pole(head.putObject("typical"), trained.typical());
        ObjectNode responses = head.putObject("responses");
        ObjectNode bodies = head.putObject("mean_bodies");
        for (Channel absent : layout.absent()) {
            TunedResponse tuned = trained.responses().get(absent);
            ScaledResponse response = tuned.response();
            ObjectNode node = responses.putObject(absent.toString()).put("reference_rad_per_s", tuned.reference())
                    .put("exponent", tuned.exponent());
            numbers(node.putArray("a_ascending"), response.a());
            ArrayNode b = node.putArray("b_ascending");
            for (double[] each : response.b()) {
                numbers(b.addArray(), each);
            }
            SkyhookBody body = trained.bodies().get(absent);
            bodies.putObject(absent.toString()).put("frequency_Hz", body.frequency()).put("damping", body.damping())
                    .put("base_share", body.baseShare());
        }
        trained.trials().forEach(head.putArray("trials")::add);
        ObjectNode made = head.putObject("provenance");
        provenance.forEach(made::put);
        ArrayNode features = root.putArray("features");
        feature(features.addObject(), trained.outline()).put("role", "outline").put("channel", layout.measured().toString());
        for (PoleLink link : trained.links()) {
            for (ConstraintPolygon polygon : link.polygons()) {
                feature(features.addObject(), polygon).put("role", "constraint").put("measured_cluster", link.measuredCluster())
                        .put("absent", link.absent().toString()).put("kind", link.kind());
            }
        }
        return root.toPrettyString() + "\n";
    }

    private static void strings(ArrayNode into, List<Channel> channels) {
        channels.forEach(channel -> into.add(channel.toString()));
    }

    private static void numbers(ArrayNode into, double[] values) {
        for (double value : values) {
            into.add(value);
        }
    }

    private static void pole(ObjectNode into, Pole pole) {
        into.put("re_rad_per_s", pole.re()).put("im_rad_per_s", pole.im());
    }

    private static ObjectNode feature(ObjectNode feature, ConstraintPolygon polygon) {
        feature.put("type", "Feature");
        ArrayNode ring = feature.putObject("geometry").put("type", "Polygon").putArray("coordinates").addArray();
        for (int i = 0; i < polygon.x().length; i++) {
            numbers(ring.addArray(), new double[] {polygon.x()[i], polygon.y()[i]});
        }
        return feature.putObject("properties").put("x", word(polygon.measured())).put("y", word(polygon.absent()))
                .put("alpha_spreads", polygon.alpha()).put("points", polygon.points());
    }

    private static String word(Attribute attribute) {
        return attribute.name().toLowerCase(Locale.ROOT);
    }

    /**
     * Reads a file.
     *
     * @throws DataFault if it is missing, is no JSON, or says something else than {@link #text} writes
     */
    public static TrainedPoles read(Path path) throws IOException {
        JsonNode root;
        try {
            root = MAPPER.readTree(InputFile.text(path, "'wbv poles' makes polygons"));
        } catch (JsonProcessingException wrong) {
            throw InputFile.notJson(path.toString(), wrong);
        }
        if (root.path("wbv").path("version").asInt() != VERSION) {
            throw DataFault.in(path.toString(), "holds no trained polygons of version " + VERSION
                    + " ('wbv.version'); 'wbv poles' makes them");
        }
        try {
            return new Reading(path.toString()).trained(root);
        } catch (IllegalArgumentException wrong) {
            throw DataFault.in(path.toString(), wrong.getMessage(), wrong);
        }
    }

    /** One reading; every fault names the file and the field. */
    private record Reading(String file) {

        TrainedPoles trained(JsonNode root) {
            JsonNode head = root.get("wbv");
            Layout layout = new Layout(channels(head, "inputs"), Channel.parse(text(head, "measured")), channels(head, "absent"));
            JsonNode windows = field(head, "windows");
            JsonNode plane = field(head, "plane");
            Map<Channel, TunedResponse> responses = new HashMap<>();
            Map<Channel, SkyhookBody> bodies = new HashMap<>();
            for (Channel absent : layout.absent()) {
                JsonNode response = field(field(head, "responses"), absent.toString());
                List<double[]> b = new ArrayList<>();
                field(response, "b_ascending").forEach(each -> b.add(numbers(each)));
                ScaledResponse scaled = new ScaledResponse(numbers(field(response, "a_ascending")), b.toArray(double[][]::new),
                        rates(layout));
                responses.put(absent, sound(absent, new TunedResponse(scaled, number(response, "reference_rad_per_s"),
                        number(response, "exponent"))));
                JsonNode body = field(field(head, "mean_bodies"), absent.toString());
                bodies.put(absent, new SkyhookBody(number(body, "frequency_Hz"), number(body, "damping"), number(body, "base_share")));
                if (!Spec.isStart(bodies.get(absent).frequency(), bodies.get(absent).damping())) {
                    throw DataFault.in(file,
                            String.format(Locale.ROOT, "the mean body of %s, %.4g Hz and damping ratio %.4g, is no sitter's; "
                                    + "train them anew by 'wbv poles'", absent, bodies.get(absent).frequency(),
                                    bodies.get(absent).damping()));
                }
            }
            List<String> trials = new ArrayList<>();
            field(head, "trials").forEach(trial -> trials.add(trial.asText()));
            List<ConstraintPolygon> outlines = new ArrayList<>();
            Map<List<Object>, List<ConstraintPolygon>> links = new LinkedHashMap<>();
            for (JsonNode feature : field(root, "features")) {
                JsonNode properties = field(feature, "properties");
                ConstraintPolygon polygon = polygon(feature, properties);
                if (text(properties, "role").equals("outline")) {
                    outlines.add(polygon);
                } else {
                    links.computeIfAbsent(List.of(Channel.parse(text(properties, "absent")), text(properties, "kind"),
                            field(properties, "measured_cluster").asInt()), key -> new ArrayList<>()).add(polygon);
                }
            }
            if (outlines.size() != 1) {
                throw DataFault.in(file, "'features' needs one polygon of the role outline: " + outlines.size());
            }
            Pole typical = pole(field(head, "typical"));
            if (!PoleWindows.plausible(typical)) {
                throw DataFault.in(file, String.format(Locale.ROOT, "'typical' is no sitter's pole: %.4g Hz, damping ratio %.4g",
                        typical.frequency(), typical.damping()));
            }
            return new TrainedPoles(layout, new PoleWindows(number(windows, "length_s"), number(windows, "hop_s"),
                    (int) number(windows, "poles")),
                    new PolePlane(number(plane, "centre_re_rad_per_s"), number(plane, "spread_re_rad_per_s"),
                            number(plane, "centre_im_rad_per_s"), number(plane, "spread_im_rad_per_s")),
                    number(plane,
                            "epsilon_spreads"),
                    outlines.get(0), typical, links.entrySet().stream()
                            .map(entry -> new PoleLink((Channel) entry.getKey().get(0),
                                    (String) entry.getKey().get(1), (Integer) entry.getKey().get(2), entry.getValue()))
                            .toList(),
                    responses, bodies, trials);
        }

        /** A response that stays within bounds whatever pole is measured: one of a body. */
        private TunedResponse sound(Channel absent, TunedResponse response) {
            for (double frequency : new double[] {PoleWindows.LEAST_FREQUENCY, PoleWindows.MOST_FREQUENCY}) {
                if (!sound(response.at(2 * Math.PI * frequency), response.pulsation(2 * Math.PI * frequency))) {
                    throw DataFault.in(file,
                            "what the polygons say of " + absent + " is no body's response; train them anew by 'wbv poles'");
                }
            }
            return response;
        }

        private static boolean sound(TransferModel model, double pulsation) {
            boolean finite = Arrays.stream(model.a()).allMatch(a -> Math.abs(a) < MOST_COEFFICIENT)
                    && Arrays.stream(model.b()).flatMapToDouble(Arrays::stream).allMatch(b -> Math.abs(b) < MOST_COEFFICIENT);
            if (!finite) {
                return false;
            }
            PoleSet poles = model.poles();
            boolean sound = poles.growing().isEmpty() && poles.modes().stream().allMatch(pole -> pole.frequency() < MOST_FREQUENCY)
                    && poles.decays().stream().allMatch(decay -> -decay < 2 * Math.PI * MOST_FREQUENCY);
            for (int i = 0; i < model.b().length; i++) {
                sound &= model.modulus(i, pulsation / (2 * Math.PI)) < MOST_GAIN;
            }
            return sound;
        }

        private static boolean[] rates(Layout layout) {
            boolean[] rates = new boolean[layout.inputs().size()];
            for (int i = 0; i < rates.length; i++) {
                rates[i] = layout.inputs().get(i).quantity() == Quantity.ANGULAR_RATE;
            }
            return rates;
        }

        private ConstraintPolygon polygon(JsonNode feature, JsonNode properties) {
            JsonNode ring = field(field(feature, "geometry"), "coordinates").path(0);
            double[] x = new double[ring.size()];
            double[] y = new double[ring.size()];
            for (int i = 0; i < x.length; i++) {
                x[i] = ring.get(i).path(0).asDouble(Double.NaN);
                y[i] = ring.get(i).path(1).asDouble(Double.NaN);
            }
            return new ConstraintPolygon(attribute(text(properties, "x")), attribute(text(properties, "y")), number(properties,
                    "alpha_spreads"),
                    (int) number(properties, "points"), x, y);
        }

        private Attribute attribute(String word) {
            List<Attribute> known = Stream.concat(Attributes.OF_A_POLE.stream(), Attributes.OF_A_BODY.stream()).distinct().toList();
            return known.stream().filter(attribute -> word(attribute).equals(word)).findFirst()
                    .orElseThrow(() -> DataFault.in(file, "'" + word + "' is no attribute of a pole or a body; there are " + known.stream()
                            .map(PolygonFile::word).toList()));
        }

        private List<Channel> channels(JsonNode node, String name) {
            List<Channel> channels = new ArrayList<>();
            field(node, name).forEach(each -> channels.add(Channel.parse(each.asText())));
            return channels;
        }

        private Pole pole(JsonNode node) {
            return new Pole(number(node, "re_rad_per_s"), number(node, "im_rad_per_s"));
        }

        private JsonNode field(JsonNode node, String name) {
            if (!node.has(name)) {
                throw DataFault.in(file, "'" + name + "' is missing; 'wbv poles' writes it");
            }
            return node.get(name);
        }

        private String text(JsonNode node, String name) {
            return field(node, name).asText();
        }

        private double number(JsonNode node, String name) {
            return finite(name, field(node, name));
        }

        private double[] numbers(JsonNode node) {
            double[] values = new double[node.size()];
            for (int i = 0; i < values.length; i++) {
                values[i] = finite("[" + i + "]", node.path(i));
            }
            return values;
        }

        private double finite(String name, JsonNode value) {
            if (!value.isNumber() || !Double.isFinite(value.asDouble())) {
                throw DataFault.in(file, "'" + name + "' must be a finite number, not '" + value + "'");
            }
            return value.asDouble();
        }
    }
}
