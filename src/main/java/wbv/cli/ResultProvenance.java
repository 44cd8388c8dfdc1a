package wbv.cli;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.DigestInputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** What every result says of its own making. */
final class ResultProvenance {

    private final Map<String, String> entries = new LinkedHashMap<>();

    ResultProvenance(List<String> command) {
        entries.put("wbv", Version.text());
        entries.put("command", "wbv " + command.stream().map(ResultProvenance::quoted).collect(Collectors.joining(" ")));
    }

    /** A word as a shell takes it for one. */
    private static String quoted(String word) {
        return word.matches("[\\w./,:=@%+\\-]+") ? word : "'" + word.replace("'", "'\\''") + "'";
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
