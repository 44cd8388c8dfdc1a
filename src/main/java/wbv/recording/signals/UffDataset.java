package wbv.recording.signals;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import wbv.recording.Quantity;
import wbv.recording.Unit;

/**
 * One function at a node, datasets 58 (text) and 58b (IEEE numbers of either byte order). Source: SDRC, "Universal file datasets", 58.
 *
 * @param title     its first line, the function's description; empty if none
 * @param function  type of function: 0 unknown, 1 time response
 * @param entity    what the node belongs to; empty if nothing is said
 * @param direction 0 scalar, ±1 to ±3 along x, y and z, ±4 to ±6 about them
 * @param type      what the numbers are: 8 displacement, 9 reaction force, 11 velocity, 12 acceleration, 13 excitation force, …
 * @param unit      as it is written; empty if nothing is said
 * @param complex   true for spectra and the like, whose numbers are not read
 * @param abscissa  what the abscissa is: 0 unknown, 17 time, 18 frequency
 * @param times     of each sample [s]; empty where they are even
 * @param start     of even ones [s]
 * @param rate      of even ones [Hz]
 * @param values    in that unit
 */
record UffDataset(String title, int function, String entity, int node, int direction, int type, String unit, boolean complex, int abscissa,
        double[] times, double start, double rate, double[] values) {

    private static final int TIME_RESPONSE = 1;
    private static final int UNKNOWN = 0;
    private static final int GENERAL = 1;
    private static final int TIME = 17;
    private static final int IEEE = 2;
    private static final int BIG_ENDIAN = 2;
    /** More numbers than any line holds. */
    private static final int PER_LINE = 1 << 12;

    /** Reads the dataset whose number is the present line. */
    static UffDataset read(UffLines in) throws IOException {
        boolean binary = in.text().strip().startsWith("58b");
        int order = binary ? in.whole(7, 13) : 0;
        int format = binary ? in.whole(13, 19) : IEEE;
        int more = binary ? in.whole(19, 31) : 11;
        long bytes = binary ? (long) in.number(31, 43) : 0;
        if (format != IEEE) {
            throw in.fault("holds numbers of a VAX or an IBM mainframe; IEEE 754 is read");
        }
        in.required();
        String title = in.field(0, 80);
        for (int i = 0; i < 5; i++) {
            in.required();
        }
        int function = in.whole(0, 5);
        String entity = in.field(31, 41);
        int node = in.whole(41, 51);
        int direction = in.whole(51, 55);
        in.required();
        int numbers = in.whole(0, 10);
        int count = in.whole(10, 20);
        boolean even = in.whole(20, 30) == 1;
        double start = in.number(30, 43);
        double rate = even ? rate(in.field(43, 56), in.number(43, 56)) : Double.NaN;
        in.required();
        int abscissa = in.whole(0, 10);
        in.required();
        int type = in.whole(0, 10);
        String unit = in.field(47, 67);
        for (int i = 9; i < more; i++) {
            in.required();
        }
        boolean complex = numbers == 5 || numbers == 6;
        boolean twice = numbers == 4 || numbers == 6;
        if (!complex && numbers != 2 && numbers != 4 || count < 0 || even && !(rate > 0 && Double.isFinite(rate))) {
            throw in.fault("a dataset 58 states " + count + " numbers of type " + numbers + (even ? " every " + 1 / rate + " s" : "")
                    + "; it is damaged");
        }
        int width = (complex ? 2 : 1) + (even ? 0 : 1);
        double[] all = new double[0];
        if (binary) {
            ByteOrder bytewise = order == BIG_ENDIAN ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
            all = numbers(ByteBuffer.wrap(in.bytes(bytes)).order(bytewise), count, width, even, twice, in);
        } else if (!complex) {
            all = text(in, count, width, twice);
        }
        double[] values = complex ? new double[0] : all;
        double[] times = new double[complex || even ? 0 : count];
        if (times.length > 0) {
            values = new double[count];
            for (int i = 0; i < count; i++) {
                times[i] = all[2 * i];
                values[i] = all[2 * i + 1];
            }
        }
        return new UffDataset(title, function, entity, node, direction, type, unit, complex, abscissa, times, start, rate, values);
    }

    /**
     * Samples per second. An increment has six digits as a rule: a whole number of samples a second that it is the rounding of is meant.
     *
     * @param written the increment as it stands
     */
    static double rate(String written, double increment) {
        String[] parts = written.toUpperCase(Locale.ROOT).replace('D', 'E').split("E");
        int point = parts[0].indexOf('.');
        int exponent = parts.length > 1 && !parts[1].isEmpty() ? Integer.parseInt(parts[1].replaceFirst("^\\+", "")) : 0;
        double last = Math.pow(10, exponent - (point < 0 ? 0 : parts[0].length() - point - 1));
        double whole = Math.rint(1 / increment);
        return whole > 0 && Math.abs(1 / whole - increment) <= 0.5001 * last ? whole : 1 / increment;
    }

    private static double[] numbers(ByteBuffer bytes, int count, int width, boolean even, boolean twice, UffLines in) {
        int each = count == 0 ? 0 : bytes.capacity() / count;
        int ordinates = width - (even ? 0 : 1);
        int size = twice ? 8 : 4;
        int abscissa = even ? 0 : each - ordinates * size; // single precision by the standard, double in what some programs write
        if (count > 0 && (each != abscissa + ordinates * size || !even && abscissa != 4 && abscissa != 8)) {
            throw in.fault("a dataset 58b states " + count + " numbers in " + bytes.capacity() + " bytes; it is damaged");
        }
        double[] all = new double[count * width];
        for (int i = 0; i < all.length; i++) {
            boolean time = !even && i % width == 0;
            all[i] = (time ? abscissa == 8 : twice) ? bytes.getDouble() : bytes.getFloat();
        }
        return all;
    }

    /** Numbers in columns of 13 (single) or 20 (double) letters; the abscissa's are 13 wide always. */
    private static double[] text(UffLines in, int count, int width, boolean twice) throws IOException {
        if ((long) count * width > Integer.MAX_VALUE - 8) {
            throw in.fault("a dataset of " + count + " samples is not read");
        }
        double[] all = new double[Math.min(count * width, 1 << 16)]; // grows as numbers come: what is stated may be damage
        for (int i = 0; i < count * width;) {
            all = i + PER_LINE > all.length ? Arrays.copyOf(all, (int) Math.min((long) count * width, 2L * all.length)) : all;
            String line = in.required();
            if (in.delimits()) {
                throw in.fault("a dataset 58 states " + count + " samples and ends after " + i / width);
            }
            int from = i;
            for (int at = 0; at < line.length() && i < all.length && !line.substring(at).isBlank(); i++) {
                int to = Math.min(line.length(), at + (twice && !(width > 1 && i % width == 0) ? 20 : 13));
                all[i] = parsed(line.substring(at, to).strip());
                if (Double.isInfinite(all[i])) { // not in its columns: parted by blanks, perhaps
                    i = blanks(in, line, all, from);
                    break;
                }
                at = to;
            }
        }
        return all;
    }

    private static int blanks(UffLines in, String line, double[] all, int from) {
        int i = from;
        for (String word : line.strip().split("\\s+")) {
            double value = parsed(word);
            if (Double.isInfinite(value) || i == all.length) {
                throw in.fault("is no row of numbers: '" + (line.length() > 40 ? line.substring(0, 40) + "…" : line) + "'");
            }
            all[i++] = value;
        }
        return i;
    }

    /** The number, or infinity where there is none. */
    private static double parsed(String text) {
        try {
            return Double.parseDouble(text.replace('D', 'E').replace('d', 'e'));
        } catch (NumberFormatException other) {
            return Double.POSITIVE_INFINITY;
        }
    }

    /** Whether it is a signal over time. */
    boolean signal() {
        boolean overTime = abscissa == TIME || abscissa == UNKNOWN;
        return !complex && (function == TIME_RESPONSE && (overTime || abscissa == GENERAL) || function == UNKNOWN && overTime);
    }

    private boolean turns() {
        return Math.abs(direction) > 3;
    }

    /** The axis that it is along or about, if it has one. */
    Optional<Character> axis() {
        int axis = (Math.abs(direction) - 1) % 3;
        return direction == 0 || Math.abs(direction) > 6 ? Optional.empty() : Optional.of("xyz".charAt(axis));
    }

    /** What was measured, as far as it is one of ours: by the type, or else by the unit. */
    Optional<Quantity> quantity() {
        return switch (type) {
            case 12 -> turns() ? Optional.empty() : Optional.of(Quantity.ACCELERATION);
            case 11 -> Optional.of(turns() ? Quantity.ANGULAR_RATE : Quantity.VELOCITY);
            case 8 -> Optional.of(turns() ? Quantity.ANGLE : Quantity.POSITION);
            case 9, 13 -> turns() ? Optional.empty() : Optional.of(Quantity.FORCE);
            case 5 -> Optional.of(Quantity.TEMPERATURE);
            case 0, 1 -> UnitWords.of(unit).flatMap(symbol -> Unit.of(symbol)).flatMap(known -> Arrays.stream(Quantity.values())
                    .filter(quantity -> quantity.unit().equals(known.dimension())).findFirst());
            default -> Optional.empty();
        };
    }
}
