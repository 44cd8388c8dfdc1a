package wbv.recording;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;

/**
 * Metadata as comment lines {@code key: value} at the head of a file, and back. A line without a key belongs to the source.
 * What is not known by name is a note.
 */
public final class Provenance {

    private static final String SERIAL = "serial of ";

    private Provenance() {}

    /** The lines, without a comment mark. None holds a line break. */
    public static List<String> lines(Metadata metadata) {
        Map<String, String> all = new LinkedHashMap<>();
        metadata.source().ifPresent(source -> all.put("source", source));
        metadata.rate().ifPresent(rate -> all.put("rate", number(rate) + " Hz"));
        metadata.task().ifPresent(task -> all.put("task", task));
        metadata.dailyMinutes().ifPresent(minutes -> all.put("daily exposure", number(minutes) + " min"));
        metadata.subject().ifPresent(subject -> {
            subject.mass().ifPresent(mass -> all.put("subject mass", number(mass) + " kg"));
            subject.height().ifPresent(height -> all.put("subject height", number(height) + " m"));
            subject.age().ifPresent(age -> all.put("subject age", number(age) + " years"));
            subject.sex().ifPresent(sex -> all.put("subject sex", sex));
        });
        metadata.serials().forEach((location, serial) -> all.put(SERIAL + location, serial));
        metadata.notes().forEach(all::putIfAbsent);
        List<String> lines = new ArrayList<>();
        all.forEach((key, value) -> lines.add((key + ": " + value).lines().map(String::strip).collect(Collectors.joining(" "))));
        return lines;
    }

    /** What the lines say. A value that should be a number and is none is kept as a note. */
    public static Metadata parse(List<String> lines) {
        Map<String, String> notes = new LinkedHashMap<>();
        List<String> source = new ArrayList<>();
        for (String line : lines) {
            int colon = line.indexOf(": ");
            if (colon > 0) {
                notes.merge(line.substring(0, colon).strip(), line.substring(colon + 2).strip(), (one, two) -> one + "; " + two);
            } else if (!line.isBlank()) {
                source.add(line.strip());
            }
        }
        Optional<String> named = Optional.ofNullable(notes.remove("source"));
        named.ifPresent(source::add);
        Map<String, String> serials = new LinkedHashMap<>();
        for (String key : List.copyOf(notes.keySet())) {
            if (key.startsWith(SERIAL)) {
                serials.put(key.substring(SERIAL.length()), notes.remove(key));
            }
        }
        Metadata.Subject subject = new Metadata.Subject(number(notes, "subject mass", 0, 1000),
                number(notes, "subject height", 0, 3), number(notes, "subject age", 0, 130),
                Optional.ofNullable(notes.remove("subject sex")));
        boolean someone = !subject.equals(new Metadata.Subject(OptionalDouble.empty(), OptionalDouble.empty(),
                OptionalDouble.empty(), Optional.empty()));
        return new Metadata(number(notes, "rate", Clock.SLOWEST, Clock.FASTEST), serials, someone ? Optional.of(subject) : Optional.empty(),
                Optional.ofNullable(notes.remove("task")), number(notes, "daily exposure", 0, 1440),
                source.isEmpty() ? Optional.empty() : Optional.of(String.join("; ", source)), notes);
    }

    private static OptionalDouble number(Map<String, String> notes, String key, double least, double most) {
        String text = notes.get(key);
        if (text == null) {
            return OptionalDouble.empty();
        }
        try {
            double value = Double.parseDouble(text.strip().split("\\s")[0].toLowerCase(Locale.ROOT).replaceAll("hz$", ""));
            if (value > 0 && value >= least && value <= most) {
                notes.remove(key);
                return OptionalDouble.of(value);
            }
        } catch (NumberFormatException notNumber) {
            // Stays a note: a comment is not data.
        }
        return OptionalDouble.empty();
    }

    private static String number(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e15 ? Long.toString((long) value) : Double.toString(value);
    }
}
