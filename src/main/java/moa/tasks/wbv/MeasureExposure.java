package moa.tasks.wbv;

/** {@link wbv.task.MeasureExposure} where MOA's window looks for tasks. */
public final class MeasureExposure extends wbv.task.MeasureExposure {

    private static final long serialVersionUID = 1;
}
