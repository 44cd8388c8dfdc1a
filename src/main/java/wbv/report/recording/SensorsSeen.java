package wbv.report.recording;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import wbv.recording.Channel;
import wbv.recording.inspect.Finding;
import wbv.recording.inspect.Inspection;
import wbv.recording.inspect.Severity;
import wbv.report.page.SensorFigure;
import wbv.report.page.Tiles;
import wbv.study.FoldedFindings;

/** The sensors of a recording with what was found of each, for the {@link SensorFigure}. */
public final class SensorsSeen {

    private SensorsSeen() {}

    /** Every place of a recording. */
    public static SensorFigure of(Inspection seen) {
        Map<String, List<Channel>> places = new LinkedHashMap<>();
        seen.summaries().keySet().forEach(channel -> places.computeIfAbsent(channel.location(), place -> new ArrayList<>()).add(channel));
        List<SensorFigure.Sensor> sensors = new ArrayList<>();
        places.forEach((place, channels) -> {
            List<Finding> own = seen.findings().stream()
                    .filter(finding -> FoldedFindings.place(finding).map(place::equals).orElse(false)).toList();
            Tiles.Tone tone = own.stream().map(Finding::severity).max(Comparator.naturalOrder())
                    .map(SensorsSeen::tone).orElse(Tiles.Tone.GOOD);
            sensors.add(new SensorFigure.Sensor(place, shortened(channels), tone,
                    own.stream().map(FoldedFindings::brief).distinct().limit(4).collect(Collectors.joining(", "))
                            + (own.size() > 4 ? " and more" : "")));
        });
        return new SensorFigure(sensors);
    }

    private static Tiles.Tone tone(Severity severity) {
        return switch (severity) {
            case NOTE -> Tiles.Tone.PLAIN;
            case WARNING -> Tiles.Tone.WARNING;
            case FAULT -> Tiles.Tone.FAULT;
        };
    }

    /** Channels of a place by quantity: {@code acc x y z, gyr x y z}. */
    private static String shortened(List<Channel> channels) {
        Map<String, String> axes = new LinkedHashMap<>();
        channels.forEach(channel -> axes.merge(channel.quantity().symbol(), String.valueOf(channel.axis()), (a, b) -> a + " " + b));
        return axes.entrySet().stream().map(entry -> entry.getKey() + " " + entry.getValue()).collect(Collectors.joining(", "));
    }
}
