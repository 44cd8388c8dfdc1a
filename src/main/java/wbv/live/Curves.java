package wbv.live;

import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import wbv.filter.BodyEstimate;
import wbv.identify.EquivalentBody;
import wbv.seat.Seat;
import wbv.seat.SeatPlan;
import wbv.seat.SeatResult;

/** What is kept of a seat for who looks: its last samples, its results in a curve that is thinned as it grows, and the last of them. */
final class Curves implements Seat.Onlooker {

    /** Samples that are drawn as they move [s]. */
    private static final double DRAWN = 20;
    /** Columns of {@link #history}. */
    static final List<String> HISTORY = List.of("t", "f", "df", "z", "dz", "a8", "vdv", "running");

    private final SampleRing drawn;
    private final History history = new History(HISTORY.size());
    private Optional<SeatResult> latest = Optional.empty();

    Curves(SeatPlan plan) {
        drawn = new SampleRing((int) Math.ceil(DRAWN * plan.rate()), 1 + 2 * plan.bodies().size());
    }

    @Override
    public void see(double at, int body, double input, double output, BodyEstimate track) {
        if (body == 0) {
            draw(at, input);
        }
        drawn.set(1 + 2 * body, output);
        drawn.set(2 + 2 * body, track.prediction());
    }

    /** Draws what shakes the seat. */
    void draw(double at, double input) {
        drawn.add(at);
        drawn.set(0, input);
    }

    void remember(SeatResult result) {
        latest = Optional.of(result);
        Optional<SeatResult.Mode> mode = result.bodies().stream().limit(1).filter(Curves::stands).map(body -> body.modes().get(0))
                .findFirst();
        history.accept(result.time(), value(mode, SeatResult.Mode::frequency), value(mode, SeatResult.Mode::frequencyDeviation),
                value(mode, SeatResult.Mode::damping), value(mode, SeatResult.Mode::dampingDeviation),
                value(result.exposure(), SeatResult.Exposure::a8), value(result.exposure(), SeatResult.Exposure::vdv),
                value(result.exposure(), Curves::running));
    }

    private static <T> double value(Optional<T> of, ToDoubleFunction<T> value) {
        return of.isPresent() ? value.applyAsDouble(of.get()) : Double.NaN;
    }

    /** Running r.m.s. of the last second on the worst axis, with k [m/s²]. */
    private static double running(SeatResult.Exposure exposure) {
        return exposure.axes().stream().mapToDouble(axis -> axis.axis().factor() * axis.running()).max().orElse(Double.NaN);
    }

    /** Whether a body's numbers may be shown: it was found, it swings, it is determined, and it explains half of what its place does. */
    static boolean stands(SeatResult.Body body) {
        SeatResult.Mode slow = body.modes().get(0);
        EquivalentBody.Mode mode = new EquivalentBody.Mode(slow.frequency(), slow.frequencyDeviation(), slow.damping(),
                slow.dampingDeviation());
        return body.settled() && body.explained() >= EquivalentBody.LEAST_SHARE && mode.oscillates() && mode.determined();
    }

    /** The last result; empty before the first. */
    Optional<SeatResult> latest() {
        return latest;
    }

    SampleRing drawn() {
        return drawn;
    }

    History history() {
        return history;
    }
}
