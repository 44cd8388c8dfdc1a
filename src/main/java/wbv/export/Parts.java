package wbv.export;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Text that ships with wbv for files that it writes: of its functions and classes those are taken that a file uses. */
final class Parts {

    private static final Pattern NAMED = Pattern.compile("(?m)^(?:def|class) (\\w+)");
    private static final Pattern WORD = Pattern.compile("\\w+");

    private Parts() {}

    /** A whole file. */
    static String text(String name) {
        try (InputStream in = Parts.class.getResourceAsStream("/wbv/export/" + name)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Those top-level Python blocks of a file that a text uses, directly or through others; blocks without a name always. */
    static String usedBy(String user, String file) {
        List<String> blocks = List.of(text(file).split("\n\n\n"));
        Set<String> words = words(user);
        Set<String> named = new TreeSet<>();
        boolean grown = true;
        while (grown) {
            grown = false;
            for (String block : blocks) {
                String name = name(block);
                if ((name.isEmpty() || words.contains(name)) && named.add(block)) {
                    words.addAll(words(block));
                    grown = true;
                }
            }
        }
        List<String> out = new ArrayList<>(blocks);
        out.retainAll(named);
        return String.join("\n\n\n", out);
    }

    private static String name(String block) {
        Matcher matcher = NAMED.matcher(block);
        return matcher.find() ? matcher.group(1) : "";
    }

    private static Set<String> words(String text) {
        Set<String> out = new TreeSet<>();
        WORD.matcher(text).results().forEach(each -> out.add(each.group()));
        return out;
    }
}
