package wbv.seat;

import java.util.List;
import java.util.Optional;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;
import wbv.state.FeatureSpec;
import wbv.state.FeatureStream;
import wbv.state.MotionState;
import wbv.state.StateFilter;
import wbv.state.StateModel;

/** What the person on a seat does, by a trained model. */
final class StateFollower implements Snapshot {

    private final SeatPlan plan;
    private final FeatureStream stream;
    private final StateFilter filter;
    private final double[] sample = new double[4];
    private final double[] features = new double[FeatureSpec.NAMES.size()];
    private final double[] named = new double[MotionState.values().length];
    private final double[] chain;
    private boolean told;

    /** @param fresh a filter of the model that has heard nothing; it never will, others of its model do */
    StateFollower(SeatPlan plan, StateModel model, StateFilter fresh) {
        this.plan = plan;
        this.stream = new FeatureStream(model.features());
        this.filter = fresh.fresh();
        this.chain = new double[model.chain().states()];
    }

    /**
     * Takes a sample.
     *
     * @param row NaN where missing. Not modified.
     */
    void step(double[] row) {
        int[] columns = plan.stateColumns();
        for (int i = 0; i < sample.length; i++) {
            sample[i] = row[columns[i]];
        }
        stream.step(sample, features);
        filter.step(features);
        told |= !Double.isNaN(features[FeatureSpec.SEAT_JERK]);
    }

    Optional<SeatResult.State> now() {
        if (!told) {
            return Optional.empty();
        }
        filter.byName(named);
        filter.probabilities(chain);
        int best = 0;
        for (int j = 1; j < named.length; j++) {
            best = named[j] > named[best] ? j : best;
        }
        List<Double> jerk = plan.forecasts().stream().map(forecast -> forecast.probability(chain)).toList();
        return Optional.of(new SeatResult.State(MotionState.values()[best], named[best], jerk));
    }

    @Override
    public void save(StateWriter out) {
        out.put(stream);
        out.put(filter);
        out.put(features);
        out.put(told);
    }

    @Override
    public void load(StateReader in) {
        in.part(stream);
        in.part(filter);
        in.numbers(features);
        told = in.flag();
    }
}
