package moa.tasks.wbv;

/** {@link wbv.task.FollowLag} where MOA's window looks for tasks. */
public final class FollowLag extends wbv.task.FollowLag {

    private static final long serialVersionUID = 1;
}
