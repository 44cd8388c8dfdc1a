package moa.tasks.wbv;

/** {@link wbv.task.RespondOverTime} where MOA's window looks for tasks. */
public final class RespondOverTime extends wbv.task.RespondOverTime {

    private static final long serialVersionUID = 1;
}
