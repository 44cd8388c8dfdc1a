package wbv.live;

import java.io.IOException;
import java.util.Locale;
import java.util.stream.Collectors;
import wbv.recording.Channel;
import wbv.seat.SeatPlan;
import wbv.seat.SeatResult;
import wbv.state.StateTrack;

/** What a live stream tells, as lines of JSON; the field {@code type} says what a line is. */
final class Records {

    private Records() {}

    static String begin(String source, String version) {
        return JsonLine.object(json -> json.text("type", "begin").text("source", source).text("version", version));
    }

    /** A seat whose rate is known. */
    static String seat(LiveSeat seat) {
        SeatPlan plan = seat.plan();
        return JsonLine.object(json -> {
            json.text("type", "seat").text("seat", seat.name()).number("rate_hz", seat.rate())
                    .list("channels", list -> {
                        for (Channel channel : seat.channels()) {
                            list.item(channel.toString());
                        }
                    }).list("bodies", list -> {
                        for (SeatPlan.Body body : plan.bodies()) {
                            list.item(each -> each.text("input", body.input().toString()).text("output", body.output().toString())
                                    .text("estimator", body.design().method().word()));
                        }
                    }).text("exposure_axes", axes(plan)).truth("states", plan.states().isPresent());
        });
    }

    private static String axes(SeatPlan plan) {
        return plan.axes().values().stream().map(column -> plan.channels().get(column).toString()).collect(Collectors.joining(","));
    }

    static String result(SeatResult result) {
        return JsonLine.object(json -> {
            json.text("type", "result").text("seat", result.seat()).time("t_s", result.time()).count("samples", result.sample());
            fields(json, result);
        });
    }

    /** What is known of a seat, as fields. */
    static void fields(JsonLine json, SeatResult result) throws IOException {
        json.list("bodies", list -> {
            for (SeatResult.Body body : result.bodies()) {
                list.item(each -> body(each, body));
            }
        });
        if (result.exposure().isPresent()) {
            exposure(json, result.exposure().get());
        }
        if (result.state().isPresent()) {
            SeatResult.State state = result.state().get();
            json.nested("state", fields -> {
                fields.text("name", state.state().toString()).number("probability", state.probability()).nested("jerk_within", ahead -> {
                    for (int i = 0; i < state.jerk().size(); i++) {
                        ahead.number(String.format(Locale.ROOT, "%s_s", StateTrack.HORIZONS[i]), state.jerk().get(i));
                    }
                });
            });
        }
        SeatResult.Losses losses = result.losses();
        json.nested("losses", fields -> fields.count("samples", losses.samples()).count("values", losses.missing()).count("restarts",
                losses.restarts()));
    }

    private static void body(JsonLine json, SeatResult.Body body) throws IOException {
        json.text("output", body.output().toString()).truth("stands", Curves.stands(body)).list("modes", list -> {
            for (SeatResult.Mode mode : body.modes()) {
                list.item(each -> each.number("natural_frequency_hz", mode.frequency())
                        .number("natural_frequency_deviation_hz", mode.frequencyDeviation()).number("damping_ratio", mode.damping())
                        .number("damping_ratio_deviation", mode.dampingDeviation()));
            }
        }).number("explained", body.explained()).truth("excited", body.excited());
    }

    private static void exposure(JsonLine json, SeatResult.Exposure exposure) throws IOException {
        json.nested("exposure", fields -> {
            fields.number("seconds", exposure.seconds()).number("missing_s", exposure.missing()).number("a8_m_s2", exposure.a8())
                    .number("vdv_m_s1.75", exposure.vdv()).text("verdict", exposure.verdict().words())
                    .number("minutes_to_action_value", exposure.minutesToAction())
                    .number("minutes_to_limit_value", exposure.minutesToLimit())
                    .list("axes", list -> {
                        for (SeatResult.Axis axis : exposure.axes()) {
                            list.item(each -> each.text("axis", String.valueOf(axis.axis().letter())).number("a_w_m_s2", axis.rms())
                                    .number("running_m_s2", axis.running()).number("a8_m_s2", axis.a8()).number("vdv_m_s1.75", axis.vdv()));
                        }
                    });
        });
    }

    static String notice(Notice notice) {
        return JsonLine.object(json -> {
            json.text("type", "alarm");
            fields(json, notice);
        });
    }

    static void fields(JsonLine json, Notice notice) throws IOException {
        if (!notice.seat().isEmpty()) {
            json.text("seat", notice.seat());
        }
        json.time("t_s", notice.time()).text("kind", notice.kind()).text("severity", notice.severity().name().toLowerCase(Locale.ROOT))
                .text("reason", notice.reason());
        if (!notice.advice().isEmpty()) {
            json.text("advice", notice.advice());
        }
        if (notice.over()) {
            json.truth("over", true);
        }
    }

    /** The end of the stream. */
    static String end(LiveStream live) {
        return JsonLine.object(json -> json.text("type", "end").count("lines", live.lines()).count("rows", live.rows())
                .count("unreadable", live.unreadable()).count("refused", live.refused()).count("seats", live.seats()));
    }
}
