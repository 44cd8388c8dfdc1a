package wbv.live;

import java.io.IOException;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import wbv.recording.Channel;
import wbv.seat.SeatPlan;

/**
 * What one onlooker is shown, and how far he was shown it: all seats in a table by what needs attention, one of them with its curves.
 */
final class Board implements PageServer.Feed {

    /** Rows of the table; seats beyond them are counted. */
    private static final int MOST_ROWS = 300;
    /** Looks between two tables: one a second. */
    private static final int TABLE = 20;

    private final LiveStream live;
    private final String chosen;
    private String shown = "";
    private int looks;
    private long lines = -1;
    private long sample;
    private long result = -1;
    private int points;
    private int thinnings;
    private long notice;
    private boolean planned;
    private boolean ended;

    /** @param chosen seat to show; empty for the one that needs attention most when he came */
    Board(LiveStream live, String chosen) {
        this.live = live;
        this.chosen = chosen;
    }

    @Override
    public String next() {
        synchronized (live) {
            boolean table = looks++ % TABLE == 0;
            boolean come = live.lines() != lines || live.ended() != ended;
            if (!table && !come) {
                return "";
            }
            lines = live.lines();
            ended = live.ended();
            Optional<LiveSeat> seat = seat();
            return JsonLine.object(json -> {
                if (table) {
                    whole(json);
                }
                List<Notice> news = live.noticesAfter(notice);
                if (!news.isEmpty()) {
                    notice = news.get(news.size() - 1).number();
                    json.list("notices", list -> {
                        for (Notice each : news) {
                            list.item(fields -> Records.fields(fields.count("number", each.number()), each));
                        }
                    });
                }
                if (seat.isPresent() && seat.get().begun()) {
                    one(json, seat.get(), table);
                }
            });
        }
    }

    private Optional<LiveSeat> seat() {
        if (shown.isEmpty()) {
            shown = live.seat(chosen).or(() -> live.all().stream().filter(LiveSeat::begun)
                    .max(Comparator.comparingDouble(each -> Attention.of(each).rank()))).map(LiveSeat::name).orElse("");
        }
        return live.seat(shown);
    }

    private void whole(JsonLine json) throws IOException {
        json.text("run", live.run()).text("source", live.source()).count("lines", live.lines()).count("rows", live.rows())
                .count("unreadable", live.unreadable()).count("refused", live.refused()).truth("ended", ended).count("seats", live.seats());
        json.list("table", list -> {
            for (LiveSeat seat : live.all().stream().sorted(Comparator.comparingDouble((LiveSeat each) -> -Attention.of(each).rank())
                    .thenComparing(LiveSeat::name)).limit(MOST_ROWS).toList()) {
                list.item(row -> row(row, seat));
            }
        });
    }

    private static void row(JsonLine json, LiveSeat seat) throws IOException {
        Attention attention = Attention.of(seat);
        json.text("seat", seat.name()).text("tone", attention.tone()).text("attention", attention.words()).time("t_s", seat.time());
        if (seat.latest().isPresent()) {
            Records.fields(json, seat.latest().get());
        }
    }

    private void one(JsonLine json, LiveSeat seat, boolean table) throws IOException {
        json.text("shown", seat.name());
        if (!planned) {
            planned = true;
            json.nested("plan", plan -> plan(plan, seat));
        }
        if (table) {
            json.nested("data", data -> data(data, seat));
        }
        samples(json, seat.curves().drawn());
        history(json, seat.curves().history());
        if (seat.latest().isPresent() && seat.latest().get().sample() != result) {
            result = seat.latest().get().sample();
            json.nested("result", fields -> Records.fields(fields.time("t_s", seat.latest().get().time()), seat.latest().get()));
        }
    }

    private void plan(JsonLine json, LiveSeat seat) throws IOException {
        SeatPlan plan = seat.plan();
        json.number("rate_hz", seat.rate()).text("place", plan.axes().values().stream().findFirst()
                .map(column -> plan.channels().get(column).location()).orElse("")).text("estimator", live.method().word());
        if (!plan.bodies().isEmpty()) {
            json.text("input", plan.bodies().get(0).input().toString()).text("output", plan.bodies().get(0).output().toString())
                    .text("unit", plan.bodies().get(0).input().quantity().unit());
        } else {
            json.text("input", seat.drawnAlone().toString()).text("unit", seat.drawnAlone().quantity().unit());
        }
    }

    private static void data(JsonLine json, LiveSeat seat) throws IOException {
        Set<String> places = new LinkedHashSet<>();
        seat.channels().stream().map(Channel::location).forEach(places::add);
        json.number("rate_hz", seat.rate()).count("rows", seat.rows()).count("missing", seat.missing()).count("repeated", seat.repeated())
                .count("late", seat.late()).count("restarts", seat.restarts()).count("ailing", seat.watch().ailing())
                .count("channels", seat.channels().size()).truth("silent", seat.silent()).list("places", list -> {
                    for (String place : places) {
                        list.item(each -> each.text("place", place).truth("ails", seat.watch().ails(place)));
                    }
                });
    }

    private void samples(JsonLine json, SampleRing ring) throws IOException {
        long from = Math.max(sample, ring.oldest());
        if (from == ring.next()) {
            return;
        }
        long to = ring.next();
        sample = to;
        json.nested("curve", curve -> {
            curve.list("t", list -> {
                for (long i = from; i < to; i++) {
                    list.time(ring.time(i));
                }
            });
            for (int c = 0; c < Math.min(3, ring.curves()); c++) {
                int which = c;
                curve.list(List.of("u", "y", "p").get(c), list -> {
                    for (long i = from; i < to; i++) {
                        list.number(ring.value(which, i));
                    }
                });
            }
        });
    }

    private void history(JsonLine json, History history) throws IOException {
        boolean again = history.thinnings() != thinnings;
        int from = again ? 0 : points;
        thinnings = history.thinnings();
        points = history.held();
        if (from == points) {
            return;
        }
        int to = points;
        json.nested("history", fields -> {
            fields.truth("again", again);
            for (int c = 0; c < history.columns(); c++) {
                int column = c;
                fields.list(Curves.HISTORY.get(c), list -> {
                    for (int i = from; i < to; i++) {
                        if (column == 0) {
                            list.time(history.value(column, i));
                        } else {
                            list.number(history.value(column, i));
                        }
                    }
                });
            }
        });
    }
}
