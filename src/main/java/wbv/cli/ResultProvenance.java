package wbv.cli;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.DigestInputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/** What every result says of its own making. */
final class ResultProvenance {

    /** Options that change no result: where it goes, what is told of it, and from where a training goes on. */
    static final Set<String> WITHOUT_EFFECT = Set.of("--out", "--json", "--quiet", "--checkpoint");

    private final Map<String, String> entries = new LinkedHashMap<>();

    /** @param command that was given and makes the result */
    ResultProvenance(CommandSpec command) {
        entries.put("wbv", Version.text());
        entries.put("command", line(command));
    }

    /**
     * The line that makes the same results again, as a shell reads it: what was given, in the order in which the command declares it, and
     * the declared defaults of what was not, which may be others one day.
     */
    static String line(CommandSpec command) {
        List<String> words = new ArrayList<>(List.of(command.qualifiedName()));
        for (OptionSpec option : command.options()) {
            if (!WITHOUT_EFFECT.contains(option.longestName())) {
                words.addAll(given(option));
            }
        }
        List<String> names = new ArrayList<>();
        for (PositionalParamSpec each : command.positionalParameters()) {
            each.originalStringValues().forEach(name -> names.add(quoted(name)));
        }
        boolean likeOptions = names.stream().anyMatch(name -> name.startsWith("-") && !name.equals("-"));
        if (likeOptions) {
            words.add("--");
        }
        words.addAll(likeOptions ? words.size() : 1, names);
        return String.join(" ", words);
    }

    private static List<String> given(OptionSpec option) {
        String name = option.longestName();
        if (option.arity().max() == 0) {
            return Boolean.TRUE.equals(option.getValue()) ? List.of(name) : List.of();
        }
        List<String> values = option.originalStringValues();
        if (values.isEmpty() && option.defaultValue() != null) {
            values = List.of(option.defaultValue());
        }
        return values.stream().map(value -> name + " " + quoted(value)).toList();
    }

    /** A word as a shell takes it for one, and the program for no list of words. */
    private static String quoted(String word) {
        String whole = word.startsWith("@") ? "@" + word : word;
        return whole.matches("[\\w./,:=@%+\\-]+") ? whole : "'" + whole.replace("'", "'\\''") + "'";
    }

    ResultProvenance with(String name, String value) {
        entries.put(name, value);
        return this;
    }

    /** Adds the SHA-256 of files. */
    ResultProvenance of(List<Path> files) throws IOException {
        for (Path file : files) {
            if (Files.isRegularFile(file)) {
                String name = "SHA-256 of " + file.getFileName();
                entries.put(entries.containsKey(name) ? "SHA-256 of " + file : name, sha256(file));
            }
        }
        return this;
    }

    Map<String, String> entries() {
        entries.put("Java", Runtime.version().toString());
        return entries;
    }

    static String sha256(Path file) throws IOException {
        try (InputStream in = new DigestInputStream(Files.newInputStream(file), MessageDigest.getInstance("SHA-256"))) {
            in.transferTo(java.io.OutputStream.nullOutputStream());
            return HexFormat.of().formatHex(((DigestInputStream) in).getMessageDigest().digest());
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }
}
