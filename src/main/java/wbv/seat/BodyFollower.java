package wbv.seat;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import wbv.filter.BodyEstimate;
import wbv.filter.Estimator;
import wbv.filter.ShareExplained;
import wbv.filter.drift.Adwin;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** One body of a seat: its estimator and what that explains. */
final class BodyFollower implements Snapshot {

    private final SeatPlan.Body body;
    private final int input;
    private final int output;
    private final Estimator estimator;
    private final ShareExplained explained = new ShareExplained();
    private double frequencyBefore;
    private long divergences;

    BodyFollower(SeatPlan.Body body, SeatPlan plan) {
        this.body = body;
        this.input = plan.column(body.input());
        this.output = plan.column(body.output());
        this.estimator = body.design().estimator(body.spec(), Adwin::new);
        this.frequencyBefore = estimator.track().frequency();
    }

    /**
     * Takes a sample.
     *
     * @param row Not modified.
     * @param time of it [s]
     */
    BodyEstimate step(double[] row, double time, Consumer<SeatAlarm> alarms) {
        BodyEstimate track = estimator.step(row[input], row[output]);
        explained.accept(track.prediction(), row[output], body.spec().rate(), track.excited());
        if (track.changed()) {
            alarms.accept(new SeatAlarm(SeatAlarm.Kind.BODY_CHANGED, time, String.format(Locale.ROOT,
                    "%s is no longer the body of %.2f Hz, heard by %s", body.output(), frequencyBefore, track.heardBy().word())));
        }
        if (track.divergences() > divergences) {
            divergences = track.divergences();
            alarms.accept(new SeatAlarm(SeatAlarm.Kind.ESTIMATE_LOST, time, "the estimate for " + body.output()
                    + " left what a body can be, or explained nothing, and began anew"));
        }
        frequencyBefore = track.frequency();
        return track;
    }

    double input(double[] row) {
        return row[input];
    }

    double output(double[] row) {
        return row[output];
    }

    SeatResult.Body now() {
        BodyEstimate track = estimator.track();
        List<SeatResult.Mode> modes = new ArrayList<>();
        for (int m = 0; m < track.modes(); m++) {
            modes.add(new SeatResult.Mode(track.frequency(m), track.frequencyDeviation(m), track.damping(m),
                    track.dampingDeviation(m)));
        }
        return new SeatResult.Body(body.output(), modes, explained.share(), track.excited(), track.settled());
    }

    @Override
    public void save(StateWriter out) {
        out.put(estimator);
        out.put(explained);
        out.put(frequencyBefore);
        out.put(divergences);
    }

    @Override
    public void load(StateReader in) {
        in.part(estimator);
        in.part(explained);
        frequencyBefore = in.number();
        divergences = in.count();
    }
}
