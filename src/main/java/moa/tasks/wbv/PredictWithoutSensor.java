package moa.tasks.wbv;

/** {@link wbv.task.PredictWithoutSensor} where MOA's window looks for tasks. */
public final class PredictWithoutSensor extends wbv.task.PredictWithoutSensor {

    private static final long serialVersionUID = 1;
}
