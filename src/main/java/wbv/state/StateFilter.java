package wbv.state;

import java.io.Serializable;
import java.util.Arrays;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;
import wbv.state.markov.ForwardFilter;
import wbv.state.markov.Rows;

/** A model's states given all rows of features so far, row by row, in memory that does not grow. */
public final class StateFilter implements Serializable, Snapshot {

    private static final long serialVersionUID = 2;

    private final StateModel model;
    private final ForwardFilter filter;
    private final JoltEvidence jolts;
    private final double[] activity = new double[FeatureSpec.OF_ACTIVITY];
    private final double[] evidence;
    private final double[] byState;

    /** Before the first row. */
    public StateFilter(StateModel model) {
        this(model, new ForwardFilter(model.chain()), new JoltEvidence(model));
    }

    private StateFilter(StateModel model, ForwardFilter filter, JoltEvidence jolts) {
        this.model = model;
        this.filter = filter;
        this.jolts = jolts;
        evidence = new double[model.chain().states()];
        byState = new double[model.chain().states()];
    }

    /** Another filter of the same model, which they share, that has seen no rows. */
    public StateFilter fresh() {
        return new StateFilter(model, filter.fresh(), jolts);
    }

    /**
     * Takes a row; one with a missing value says nothing, and time goes on.
     *
     * @param row as long as {@link FeatureSpec#NAMES}, in their units. Not modified.
     */
    public void step(double[] row) {
        see(row);
        filter.step(activity, evidence);
    }

    /**
     * Probabilities of the named states after this row, without taking it.
     *
     * @param row as long as {@link FeatureSpec#NAMES}, in their units. Not modified.
     * @param into probabilities, one for each {@link MotionState}. Modified.
     */
    public void look(double[] row, double[] into) {
        see(row);
        filter.look(activity, evidence, byState);
        model.byName(byState, into);
    }

    /** Someone told what the state of the last row was: those of other names are out of the question. */
    public void know(MotionState state) {
        filter.probabilities(byState);
        double sum = 0;
        for (int k = 0; k < byState.length; k++) {
            byState[k] = model.names().get(k) == state ? byState[k] + Double.MIN_NORMAL : 0;
            sum += byState[k];
        }
        if (sum > 0) {
            for (int k = 0; k < byState.length; k++) {
                byState[k] /= sum;
            }
            filter.know(byState);
        }
    }

    /**
     * Probabilities of the chain's states after the last row.
     *
     * @param into probabilities, K long. Modified.
     */
    public void probabilities(double[] into) {
        filter.probabilities(into);
    }

    /**
     * Probabilities of the named states after the last row.
     *
     * @param into probabilities, one for each {@link MotionState}. Modified.
     */
    public void byName(double[] into) {
        filter.probabilities(byState);
        model.byName(byState, into);
    }

    private void see(double[] row) {
        if (Rows.complete(row)) {
            StateModel.activity(row, activity);
            jolts.of(row, evidence);
        } else {
            Arrays.fill(activity, Double.NaN);
        }
    }

    @Override
    public void save(StateWriter out) {
        out.put(filter);
    }

    @Override
    public void load(StateReader in) {
        in.part(filter);
    }
}
