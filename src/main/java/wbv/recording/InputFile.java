package wbv.recording;

import com.fasterxml.jackson.core.JsonProcessingException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/** A file that is read whole: a model, a map, a key. Recordings are streams and are not read so. */
public final class InputFile {

    private InputFile() {}

    /**
     * Its bytes.
     *
     * @param what it should hold, for messages: {@code a model is what 'wbv net train' writes}
     * @throws DataFault if there is no such file, it is a folder, may not be read, or is too large
     */
    public static byte[] bytes(Path path, String what) throws IOException {
        String name = path.toString();
        if (Files.isDirectory(path)) {
            throw DataFault.in(name.isEmpty() ? "''" : name, "is a folder; name a file: " + what);
        }
        try {
            if (Files.size(path) > Runtime.getRuntime().maxMemory() / 8) {
                throw DataFault.in(name, "is too large, " + Files.size(path) / 1_000_000 + " MB; " + what);
            }
            return Files.readAllBytes(path);
        } catch (NoSuchFileException missing) {
            throw DataFault.in(name, "there is no such file; " + what, missing);
        } catch (AccessDeniedException denied) {
            throw DataFault.in(name, "may not be read; check its permissions", denied);
        }
    }

    /** What is wrong with a text that is no JSON, at its line. */
    public static DataFault notJson(String name, JsonProcessingException wrong) {
        long line = wrong.getLocation() == null ? 1 : Math.max(1, wrong.getLocation().getLineNr());
        String why = wrong.getOriginalMessage().lines().findFirst().orElse("");
        int inner = why.indexOf(" (start marker at");
        return DataFault.at(name, line, "is not JSON: " + (inner < 0 ? why : why.substring(0, inner)), wrong);
    }

    /**
     * Its text, without a byte order mark.
     *
     * @throws DataFault as {@link #bytes}, and where it is not text in UTF-8
     */
    public static String text(Path path, String what) throws IOException {
        try {
            String text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes(path, what))).toString();
            return text.startsWith("\ufeff") ? text.substring(1) : text;
        } catch (CharacterCodingException wrong) {
            throw DataFault.in(path.toString(), "is not text in UTF-8; " + what, wrong);
        }
    }
}
