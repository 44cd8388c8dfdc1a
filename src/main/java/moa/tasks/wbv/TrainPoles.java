package moa.tasks.wbv;

/** {@link wbv.task.TrainPoles} where MOA's window looks for tasks. */
public final class TrainPoles extends wbv.task.TrainPoles {

    private static final long serialVersionUID = 1;
}
