package wbv.recording.signals;

import java.io.IOException;
import java.io.OutputStream;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import wbv.recording.Channel;
import wbv.recording.DataFault;

/** Rows gathered to be written signal by signal: times [s] and channels in SI, NaN where missing; 8 bytes a number. */
public final class SampledColumns {

    /** Times are uniform where none is further than this share of a step from its place; half a sample's rounding to µs at 1 kHz. */
    private static final double EVEN = 1e-3;
    /** A stated rate and the times' own are the same within this. */
    private static final double SAME_RATE = 1e-8;

    private final SignalKind kind;
    private final String file;
    private final List<Channel> channels;
    private final OptionalDouble stated;
    private final double[][] values;
    private int length;

    /**
     * Room for rows: nothing is gathered yet.
     *
     * @param file for messages
     * @param stated the rate that is known [Hz], which the times can only give to their rounding
     */
    public SampledColumns(SignalKind kind, String file, List<Channel> channels, OptionalDouble stated) {
        this.kind = kind;
        this.file = file;
        this.channels = List.copyOf(channels);
        this.stated = stated;
        this.values = new double[1 + channels.size()][1024];
    }

    /**
     * Adds a row.
     *
     * @param row time [s], then the channels in SI units, one more than channels long. Not modified.
     */
    public void add(double[] row) {
        if (length == values[0].length) {
            for (int i = 0; i < values.length; i++) {
                values[i] = Arrays.copyOf(values[i], length + (length >> 1));
            }
        }
        for (int i = 0; i < values.length; i++) {
            values[i][length] = row[i];
        }
        length++;
    }

    /**
     * Writes all of it.
     *
     * @throws DataFault if the kind of file cannot hold it
     */
    public void write(OutputStream out) throws IOException {
        if (length == 0) {
            throw DataFault.in(file, "would have no samples");
        }
        kind.write(this, out);
    }

    String file() {
        return file;
    }

    List<Channel> channels() {
        return channels;
    }

    /** The rate that is known without the times [Hz]. */
    OptionalDouble stated() {
        return stated;
    }

    int length() {
        return length;
    }

    double time(int sample) {
        return values[0][sample];
    }

    double value(int channel, int sample) {
        return values[1 + channel][sample];
    }

    /**
     * Samples per second [Hz].
     *
     * @throws DataFault if the times are not even
     */
    double rate() {
        if (length < 2) {
            return stated.orElseThrow(() -> DataFault.in(file, "one sample has no rate; write it as .csv"));
        }
        double step = (time(length - 1) - time(0)) / (length - 1);
        for (int i = 0; i < length; i++) {
            if (!(step > 0) || Math.abs(time(i) - time(0) - i * step) > EVEN * step) {
                throw DataFault.in(file, "has a rate and no times, and these times are not even (row " + (i + 1)
                        + "); leave out --as-is, or write .mat, .h5, .parquet or .csv");
            }
        }
        double rate = 1 / step;
        double whole = Math.rint(rate);
        double known = stated.orElse(whole);
        return Math.abs(known - rate) <= SAME_RATE * rate ? known : Math.abs(whole - rate) <= SAME_RATE * rate ? whole : rate;
    }
}
