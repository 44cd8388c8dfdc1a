package wbv.fmi;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.Enumeration;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipFile;
import wbv.recording.DataFault;

/** A unit unpacked to a temporary folder, which goes when it is closed, or with the program where it is stopped. */
final class UnpackedFmu implements Closeable {

    /** Bytes of the largest unit [B]: those with a geometry and its meshes are a few hundred megabytes. */
    private static final long LARGEST = 2L << 30;
    /** Of the folder's name; the number of the process follows. */
    static final String PREFIX = "wbv-fmu-";
    private static final int COPIED = 1 << 16;

    private final Path folder;
    private final Thread atExit;

    private UnpackedFmu(Path folder) {
        this.folder = folder;
        this.atExit = new Thread(() -> remove(folder));
        Runtime.getRuntime().addShutdownHook(atExit);
    }

    /**
     * @throws DataFault if the file is no unit
     * @throws IOException if it cannot be read
     */
    static UnpackedFmu of(Path file) throws IOException {
        if (Files.isDirectory(file)) {
            throw DataFault.in(file.toString(), "is a folder; name the file that ends in .fmu");
        }
        UnpackedFmu unpacked = new UnpackedFmu(Files.createTempDirectory(PREFIX + ProcessHandle.current().pid() + "-"));
        try (ZipFile zip = new ZipFile(file.toFile())) {
            unpacked.fill(zip, file.toString());
            return unpacked;
        } catch (ZipException broken) {
            unpacked.close();
            throw DataFault.in(file.toString(), "is no functional mock-up unit: not a whole zip archive", broken);
        } catch (IOException | DataFault failed) {
            unpacked.close();
            throw failed;
        }
    }

    private void fill(ZipFile zip, String name) throws IOException {
        if (zip.getEntry("modelDescription.xml") == null) {
            throw DataFault.in(name, "is no functional mock-up unit: it has no modelDescription.xml");
        }
        long room = LARGEST;
        byte[] buffer = new byte[COPIED];
        for (Enumeration<? extends ZipEntry> entries = zip.entries(); entries.hasMoreElements();) {
            ZipEntry entry = entries.nextElement();
            // Tools on Windows write their own separator.
            Path target = folder.resolve(entry.getName().replace('\\', '/')).normalize();
            if (!target.startsWith(folder)) {
                throw DataFault.in(name, "holds a file that would lie outside of it: " + entry.getName());
            }
            if (entry.isDirectory() || entry.getName().endsWith("\\")) {
                Files.createDirectories(target);
                continue;
            }
            Files.createDirectories(target.getParent());
            try (InputStream in = zip.getInputStream(entry); OutputStream out = Files.newOutputStream(target)) {
                for (int count = in.read(buffer); count >= 0; count = in.read(buffer)) {
                    room -= count;
                    if (room < 0) {
                        throw DataFault.in(name, "unpacks to more than " + (LARGEST >> 30) + " GiB, which no simulator needs");
                    }
                    out.write(buffer, 0, count);
                }
            }
        }
    }

    Path description() {
        return folder.resolve("modelDescription.xml");
    }

    /** Where it finds what it brought along. It is there, if empty. */
    Path resources() throws IOException {
        return Files.createDirectories(folder.resolve("resources"));
    }

    /**
     * The first of several binaries that is there.
     *
     * @throws DataFault naming the platforms that it was built for, if none is
     */
    Path binary(List<String> candidates, String name) throws IOException {
        for (String candidate : candidates) {
            Path file = folder.resolve("binaries").resolve(candidate);
            if (Files.isRegularFile(file)) {
                return file;
            }
        }
        List<String> built = List.of();
        if (Files.isDirectory(folder.resolve("binaries"))) {
            try (Stream<Path> platforms = Files.list(folder.resolve("binaries"))) {
                built = platforms.filter(Files::isDirectory).map(each -> each.getFileName().toString()).sorted().toList();
            }
        }
        throw DataFault.in(name, "has no binary for this computer, binaries/" + candidates.get(0) + "; it was built for "
                + (built.isEmpty() ? "none: export it with its binary, not its source alone" : String.join(", ", built)));
    }

    @Override
    public void close() {
        remove(folder);
        try {
            Runtime.getRuntime().removeShutdownHook(atExit);
        } catch (IllegalStateException ending) {
            // The program ends, and the hook runs or has run.
        }
    }

    private static void remove(Path folder) {
        try (Stream<Path> all = Files.walk(folder)) {
            all.sorted(Comparator.reverseOrder()).forEach(each -> each.toFile().delete());
        } catch (IOException gone) {
            // Nothing to remove.
        }
    }
}
