package wbv.recording.signals;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;

/** The kinds of files of signals: recognised by their first bytes, written by the end of their name. */
public enum SignalKind {
    /** Universal file, datasets 58 and 58b: functions at nodes, here those of time. Written binary. */
    UFF(".uff") {
        @Override
        boolean recognises(String head) {
            return UNIVERSAL.matcher(head).lookingAt();
        }

        @Override
        public SignalFile open(String name, Path path, InputStream content) throws IOException {
            return UffFile.read(name, content);
        }

        @Override
        void write(SampledColumns columns, OutputStream out) throws IOException {
            UffWriter.write(columns, true, out);
        }
    },
    /** The same, written as text. */
    UNV(".unv") {
        @Override
        boolean recognises(String head) {
            return false; // read as UFF
        }

        @Override
        public SignalFile open(String name, Path path, InputStream content) throws IOException {
            return UFF.open(name, path, content);
        }

        @Override
        void write(SampledColumns columns, OutputStream out) throws IOException {
            UffWriter.write(columns, false, out);
        }
    },
    /** MATLAB's files from version 5 on; version 7.3 is HDF5. Written as version 6. */
    MAT(".mat") {
        @Override
        boolean recognises(String head) {
            return head.length() > 128 && Arrays.asList("IM", "MI").contains(head.substring(126, 128)) && !HDF5.recognises(head);
        }

        @Override
        public SignalFile open(String name, Path path, InputStream content) throws IOException {
            return MatFile.read(name, content);
        }

        @Override
        void write(SampledColumns columns, OutputStream out) throws IOException {
            MatFile.write(columns, out);
        }
    },
    /** HDF5 and MATLAB's version 7.3. Written as plain HDF5. */
    HDF5(".h5") {
        @Override
        boolean recognises(String head) {
            return head.startsWith(SIGNATURE) || head.startsWith("MATLAB 7.3") || head.startsWith(SIGNATURE, 512);
        }

        @Override
        public SignalFile open(String name, Path path, InputStream content) {
            return HdfSignals.read(name, path);
        }

        @Override
        void write(SampledColumns columns, OutputStream out) throws IOException {
            HdfSignals.write(columns, out);
        }
    },
    /** Apache Parquet: a table whose columns stand by themselves, read a group of rows at a time. */
    PARQUET(".parquet") {
        @Override
        boolean recognises(String head) {
            return head.startsWith("PAR1") || head.startsWith("PARE"); // the latter encrypted
        }

        @Override
        public SignalFile open(String name, Path path, InputStream content) {
            return ParquetSignals.open(name, path);
        }

        @Override
        void write(SampledColumns columns, OutputStream out) throws IOException {
            ParquetFile.write(columns, out);
        }

        @Override
        public String toString() {
            return "Parquet";
        }
    },
    /** Sound files, whole numbers of 8 to 32 bits or floating point. Written as 32-bit floating point. */
    WAV(".wav") {
        @Override
        boolean recognises(String head) {
            return (head.startsWith("RIFF") || head.startsWith("RF64")) && head.startsWith("WAVE", 8);
        }

        @Override
        public SignalFile open(String name, Path path, InputStream content) throws IOException {
            return WavFile.open(name, content);
        }

        @Override
        void write(SampledColumns columns, OutputStream out) throws IOException {
            WavWriter.write(columns, out);
        }
    };

    private static final Pattern UNIVERSAL = Pattern.compile("\\s*-1 *\\r?\\n *\\d{1,4}b?[ \\r\\n]");
    private static final String SIGNATURE = "\u0089HDF\r\n\u001a\n";

    private final String suffix;

    SignalKind(String suffix) {
        this.suffix = suffix;
    }

    /**
     * The kind of a file that begins with these bytes, if it is one of these.
     *
     * @param head Not modified.
     */
    public static Optional<SignalKind> of(byte[] head) {
        String latin = new String(head, 0, Math.min(head.length, 1024), StandardCharsets.ISO_8859_1);
        return Arrays.stream(values()).filter(kind -> kind.recognises(latin)).findFirst();
    }

    /** The kind that is written under a file's name, by its end. */
    public static Optional<SignalKind> named(Path file) {
        String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
        return Arrays.stream(values()).filter(kind -> name.endsWith(kind.suffix)).findFirst();
    }

    abstract boolean recognises(String head);

    /**
     * Opens a file.
     *
     * @param name    in messages
     * @param path    where it lies
     * @param content its bytes, decompressed. Closed by whoever opened it, after the signals were read.
     * @throws wbv.recording.DataFault if it is damaged, or holds no signals that belong together
     */
    public abstract SignalFile open(String name, Path path, InputStream content) throws IOException;

    abstract void write(SampledColumns columns, OutputStream out) throws IOException;
}
