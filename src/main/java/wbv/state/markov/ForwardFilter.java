package wbv.state.markov;

import java.io.Serializable;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** The probability of every state given all rows so far, row by row, in memory that does not grow. */
public final class ForwardFilter implements Serializable, Snapshot {

    private static final long serialVersionUID = 4;
    private static final double[] NOTHING = {};
    /**
     * Where any state may follow any other, one that is less likely by e to this power than the least transition counts as none: of
     * what comes of the others to any state it would be 10⁻¹¹ at most.
     */
    private static final double LOST = 25;

    private final HiddenMarkov model;
    private final Densities densities;
    private final Transitions transitions;
    private final double negligible;
    private final double[] now;
    private final double[] foreseen;
    private final double[] logs;
    private final double[] scratch;
    private boolean begun;

    /** Before the first row: the states are as likely as the model begins with. */
    public ForwardFilter(HiddenMarkov model) {
        this.model = model;
        int k = model.states();
        densities = new Densities(model);
        transitions = new Transitions(model.transition());
        negligible = Math.max(Densities.NOTHING, Math.log(transitions.least()) - LOST);
        now = new double[k];
        foreseen = new double[k];
        logs = new double[k];
        scratch = new double[densities.work(model.dimensions())];
        reset();
    }

    /** Shares the densities and transitions of another, and nothing of what that has seen. */
    private ForwardFilter(ForwardFilter other) {
        model = other.model;
        densities = other.densities;
        transitions = other.transitions;
        negligible = other.negligible;
        now = new double[other.now.length];
        foreseen = new double[now.length];
        logs = new double[now.length];
        scratch = new double[other.scratch.length];
        reset();
    }

    /** Another filter of the same model, which they share, that has seen no rows. */
    public ForwardFilter fresh() {
        return new ForwardFilter(this);
    }

    /** Forgets all rows. */
    public void reset() {
        begun = false;
        System.arraycopy(model.initial(), 0, now, 0, now.length);
    }

    /** The chain that it follows. */
    public HiddenMarkov model() {
        return model;
    }

    /**
     * Takes a row; one with a missing value says nothing, and time goes on.
     *
     * @param row length d, each number in its own unit. Not modified.
     */
    public void step(double[] row) {
        step(row, NOTHING);
    }

    /**
     * The same with what else is known.
     *
     * @param row length d, each number in its own unit. Not modified.
     * @param evidence logarithm by state that its density is raised by, or empty. Not modified.
     */
    public void step(double[] row, double[] evidence) {
        look(row, evidence, now);
        begun = true;
    }

    /**
     * The states become what is given: someone told.
     *
     * @param probabilities K long, summing to one. Not modified, not kept.
     */
    public void know(double[] probabilities) {
        System.arraycopy(probabilities, 0, now, 0, now.length);
        begun = true;
    }

    /**
     * What the states would be after this row, without taking it.
     *
     * @param row length d, each number in its own unit. Not modified.
     * @param into probabilities, K long. Modified.
     */
    public void look(double[] row, double[] into) {
        look(row, NOTHING, into);
    }

    /**
     * The same with what else is known.
     *
     * @param row likewise. Not modified.
     * @param evidence logarithm by state, or empty. Not modified.
     * @param into likewise. Modified.
     */
    public void look(double[] row, double[] evidence, double[] into) {
        int k = now.length;
        if (begun) {
            transitions.advance(now, foreseen);
        } else {
            System.arraycopy(model.initial(), 0, foreseen, 0, k);
        }
        double greatest = Double.NEGATIVE_INFINITY;
        if (Rows.complete(row)) {
            densities.of(row, scratch, logs);
            for (int j = 0; j < k; j++) {
                logs[j] += evidence.length == 0 ? 0 : evidence[j];
                greatest = Math.max(greatest, foreseen[j] > 0 ? logs[j] : Double.NEGATIVE_INFINITY);
            }
        }
        double sum = 0;
        for (int j = 0; j < k; j++) {
            double value = greatest == Double.NEGATIVE_INFINITY ? foreseen[j] : weighed(foreseen[j], logs[j] - greatest);
            into[j] = value;
            sum += value;
        }
        if (!(sum > 0)) {
            System.arraycopy(foreseen, 0, into, 0, k);
            return;
        }
        double share = 1 / sum;
        boolean finite = Double.isFinite(share);
        for (int j = 0; j < k; j++) {
            into[j] = finite ? into[j] * share : into[j] / sum;
        }
    }

    /** What is foreseen times e^log, which is 0 where nothing is foreseen or so little that it adds nothing to what follows. */
    private double weighed(double foreseen, double log) {
        return foreseen == 0 || log < negligible ? 0 : foreseen * Math.exp(log);
    }

    /** Probability P(state j | rows so far). */
    public double probability(int state) {
        return now[state];
    }

    /**
     * Copies all probabilities.
     *
     * @param into probabilities, K long. Modified.
     */
    public void probabilities(double[] into) {
        System.arraycopy(now, 0, into, 0, now.length);
    }

    @Override
    public void save(StateWriter out) {
        out.put(now);
        out.put(begun);
    }

    @Override
    public void load(StateReader in) {
        in.numbers(now);
        begun = in.flag();
    }
}
