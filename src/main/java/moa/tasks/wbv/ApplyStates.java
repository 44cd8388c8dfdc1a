package moa.tasks.wbv;

/** {@link wbv.task.ApplyStates} where MOA's window looks for tasks. */
public final class ApplyStates extends wbv.task.ApplyStates {

    private static final long serialVersionUID = 1;
}
