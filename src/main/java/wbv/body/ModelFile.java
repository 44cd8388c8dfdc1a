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
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.InputFile;

/** Models as JSON ({@code model.json}): read with every mistake named by its place, written so that they read back the same. */
public final class ModelFile {

    /** NaN is read as a number, so that the value that may not be one is named. */
    private static final ObjectMapper JSON = JsonMapper.builder().enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION).enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS).build();

    /** Largest value of any key, in its SI unit: thousands of times the stiffness of a cubic metre of steel, 2e11 N/m. */
    private static final double MOST = 1e15;
    /** Least mass [kg]: a grain of dust. */
    private static final double LEAST_MASS = 1e-9;

    private ModelFile() { }

    /** @throws DataFault if the file is no model: the message names the file, the place in it and what would be right */
    public static Model read(Path file) throws IOException {
        return parse(InputFile.text(file, "a model is JSON"), file.toString());
    }

    /** @param name what messages call the text, such as a file name */
    public static Model parse(String text, String name) {
        JsonNode root;
        try {
            root = JSON.readTree(text);
        } catch (JsonProcessingException e) {
            throw InputFile.notJson(name, e);
        }
        try {
            return model(new At(root, name));
        } catch (IllegalArgumentException e) {
            throw DataFault.in(name, e.getMessage());
        }
    }

    /** The model as JSON text, indented, with every number in full. */
    public static String text(Model model) {
        return tree(model).toPrettyString() + "\n";
    }

    private static Model model(At at) {
        at.allow(Set.of("name", "source", "subject", "axis", "base", "bodies", "links", "inputs"));
        At base = at.child("base");
        base.allow(Set.of("name", "sensor", "mass_kg"));
        List<Model.Body> bodies = new ArrayList<>();
        for (At body : at.list("bodies")) {
            body.allow(Set.of("name", "mass_kg", "sensor", "faults", "hidden", "forces", "fixed"));
            List<SensorFault> faults = new ArrayList<>();
            body.optionalList("faults").forEach(fault -> faults.add(record(fault, "fault", SensorFault.class)));
            List<Drive> forces = new ArrayList<>();
            body.optionalList("forces").forEach(force -> forces.add(record(force, "force", Drive.class)));
            Optional<Model.HiddenMode> hidden = body.optional("hidden").map(h -> body.guard(() -> fill(h, Model.HiddenMode.class, Set.of())));
            boolean fixed = body.flag("fixed");
            bodies.add(body.guard(() -> new Model.Body(body.text("name"), fixed ? 1 : body.mass("mass_kg"), body.channel("sensor"), faults,
                    hidden, forces, fixed)));
        }
        List<Model.Link> links = new ArrayList<>();
        for (At link : at.list("links")) {
            link.allow(Set.of("from", "to", "stiffness_N_per_m", "damping_Ns_per_m", "sensor", "faults", "laws"));
            List<Law> laws = new ArrayList<>();
            List<Drive> drives = new ArrayList<>();
            for (At law : link.optionalList("laws")) {
                if (law.text("law").startsWith("coupling.") || law.text("law").equals("given")) {
                    drives.add(record(law, "law", Drive.class));
                } else {
                    laws.add(record(law, "law", Law.class));
                }
            }
            List<SensorFault> faults = new ArrayList<>();
            link.optionalList("faults").forEach(fault -> faults.add(record(fault, "fault", SensorFault.class)));
            links.add(link.guard(() -> new Model.Link(link.text("from"), link.text("to"), link.number("stiffness_N_per_m"),
                    link.number("damping_Ns_per_m"), link.channel("sensor"), laws, drives, faults)));
        }
        List<Model.Input> inputs = new ArrayList<>();
        for (At input : at.optionalList("inputs")) {
            input.allow(Set.of("body", "sensor", "offset_N"));
            Channel sensor = input.channel("sensor").orElseThrow(() -> input.fault("'sensor' names no channel: which one measures the force?"));
            inputs.add(input.guard(() -> new Model.Input(input.text("body"), sensor, input.numberOr("offset_N", 0))));
        }
        String axis = at.optional("axis").isPresent() ? at.text("axis") : "z";
        if (axis.length() != 1 || "xyz".indexOf(axis.charAt(0)) < 0) {
            throw new IllegalArgumentException("axis must be x, y or z: '" + axis + "'");
        }
        Optional<String> source = at.optional("source").map(s -> at.text("source"));
        Optional<Model.Subject> declared = at.has("subject") ? Optional.of((Model.Subject) word(at, "subject", Model.Subject.class)) : Optional.empty();
        Model.Base ground = base.guard(() -> new Model.Base(base.text("name"), base.channel("sensor"), base.numberOr("mass_kg",
                0)));
        return new Model(at.text("name"), source, axis.charAt(0), ground, bodies, links, inputs, declared);
    }

    /** The record of a sealed family whose keys are those given, and whose mechanism is the word given. */
    private static <T> T record(At at, String word, Class<T> family) {
        String mechanism = at.text(word);
        Set<String> given = new TreeSet<>();
        at.node.fieldNames().forEachRemaining(given::add);
        given.remove(word);
        Set<String> known = new TreeSet<>();
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
            known.add(keys.toString());
        }
        throw at.fault("no " + word + " '" + mechanism + "' with the values " + given + "; values that belong together are " + known);
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

    private static <T extends Record> T fill(At at, Class<T> type, Set<String> beside) {
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
    private static Object word(At at, String key, Class<?> type) {
        return Arrays.stream(type.getEnumConstants()).filter(each -> each.toString().equalsIgnoreCase(at.text(key))).findFirst()
                .orElseThrow(() -> at.fault("'" + key + "' must be one of " + Arrays.toString(type.getEnumConstants()).toLowerCase(Locale.ROOT) + ": '"
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
        ArrayNode bodies = root.putArray("bodies");
        for (Model.Body body : model.bodies()) {
            ObjectNode node = bodies.addObject();
            node.put("name", body.name());
            if (body.fixed()) {
                node.put("fixed", true);
            } else {
                node.put("mass_kg", body.mass());
            }
            node.put("sensor", body.sensor().map(Channel::toString).orElse(null));
            addAll(node, "faults", "fault", body.faults());
            body.hidden().ifPresent(hidden -> put(node.putObject("hidden"), hidden));
            addAll(node, "forces", "force", body.forces());
        }
        ArrayNode links = root.putArray("links");
        for (Model.Link link : model.links()) {
            ObjectNode node = links.addObject();
            node.put("from", link.from());
            node.put("to", link.to());
            node.put("stiffness_N_per_m", link.stiffness());
            node.put("damping_Ns_per_m", link.damping());
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
        return root;
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

    /** A place in the file, for messages: {@code links[1].laws[0]}. */
    private static final class At {
        private final JsonNode node;
        private final String place;

        At(JsonNode node, String place) {
            this.node = node;
            this.place = place;
            if (!node.isObject()) {
                throw fault("must be an object { … }");
            }
        }

        DataFault fault(String message) {
            return DataFault.in(place, message);
        }

        void allow(Set<String> known) {
            node.fieldNames().forEachRemaining(name -> {
                if (!known.contains(name)) {
                    throw fault("'" + name + "' is not known here; known are " + new TreeSet<>(known));
                }
            });
        }

        <T> T guard(java.util.function.Supplier<T> make) {
            try {
                return make.get();
            } catch (IllegalArgumentException e) {
                throw fault(e.getMessage());
            }
        }

        At child(String key) {
            if (!node.has(key)) {
                throw fault("'" + key + "' is missing");
            }
            return new At(node.get(key), place + ": " + key);
        }

        Optional<At> optional(String key) {
            return node.hasNonNull(key) ? Optional.of(node.get(key).isObject() ? new At(node.get(key), place + ": " + key) : this) : Optional.empty();
        }

        boolean has(String key) {
            return node.hasNonNull(key);
        }

        List<At> list(String key) {
            if (!node.path(key).isArray()) {
                throw fault("'" + key + "' must be a list [ … ]");
            }
            List<At> out = new ArrayList<>();
            for (int i = 0; i < node.get(key).size(); i++) {
                out.add(new At(node.get(key).get(i), place + ": " + key + "[" + i + "]"));
            }
            return out;
        }

        List<At> optionalList(String key) {
            return node.hasNonNull(key) ? list(key) : List.of();
        }

        String text(String key) {
            if (!node.path(key).isTextual() || node.get(key).asText().isBlank()) {
                throw fault("'" + key + "' must be a text");
            }
            return node.get(key).asText();
        }

        double number(String key) {
            if (!node.path(key).isNumber()) {
                throw fault("'" + key + "' must be a number");
            }
            double value = node.get(key).asDouble();
            if (Double.isFinite(value) && Math.abs(value) > MOST) {
                throw fault("'" + key + "' is " + value + ", which no body or link has; at most " + MOST + " is read");
            }
            return value;
        }

        /** A mass [kg] that divides others without overflow. */
        double mass(String key) {
            double mass = number(key);
            if (mass > 0 && mass < LEAST_MASS) {
                throw fault("'" + key + "' is " + mass + " kg, which no body has; at least " + LEAST_MASS + " is read");
            }
            return mass;
        }

        double numberOr(String key, double otherwise) {
            return node.has(key) ? number(key) : otherwise;
        }

        boolean flag(String key) {
            if (node.hasNonNull(key) && !node.get(key).isBoolean()) {
                throw fault("'" + key + "' must be true or false");
            }
            return node.path(key).asBoolean(false);
        }

        Optional<Channel> channel(String key) {
            return node.hasNonNull(key) ? Optional.of(guard(() -> Channel.parse(text(key)))) : Optional.empty();
        }
    }
}
