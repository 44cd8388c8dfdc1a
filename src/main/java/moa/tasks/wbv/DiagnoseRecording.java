package moa.tasks.wbv;

/** {@link wbv.task.DiagnoseRecording} where MOA's window looks for tasks. */
public final class DiagnoseRecording extends wbv.task.DiagnoseRecording {

    private static final long serialVersionUID = 1;
}
