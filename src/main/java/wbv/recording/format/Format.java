package wbv.recording.format;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import wbv.recording.RowReader;
import wbv.recording.signals.SignalKind;

/** A file format: recognises its files by their first lines, whatever they are called, and opens them. */
sealed interface Format permits ArffFormat, CsvFormat, DotFormat, MappedFormat, MtManagerFormat, MvnxFormat, SignalFormat {

    /** True where the first lines are of this format. */
    boolean recognises(Head head);

    /**
     * Opens a file of this format. The reader closes the source.
     *
     * @throws wbv.recording.DataFault if the head of the file is wrong
     */
    RowReader open(Source source, Context context) throws IOException;

    /** Whether a file of this format, or a map of it, says what its numbers are in. */
    default boolean statesUnits() {
        return true;
    }

    /** The format of a file. CSV comes last: it takes everything, and says what is wrong with it. */
    static Format of(Head head, ReadOptions options) {
        Optional<SignalKind> signals = SignalKind.of(head.bytes());
        if (signals.isPresent()) {
            return new SignalFormat(signals.get());
        }
        head.requireText();
        if (options.map().isPresent()) {
            return new MappedFormat(options.map().get());
        }
        for (Format format : List.of(new MvnxFormat(), new ArffFormat(), new DotFormat(), new MtManagerFormat())) {
            if (format.recognises(head)) {
                return format;
            }
        }
        return new CsvFormat();
    }
}
