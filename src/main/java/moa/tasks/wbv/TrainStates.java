package moa.tasks.wbv;

/** {@link wbv.task.TrainStates} where MOA's window looks for tasks. */
public final class TrainStates extends wbv.task.TrainStates {

    private static final long serialVersionUID = 1;
}
