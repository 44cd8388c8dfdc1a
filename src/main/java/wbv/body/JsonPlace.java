package wbv.body;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import wbv.recording.Channel;
import wbv.recording.DataFault;

/** An object in a JSON file with its place there, for messages: {@code links[1].laws[0]}. */
final class JsonPlace {

    /**
     * Largest value of any key, in its SI unit: thousands of times the stiffness of a cubic metre of steel, 2e11 N/m. Over
     * the least mass that is 1e24 rad²/s², of which products of a dozen are still within what a double holds.
     */
    private static final double MOST = 1e15;
    /**
     * Terms of a higher power of a length, an angle or their speeds, such as N/m⁵, are about thousandths: each power above the first may be
     * so much more.
     */
    private static final double PER_POWER = 1e3;
    private static final Pattern POWER = Pattern.compile("_per_(?:m|rad)([2-9])");
    /** Least mass [kg]: a grain of dust. */
    private static final double LEAST_MASS = 1e-9;

    /** Not a copy. */
    final JsonNode node;
    private final String place;

    JsonPlace(JsonNode node, String place) {
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

    <T> T guard(Supplier<T> make) {
        try {
            return make.get();
        } catch (IllegalArgumentException e) {
            throw fault(e.getMessage());
        }
    }

    JsonPlace child(String key) {
        if (!node.has(key)) {
            throw fault("'" + key + "' is missing");
        }
        return new JsonPlace(node.get(key), place + ": " + key);
    }

    Optional<JsonPlace> optional(String key) {
        return node.hasNonNull(key) ? Optional.of(node.get(key).isObject() ? new JsonPlace(node.get(key), place + ": " + key) : this)
                : Optional.empty();
    }

    boolean has(String key) {
        return node.hasNonNull(key);
    }

    List<JsonPlace> list(String key) {
        if (!node.path(key).isArray()) {
            throw fault("'" + key + "' must be a list [ … ]");
        }
        List<JsonPlace> out = new ArrayList<>();
        for (int i = 0; i < node.get(key).size(); i++) {
            out.add(new JsonPlace(node.get(key).get(i), place + ": " + key + "[" + i + "]"));
        }
        return out;
    }

    List<JsonPlace> optionalList(String key) {
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
        if (Double.isFinite(value)) {
            requireAtMost(most(key), key, value);
        }
        return value;
    }

    private static double most(String key) {
        Matcher power = POWER.matcher(key);
        return power.find() ? MOST * Math.pow(PER_POWER, Integer.parseInt(power.group(1)) - 1) : MOST;
    }

    private void requireAtMost(double most, String key, double value) {
        if (Math.abs(value) > most) {
            throw fault("'" + key + "' is " + value + ", which no body or link has; at most " + most + " is read");
        }
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

    /** Numbers by name, in their order; none where the key is missing. */
    Map<String, Double> factors(String key) {
        Map<String, Double> out = new LinkedHashMap<>();
        if (node.hasNonNull(key)) {
            JsonPlace child = child(key);
            child.node.fieldNames().forEachRemaining(name -> out.put(name, child.number(name)));
        }
        return out;
    }

    /** A list of numbers. */
    double[] numbers(String key) {
        return row(node.path(key), key);
    }

    /** A point in a plane; empty where the key is missing. */
    Optional<Model.Point> point(String key) {
        if (!node.hasNonNull(key)) {
            return Optional.empty();
        }
        double[] numbers = numbers(key);
        if (numbers.length != 2) {
            throw fault("'" + key + "' must be two numbers [x, z] in m");
        }
        return Optional.of(new Model.Point(numbers[0], numbers[1]));
    }

    /** A list of lists of numbers. */
    double[][] table(String key) {
        if (!node.path(key).isArray()) {
            throw fault("'" + key + "' must be a list of lists of numbers [ [ … ], … ]");
        }
        double[][] out = new double[node.get(key).size()][];
        for (int i = 0; i < out.length; i++) {
            out[i] = row(node.get(key).get(i), key);
        }
        return out;
    }

    private double[] row(JsonNode list, String key) {
        double[] out = new double[list.size()];
        for (int i = 0; i < out.length; i++) {
            out[i] = list.path(i).isNumber() ? list.get(i).asDouble() : Double.NaN;
        }
        if (!list.isArray() || Arrays.stream(out).anyMatch(Double::isNaN)) {
            throw fault("'" + key + "' must hold numbers only: " + list);
        }
        Arrays.stream(out).forEach(value -> requireAtMost(MOST, key, value));
        return out;
    }

    /** A list of texts; none where the key is missing. */
    List<String> texts(String key) {
        List<String> out = new ArrayList<>();
        if (node.hasNonNull(key) && !node.get(key).isArray()) {
            throw fault("'" + key + "' must be a list of texts [ … ]");
        }
        node.path(key).forEach(each -> {
            if (!each.isTextual()) {
                throw fault("'" + key + "' must be a list of texts: " + each);
            }
            out.add(each.asText());
        });
        return out;
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
