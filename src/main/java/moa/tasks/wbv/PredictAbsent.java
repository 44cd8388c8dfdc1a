package moa.tasks.wbv;

/** {@link wbv.task.PredictAbsent} where MOA's window looks for tasks. */
public final class PredictAbsent extends wbv.task.PredictAbsent {

    private static final long serialVersionUID = 1;
}
