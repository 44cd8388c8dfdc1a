package wbv.body;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import wbv.recording.DataFault;

/**
 * Models of the seated body from the literature, in {@link ModelFile}'s format. Each says in its {@link Model#source} who
 * published it and how sure its values are; which sensor measures which of its masses is our reading.
 */
public final class PublishedModels {

    private static final List<String> NAMES = List.of("allen-1978-2dof", "boileau-rakheja-1998-4dof", "coermann-1962-1dof",
            "fairley-griffin-1989-1dof", "iso-5982-2001-3dof", "wan-schimmels-1995-4dof", "wei-griffin-1998-1dof",
            "wei-griffin-1998-2dof");

    private PublishedModels() {}

    /** The names, in alphabetical order. */
    public static List<String> names() {
        return NAMES;
    }

    /** Whether a word names a published model: where there is a file of that name, the file is meant. */
    public static boolean named(String word) {
        return NAMES.contains(word) && !Files.exists(Path.of(word));
    }

    /**
     * The published model of this name.
     *
     * @throws DataFault if there is none
     */
    public static Model open(String name) throws IOException {
        if (!NAMES.contains(name)) {
            throw DataFault.in(name, "there is no such file, and no model is published under this name; published are "
                    + String.join(", ", NAMES));
        }
        try (InputStream in = PublishedModels.class.getResourceAsStream("models/" + name + ".json")) {
            return ModelFile.parse(new String(in.readAllBytes(), StandardCharsets.UTF_8), name);
        }
    }

    /**
     * The model in a file or, where there is no such file, the published one.
     *
     * @throws DataFault if it is neither, or no model
     */
    public static Model find(String fileOrName) throws IOException {
        return Files.exists(Path.of(fileOrName)) ? ModelFile.read(Path.of(fileOrName)) : open(fileOrName);
    }
}
