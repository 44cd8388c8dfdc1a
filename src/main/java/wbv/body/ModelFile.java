package wbv.body;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.lang.reflect.RecordComponent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import wbv.body.law.Law;
import wbv.body.number.Key;
import wbv.body.number.Modulator;
import wbv.body.number.Numbers;
import wbv.body.number.Shape;
import wbv.body.number.Units;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.InputFile;

/** Models as JSON ({@code model.json}): read with every mistake named by its place, written so that they read back the same. */
public final class ModelFile {

    /** Of the sets of values that a fault of one suggests. */
    private static final int NEAREST = 3;
    private static final String STIFFENING = "cubic_per_m2";
    /** How the key of the coefficient of a term that was learned begins; its unit follows. */
    public static final String COEFFICIENT = "coefficient_[";
    /** The key of a base's filter, in every form. */
    static final String FILTER = "anti_alias";
    /** NaN is read as a number, so that the value that may not be one is named. */
    private static final ObjectMapper JSON = JsonMapper.builder().enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION).enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS).build();

    private ModelFile() {}

    /**
     * Reads a model.
     *
     * @throws DataFault if the file is no model: the message names the file, the place in it and what would be right
     */
    public static Model read(Path file) throws IOException {
        return parse(InputFile.text(file, "a model is JSON"), file.toString());
    }

    /**
     * Reads a model from its text.
     *
     * @param name what messages call the text, such as a file name
     * @throws DataFault as {@link #read} does
     */
    public static Model parse(String text, String name) {
        JsonNode root;
        try {
            root = JSON.readTree(text);
        } catch (JsonProcessingException e) {
            throw InputFile.notJson(name, e);
        }
        try {
            return model(new JsonPlace(root, name));
        } catch (IllegalArgumentException e) {
            throw DataFault.in(name, e.getMessage());
        }
    }

    /** The model as JSON text, indented, with every number in full. */
    public static String text(Model model) {
        return tree(model).toPrettyString() + "\n";
    }

    private static Model model(JsonPlace at) {
        if (PlaneForm.is(at)) {
            return PlaneForm.read(at);
        }
        return MatrixForm.is(at) ? MatrixForm.read(at) : ofMotions(at);
    }

    private static Model ofMotions(JsonPlace at) {
        at.allow(Set.of("name", "source", "subject", "axis", "base", "bodies", "links", "inputs", "sensors"));
        JsonPlace base = at.child("base");
        base.allow(Set.of("name", "sensor", "mass_kg", "further", "at_m", FILTER));
        List<Model.Body> bodies = new ArrayList<>();
        for (JsonPlace body : at.list("bodies")) {
            body.allow(Set.of("name", "mass_kg", "mass_within", "inertia_kgm2", "mass_of", "carried", "at_m", "sensor", "faults", "hidden",
                    "forces", "fixed"));
            List<SensorFault> faults = faults(body);
            List<Drive> forces = new ArrayList<>();
            body.optionalList("forces").forEach(force -> forces.add(record(force, "force", Drive.class)));
            Optional<Model.HiddenMode> hidden = body.optional("hidden")
                    .map(h -> body.guard(() -> hidden(h)));
            boolean fixed = body.flag("fixed");
            boolean turns = body.has("inertia_kgm2");
            Optional<String> massOf = body.has("mass_of") ? Optional.of(body.text("mass_of")) : Optional.empty();
            double mass = fixed ? 1
                    : massOf.isPresent() ? massOf(massOf.get(), bodies, body) : body.mass(turns ? "inertia_kgm2" : "mass_kg");
            Map<Channel, Double> carried = new LinkedHashMap<>();
            body.factors("carried").forEach((axis, part) -> carried.put(body.guard(() -> Channel.parse(axis)), part));
            bodies.add(body.guard(() -> new Model.Body(body.text("name"), mass, body.channel("sensor"), faults, hidden, forces, fixed,
                    carried, massOf, turns, body.point("at_m"), within(body))));
        }
        List<Model.Link> links = new ArrayList<>();
        for (JsonPlace link : at.list("links")) {
            link.allow(Set.of("from", "to", "stiffness_N_per_m", "damping_Ns_per_m", "stiffness_Nm_per_rad", "damping_Nms_per_rad",
                    "sensor", "faults", "laws", "arms", "at_m"));
            boolean about = bodies.stream().anyMatch(body -> body.name().equals(link.text("to")) && body.turns());
            links.add(link(link, link.text("from"), link.text("to"), link.number(stiffnessKey(about)), link.number(dampingKey(about)),
                    link.factors("arms"), link.point("at_m")));
        }
        List<Model.Sensor> sensors = new ArrayList<>();
        for (JsonPlace sensor : at.optionalList("sensors")) {
            sensor.allow(Set.of("sensor", "reads", "faults", "at_m"));
            Channel channel = sensor.channel("sensor").orElseThrow(() -> sensor.fault("'sensor' names no channel"));
            sensors.add(sensor.guard(() -> new Model.Sensor(channel, sensor.factors("reads"), faults(sensor), sensor.point("at_m"))));
        }
        List<Channel> further = base.texts("further").stream().map(name -> base.guard(() -> Channel.parse(name))).toList();
        Model.Base ground = base.guard(
                () -> new Model.Base(base.text("name"), base.channel("sensor"), base.numberOr("mass_kg", 0), further, base.point("at_m"),
                        filter(base)));
        return model(at, ground, bodies, links, sensors);
    }

    /**
     * The key of a link's stiffness.
     *
     * @param about whether it acts about an axis
     */
    public static String stiffnessKey(boolean about) {
        return about ? "stiffness_Nm_per_rad" : "stiffness_N_per_m";
    }

    /**
     * The key of any number of a law, such as {@code k3_N_per_m3}, where its link acts about an axis: {@code k3_Nm_per_rad3}; of a term
     * that was learned {@code coefficient_[N·m/(rad/s)] of v thinned}.
     */
    public static String keyAbout(String key) {
        if (key.startsWith(COEFFICIENT)) {
            int end = key.indexOf(']');
            return COEFFICIENT + Units.about(key.substring(COEFFICIENT.length(), end), key.contains(" × ")) + key.substring(end);
        }
        String turned = key.replaceAll("_N(s2?)?_per_m(?=$|_|\\d)", "_Nm$1_per_rad").replaceAll("_m_per_s$", "_rad_per_s")
                .replaceAll("_per_m2$", "_per_rad2");
        return turned.replaceAll("_N$", "_Nm").replaceAll("_m$", "_rad");
    }

    /** The key of a link's damping, likewise. */
    public static String dampingKey(boolean about) {
        return about ? "damping_Nms_per_rad" : "damping_Ns_per_m";
    }

    /** A model of these parts, with what else stands in the file of every form: name, source, subject, axis, measured forces. */
    public static Model model(JsonPlace at, Model.Base base, List<Model.Body> bodies, List<Model.Link> links, List<Model.Sensor> sensors) {
        List<Model.Input> inputs = new ArrayList<>();
        for (JsonPlace input : at.optionalList("inputs")) {
            input.allow(Set.of("body", "sensor", "offset_N"));
            Channel sensor = input.channel("sensor")
                    .orElseThrow(() -> input.fault("'sensor' names no channel: which one measures the force?"));
            inputs.add(input.guard(() -> new Model.Input(input.text("body"), sensor, input.numberOr("offset_N", 0))));
        }
        String axis = at.optional("axis").isPresent() ? at.text("axis") : "z";
        if (axis.length() != 1 || "xyz".indexOf(axis.charAt(0)) < 0) {
            throw new IllegalArgumentException("axis must be x, y or z: '" + axis + "'");
        }
        Optional<String> source = at.optional("source").map(s -> at.text("source"));
        Optional<Model.Subject> declared = at.has("subject") ? Optional.of((Model.Subject) word(at, "subject", Model.Subject.class))
                : Optional.empty();
        return new Model(at.text("name"), source, axis.charAt(0), base, bodies, links, inputs, declared, sensors);
    }

    /** A link with the laws, the sensor and its faults that stand at a place in the file. */
    static Model.Link link(JsonPlace at, String from, String to, double stiffness, double damping, Map<String, Double> arms,
            Optional<Model.Point> point) {
        List<Law> laws = new ArrayList<>();
        List<Drive> drives = new ArrayList<>();
        for (JsonPlace law : at.optionalList("laws")) {
            if (law.text("law").startsWith("coupling.") || law.text("law").equals("given")) {
                drives.add(record(law, "law", Drive.class));
            } else {
                laws.add(record(law, "law", Law.class));
            }
        }
        List<SensorFault> faults = faults(at);
        return at.guard(() -> new Model.Link(from, to, stiffness, damping, at.channel("sensor"), laws, drives, faults, arms, point));
    }

    static List<SensorFault> faults(JsonPlace at) {
        return at.optionalList("faults").stream().map(fault -> record(fault, "fault", SensorFault.class)).toList();
    }

    /** The filter that a base's sensor passed, if its user says so. */
    static Optional<SensorFilter> filter(JsonPlace base) {
        if (!base.has(FILTER)) {
            return Optional.empty();
        }
        JsonPlace at = base.child(FILTER);
        at.allow(Set.of("of_rate", "gain"));
        return Optional.of(at.guard(() -> new SensorFilter(Arrays.stream(at.numbers("of_rate")).boxed().toList(),
                Arrays.stream(at.numbers("gain")).boxed().toList())));
    }

    /** How well a mass is known, if its user says so. */
    static OptionalDouble within(JsonPlace body) {
        return body.has("mass_within") ? OptionalDouble.of(body.number("mass_within")) : OptionalDouble.empty();
    }

    private static double massOf(String other, List<Model.Body> bodies, JsonPlace body) {
        return bodies.stream().filter(each -> each.name().equals(other)).mapToDouble(Model.Body::mass).findFirst()
                .orElseThrow(() -> body.fault("'mass_of' must name a body that stands before it: '" + other + "'"));
    }

    /** The record of a sealed family whose keys are those given, and whose mechanism is the word given. */
    private static <T> T record(JsonPlace at, String word, Class<T> family) {
        String mechanism = at.text(word);
        Set<String> given = new TreeSet<>();
        at.node.fieldNames().forEachRemaining(given::add);
        given.remove(word);
        List<Set<String>> known = new ArrayList<>();
        for (Class<?> type : records(family).toList()) {
            Set<String> keys = new TreeSet<>();
            for (RecordComponent component : type.getRecordComponents()) {
                keys.add(component.getAnnotation(Key.class).value());
            }
            if (keys.equals(given)) {
                T made = at.guard(() -> family.cast(fill(at, type.asSubclass(Record.class), Set.of(word))));
                if (mechanism(made).equals(mechanism)) {
                    return made;
                }
            }
            known.add(keys);
        }
        String near = known.stream().sorted(Comparator.comparingInt((Set<String> keys) -> apart(keys, given)).thenComparing(Set::toString))
                .distinct().limit(NEAREST).map(Set::toString).collect(Collectors.joining(" or "));
        throw at.fault("no " + word + " '" + mechanism + "' with the values " + given + "; what is nearest to them is " + near);
    }

    /** How many words are in one set alone. */
    private static int apart(Set<String> one, Set<String> other) {
        return (int) (one.stream().filter(word -> !other.contains(word)).count()
                + other.stream().filter(word -> !one.contains(word)).count());
    }

    private static Model.HiddenMode hidden(JsonPlace at) {
        at.allow(Set.of("mass_kg", "frequency_hz", "damping_ratio", STIFFENING));
        return new Model.HiddenMode(at.number("mass_kg"), at.number("frequency_hz"), at.number("damping_ratio"),
                at.numberOr(STIFFENING, 0));
    }

    private static Stream<Class<?>> records(Class<?> family) {
        return Arrays.stream(family.getPermittedSubclasses()).flatMap(type -> type.isRecord() ? Stream.of(type) : records(type));
    }

    static String mechanism(Object made) {
        if (made instanceof Law law) {
            return law.mechanism();
        }
        return made instanceof Drive drive ? drive.mechanism() : ((SensorFault) made).mechanism();
    }

    private static <T extends Record> T fill(JsonPlace at, Class<T> type, Set<String> beside) {
        RecordComponent[] components = type.getRecordComponents();
        Class<?>[] types = new Class<?>[components.length];
        Object[] values = new Object[components.length];
        Set<String> keys = new TreeSet<>(beside);
        for (int i = 0; i < components.length; i++) {
            String key = components[i].getAnnotation(Key.class).value();
            keys.add(key);
            types[i] = components[i].getType();
            if (types[i] == double.class) {
                values[i] = at.number(key);
            } else if (types[i] == Channel.class) {
                values[i] = at.channel(key).orElseThrow(() -> at.fault("'" + key + "' names no channel"));
            } else if (types[i] == Shape.class) {
                values[i] = at.guard(() -> Shape.parse(at.text(key)));
            } else if (types[i] == Modulator.class) {
                values[i] = at.guard(() -> Modulator.parse(at.text(key)));
            } else {
                values[i] = word(at, key, types[i]);
            }
        }
        at.allow(keys);
        return Numbers.create(type, types, values);
    }

    /** A constant of an enumeration, by its name in any case. */
    private static Object word(JsonPlace at, String key, Class<?> type) {
        return Arrays.stream(type.getEnumConstants()).filter(each -> each.toString().equalsIgnoreCase(at.text(key))).findFirst()
                .orElseThrow(() -> at
                        .fault("'" + key + "' must be one of " + Arrays.toString(type.getEnumConstants()).toLowerCase(Locale.ROOT) + ": '"
                                + at.text(key) + "'"));
    }

    private static ObjectNode tree(Model model) {
        ObjectNode root = JSON.createObjectNode();
        root.put("name", model.name());
        model.source().ifPresent(source -> root.put("source", source));
        model.declared().ifPresent(subject -> root.put("subject", subject.word()));
        root.put("axis", String.valueOf(model.axis()));
        ObjectNode base = root.putObject("base");
        base.put("name", model.base().name());
        base.put("sensor", model.base().sensor().map(Channel::toString).orElse(null));
        if (model.base().mass() > 0) {
            base.put("mass_kg", model.base().mass());
        }
        if (!model.base().further().isEmpty()) {
            ArrayNode further = base.putArray("further");
            model.base().further().forEach(channel -> further.add(channel.toString()));
        }
        putPoint(base, model.base().at());
        model.base().filter().ifPresent(filter -> {
            ObjectNode passed = base.putObject(FILTER);
            filter.ofRate().forEach(passed.putArray("of_rate")::add);
            filter.gain().forEach(passed.putArray("gain")::add);
        });
        ArrayNode bodies = root.putArray("bodies");
        for (Model.Body body : model.bodies()) {
            ObjectNode node = bodies.addObject();
            node.put("name", body.name());
            if (body.fixed()) {
                node.put("fixed", true);
            } else if (body.massOf().isPresent()) {
                node.put("mass_of", body.massOf().get());
            } else {
                node.put(body.turns() ? "inertia_kgm2" : "mass_kg", body.mass());
                body.within().ifPresent(part -> node.put("mass_within", part));
            }
            Map<String, Double> carried = new LinkedHashMap<>();
            body.carried().forEach((axis, part) -> carried.put(axis.toString(), part));
            putFactors(node, "carried", carried);
            putPoint(node, body.at());
            node.put("sensor", body.sensor().map(Channel::toString).orElse(null));
            addAll(node, "faults", "fault", body.faults());
            body.hidden().ifPresent(hidden -> {
                ObjectNode rider = node.putObject("hidden");
                put(rider, hidden);
                if (hidden.cubic() == 0) {
                    rider.remove(STIFFENING);
                }
            });
            addAll(node, "forces", "force", body.forces());
        }
        ArrayNode links = root.putArray("links");
        for (Model.Link link : model.links()) {
            ObjectNode node = links.addObject();
            node.put("from", link.from());
            node.put("to", link.to());
            node.put(stiffnessKey(model.about(link)), link.stiffness());
            node.put(dampingKey(model.about(link)), link.damping());
            putFactors(node, "arms", link.arms());
            putPoint(node, link.at());
            link.sensor().ifPresent(sensor -> node.put("sensor", sensor.toString()));
            List<Object> laws = new ArrayList<>(link.laws());
            laws.addAll(link.drives());
            addAll(node, "faults", "fault", link.faults());
            addAll(node, "laws", "law", laws);
        }
        ArrayNode inputs = model.inputs().isEmpty() ? JSON.createArrayNode() : root.putArray("inputs");
        for (Model.Input input : model.inputs()) {
            ObjectNode node = inputs.addObject().put("body", input.body()).put("sensor", input.sensor().toString());
            if (input.offset() != 0) {
                node.put("offset_N", input.offset());
            }
        }
        ArrayNode sensors = model.sensors().isEmpty() ? JSON.createArrayNode() : root.putArray("sensors");
        for (Model.Sensor sensor : model.sensors()) {
            ObjectNode node = sensors.addObject().put("sensor", sensor.channel().toString());
            putFactors(node, "reads", sensor.reads());
            putPoint(node, sensor.at());
            addAll(node, "faults", "fault", sensor.faults());
        }
        return root;
    }

    private static void putPoint(ObjectNode node, Optional<Model.Point> point) {
        point.ifPresent(at -> node.putArray("at_m").add(at.x()).add(at.z()));
    }

    private static void putFactors(ObjectNode node, String key, Map<String, Double> factors) {
        if (!factors.isEmpty()) {
            ObjectNode each = node.putObject(key);
            factors.forEach(each::put);
        }
    }

    private static void addAll(ObjectNode node, String key, String word, List<?> records) {
        if (!records.isEmpty()) {
            ArrayNode array = node.putArray(key);
            for (Object record : records) {
                ObjectNode each = array.addObject();
                each.put(word, mechanism(record));
                put(each, (Record) record);
            }
        }
    }

    private static void put(ObjectNode node, Record record) {
        for (RecordComponent component : record.getClass().getRecordComponents()) {
            String key = component.getAnnotation(Key.class).value();
            Object value = Numbers.read(record, component);
            if (value instanceof Double number) {
                node.put(key, number);
            } else {
                node.put(key, value instanceof Enum<?> ? value.toString().toLowerCase(Locale.ROOT) : value.toString());
            }
        }
    }
}
