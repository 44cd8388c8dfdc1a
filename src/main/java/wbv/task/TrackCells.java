package wbv.task;

import java.util.Arrays;
import wbv.filter.BodyEstimate;

/**
 * What is known of a body after each of some samples, as the text that stands in the rows of {@link TrackFile track files}: formed once
 * for all of them, and for each body by itself. Used again for the samples that follow, so that nothing is allocated per sample.
 */
public final class TrackCells {

    /** Digits of a standard deviation that are kept. */
    private static final int DIGITS = 3;
    /** Decimals beyond which a number is written as it is. */
    private static final int MOST_DECIMALS = 12;
    /** Samples for which there is room at first. */
    private static final int FEW = 64;

    private final boolean exact;
    private final StringBuilder text = new StringBuilder();
    private int[] ends = new int[FEW];
    private boolean[] finite = new boolean[FEW];
    private int rows;

    /** Cells of no sample yet, with numbers as far as they go. */
    public TrackCells() {
        this(false);
    }

    /** @param exact whether every number is written as it is */
    TrackCells(boolean exact) {
        this.exact = exact;
    }

    /** Forgets all samples. */
    public void clear() {
        text.setLength(0);
        rows = 0;
    }

    /** Adds what is known after the next sample. */
    public void add(BodyEstimate track) {
        if (rows == ends.length) {
            ends = Arrays.copyOf(ends, 2 * rows);
            finite = Arrays.copyOf(finite, 2 * rows);
        }
        finite[rows] = true;
        for (int m = 0; m < track.modes(); m++) {
            known(track.frequency(m), track.frequencyDeviation(m));
            known(track.damping(m), track.dampingDeviation(m));
        }
        if (track.modes() == 2) {
            number(track.share());
        }
        number(rounded(track.prediction(), track.outputNoise()));
        number(rounded(track.outputNoise(), track.outputNoise()));
        number(rounded(track.nis(), track.nis()));
        text.append(',').append(track.heardBy().ordinal()).append(track.changed() ? ",1," : ",0,").append(track.width())
                .append(track.excited() ? ",1" : ",0");
        ends[rows++] = text.length();
    }

    /** A number and its standard deviation. */
    private void known(double value, double deviation) {
        number(rounded(value, deviation));
        number(rounded(deviation, deviation));
    }

    /** A number as far as it goes for one that is off by so much. */
    private double rounded(double value, double deviation) {
        double decimals = DIGITS - 1 - Math.floor(Math.log10(Math.abs(deviation)));
        if (exact || !(decimals <= MOST_DECIMALS) || !Double.isFinite(value)) {
            return value;
        }
        double scale = Math.pow(10, Math.max(0, decimals));
        double rounded = Math.rint(value * scale) / scale;
        return Double.isFinite(rounded) ? rounded : value;
    }

    private void number(double value) {
        text.append(',').append(value);
        finite[rows] &= Double.isFinite(value);
    }

    /**
     * Appends the cells of a sample, each behind a comma.
     *
     * @param row of the sample, from 0
     * @param missing stands for a number that is not known
     * @param infinite whether the file can hold what is infinite; else it is missing too
     */
    void appendTo(StringBuilder line, int row, String missing, boolean infinite) {
        int from = row == 0 ? 0 : ends[row - 1];
        if (finite[row]) {
            line.append(text, from, ends[row]);
            return;
        }
        for (String cell : text.substring(from + 1, ends[row]).split(",")) {
            boolean absent = cell.equals("NaN") || !infinite && cell.endsWith("Infinity");
            line.append(',').append(absent ? missing : cell);
        }
    }
}
