package wbv.recording.format;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/**
 * A rule that names the channels of many columns at once: the column {@code {location}_a{axis}} is the channel
 * {@code {location}.acc.{axis}}, whatever the location and the axis.
 *
 * @param column  the column's name with {@code {location}} and {@code {axis}} where they vary
 * @param channel the channel's name with the same
 * @param unit    what the columns' numbers are in
 * @param scale   factor by which they are multiplied further
 */
public record ColumnPattern(String column, String channel, String unit, double scale) {

    /** Letters by which both placeholders are longer than the shortest words that they stand for. */
    private static final int PLACEHOLDERS = "{location}{axis}".length() - 2;

    public ColumnPattern {
        if (quantity(channel).isEmpty()) {
            throw new IllegalArgumentException("channel must be location.quantity.axis: '" + channel + "'");
        }
        for (String placeholder : List.of("{location}", "{axis}")) {
            if (column.indexOf(placeholder) != column.lastIndexOf(placeholder)) {
                throw new IllegalArgumentException("column may have " + placeholder + " once: '" + column + "'");
            }
        }
    }

    /** The channel of a column, if the rule is about it. Capitals become small letters. */
    Optional<Channel> match(String name) {
        if (name.length() < column.length() - PLACEHOLDERS) { // or a long rule would be compiled for each of many short names
            return Optional.empty();
        }
        String expression = Pattern.quote(column)
                .replace("{location}", "\\E(?<location>[A-Za-z][A-Za-z0-9_]*)\\Q").replace("{axis}", "\\E(?<axis>[wxyzWXYZ])\\Q");
        Matcher matcher = Pattern.compile(expression).matcher(name);
        if (!matcher.matches()) {
            return Optional.empty();
        }
        String parsed = channel;
        parsed = expression.contains("(?<location>") ? parsed.replace("{location}", matcher.group("location")) : parsed;
        parsed = expression.contains("(?<axis>") ? parsed.replace("{axis}", matcher.group("axis")) : parsed;
        String[] words = parsed.toLowerCase(Locale.ROOT).split("\\.", -1);
        boolean axis = words[2].length() == 1 && quantity(parsed).orElseThrow().axes().contains(words[2]);
        return axis && Channel.isLocation(words[0]) ? Optional.of(Channel.parse(String.join(".", words))) : Optional.empty();
    }

    /** The quantity that a pattern of channel names is about, if it is one. */
    static Optional<Quantity> quantity(String channel) {
        String[] words = channel.split("\\.", -1);
        return words.length == 3 ? Quantity.ofSymbol(words[1]) : Optional.empty();
    }
}
