package wbv.proof;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import wbv.recording.AtomicFile;
import wbv.recording.DataFault;
import wbv.recording.InputFile;

/**
 * A concealed recording that comes with wbv: a folder with {@code key.sealed}, whose hash stands in the README beside the folder.
 */
public final class SealedCase {

    /** Under which the keys that come with wbv are sealed: against reading by accident, not against reading. */
    public static final String PASSWORD = "I have diagnosed it first";

    private SealedCase() {}

    /**
     * The key of a case.
     *
     * @throws DataFault if there is no key, or it is not the one whose hash was published
     */
    public static String open(Path folder) throws IOException {
        Path sealed = folder.resolve("key.sealed");
        if (!Files.isRegularFile(sealed)) {
            throw DataFault.in(folder.toString(), "holds no key.sealed; name the folder of a case, as data/arff/concealed/003");
        }
        String key;
        try {
            key = new Vault(PASSWORD).open(InputFile.text(sealed, "a key is what 'wbv prove' sealed"));
        } catch (IllegalArgumentException e) {
            throw DataFault.in(sealed.toString(), e.getMessage());
        }
        Path published = folder.toAbsolutePath().normalize().resolveSibling("README.md");
        String hash = Vault.sha256(key);
        if (!Files.isRegularFile(published) || !InputFile.text(published, "it says the hashes of the keys").contains(hash)) {
            throw DataFault.in(sealed.toString(), "is not the key that was published: " + published
                    + " does not have its SHA-256 " + hash);
        }
        return key;
    }

    /** Seals a key into a folder and returns its SHA-256, to be published. */
    static String seal(Path folder, String key) throws IOException {
        AtomicFile.write(folder.resolve("key.sealed"), new Vault(PASSWORD).seal(key));
        return Vault.sha256(key);
    }
}
