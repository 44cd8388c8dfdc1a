package wbv.sensing;

import java.util.List;
import java.util.stream.Collectors;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;

/**
 * Where the axes of a quantity of a place stand in a row.
 *
 * @param columns of x, y, z, or of w, x, y, z
 */
record AxisColumns(int[] columns) {

    /** Whether the channels hold all axes. */
    static boolean in(List<Channel> channels, String place, Quantity quantity) {
        return quantity.axes().chars().allMatch(axis -> channels.contains(new Channel(place, quantity, (char) axis)));
    }

    /** @throws DataFault if an axis is missing */
    static AxisColumns of(List<Channel> channels, String place, Quantity quantity, String why) {
        if (!in(channels, place, quantity)) {
            String places = channels.stream().map(Channel::location).distinct().collect(Collectors.joining(", "));
            throw new DataFault(why + " needs all of " + place + "." + quantity.symbol() + "." + quantity.axes()
                    + "; the recording has the places " + places);
        }
        return new AxisColumns(quantity.axes().chars()
                .map(axis -> 1 + channels.indexOf(new Channel(place, quantity, (char) axis))).toArray());
    }

    /**
     * @param row Not modified.
     * @param out Modified.
     */
    void take(double[] row, double[] out) {
        for (int i = 0; i < columns.length; i++) {
            out[i] = row[columns[i]];
        }
    }

    /**
     * @param row Modified.
     * @param values Not modified.
     */
    void put(double[] row, double[] values) {
        for (int i = 0; i < columns.length; i++) {
            row[columns[i]] = values[i];
        }
    }
}
