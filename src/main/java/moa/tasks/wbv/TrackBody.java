package moa.tasks.wbv;

/** {@link wbv.task.TrackBody} where MOA's window looks for tasks. */
public final class TrackBody extends wbv.task.TrackBody {

    private static final long serialVersionUID = 1;
}
