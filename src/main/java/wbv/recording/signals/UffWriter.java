package wbv.recording.signals;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/** Writes a universal file: SI by dataset 164, then one dataset 58 or 58b a channel, in double precision. Text has 13 digits. */
final class UffWriter {

    private UffWriter() {}

    static void write(SampledColumns columns, boolean binary, OutputStream out) throws IOException {
        double rate = columns.rate();
        BufferedOutputStream to = new BufferedOutputStream(out, 1 << 16);
        StringBuilder text = new StringBuilder();
        text.append(String.format(Locale.ROOT, "%6d%n%6d%n%10d%-20s%10d%n%25s%25s%25s%n%25s%n%6d%n", -1, 164, 1, "SI", 2,
                "1.00000000000000000D+00", "1.00000000000000000D+00", "1.00000000000000000D+00", "2.73149999999999977D+02", -1));
        List<String> places = new ArrayList<>();
        for (int i = 0; i < columns.channels().size(); i++) {
            Channel channel = columns.channels().get(i);
            if (!places.contains(channel.location())) {
                places.add(channel.location());
            }
            head(text, columns, rate, channel, places.indexOf(channel.location()) + 1, i + 1, binary);
            flush(text, to);
            if (binary) {
                ByteBuffer bytes = ByteBuffer.allocate(8 * columns.length()).order(ByteOrder.LITTLE_ENDIAN);
                for (int j = 0; j < columns.length(); j++) {
                    bytes.putDouble(columns.value(i, j));
                }
                to.write(bytes.array());
                text.append('\n');
            } else {
                for (int j = 0; j < columns.length(); j++) {
                    double value = columns.value(i, j);
                    text.append(Double.isNaN(value) ? String.format("%20s", "NaN") : String.format(Locale.ROOT, "%20.12E", value))
                            .append(j % 4 == 3 || j == columns.length() - 1 ? "\n" : "");
                    flush(text, to);
                }
            }
            text.append(String.format("%6d%n", -1));
        }
        flush(text, to);
        to.flush();
    }

    private static void head(StringBuilder text, SampledColumns columns, double rate, Channel channel, int node, int number,
            boolean binary) {
        Quantity quantity = channel.quantity();
        String place = channel.location().substring(0, Math.min(10, channel.location().length()));
        text.append(String.format("%6d%n", -1));
        text.append(binary ? String.format("%6sb%6d%6d%12d%12d%6d%6d%12d%12d%n", "58", 1, 2, 11, 8L * columns.length(), 0, 0, 0, 0)
                : String.format("%6d%n", 58));
        text.append(String.format("%s%nwbv%nNONE%nNONE%nNONE%n", channel));
        text.append(String.format("%5d%10d%5d%10d %-10s%10d%4d %-10s%10d%4d%n", 1, number, 0, 0, place, node, direction(channel), "NONE", 0,
                0));
        text.append(String.format("%10d%10d%10d%s%s%s%n", 4, columns.length(), 1, narrow(columns.time(0)), narrow(1 / rate), narrow(0)));
        text.append(String.format("%10d%5d%5d%5d %-20s %-20s%n", 17, 0, 0, 0, "Time", "s"));
        int length = quantity == Quantity.ACCELERATION || quantity == Quantity.SPECIFIC_FORCE || quantity == Quantity.VELOCITY
                || quantity == Quantity.POSITION ? 1 : 0;
        int force = quantity == Quantity.FORCE ? 1 : 0;
        int temperature = quantity == Quantity.TEMPERATURE ? 1 : 0;
        text.append(String.format("%10d%5d%5d%5d %-20s %-20s%n", type(quantity), length, force, temperature,
                quantity.name().charAt(0) + quantity.name().substring(1).toLowerCase(Locale.ROOT).replace('_', ' '),
                quantity.unit().replace("²", "^2").replace("°C", "degC")));
        for (int i = 0; i < 2; i++) {
            text.append(String.format("%10d%5d%5d%5d %-20s %-20s%n", 0, 0, 0, 0, "NONE", "NONE"));
        }
    }

    /** A number in 13 columns with seven digits, one more than the format asks for. */
    private static String narrow(double value) {
        return String.format(Locale.ROOT, "%13.6E", value);
    }

    private static int direction(Channel channel) {
        int axis = "xyz".indexOf(channel.axis()) + 1;
        boolean turns = channel.quantity() == Quantity.ANGULAR_RATE || channel.quantity() == Quantity.ANGLE;
        return axis == 0 || channel.quantity() == Quantity.QUATERNION ? 0 : turns ? axis + 3 : axis;
    }

    private static int type(Quantity quantity) {
        return switch (quantity) {
            case ACCELERATION, SPECIFIC_FORCE -> 12;
            case ANGULAR_RATE, VELOCITY -> 11;
            case POSITION, ANGLE -> 8;
            case FORCE -> 13;
            case TEMPERATURE -> 5;
            default -> 1;
        };
    }

    private static void flush(StringBuilder text, OutputStream to) throws IOException {
        to.write(text.toString().replace("\r\n", "\n").getBytes(StandardCharsets.ISO_8859_1));
        text.setLength(0);
    }
}
