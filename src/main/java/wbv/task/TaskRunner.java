package wbv.task;

import java.io.PrintStream;
import java.io.UncheckedIOException;
import moa.options.ClassOption;
import moa.tasks.MainTask;
import wbv.recording.DataFault;
import wbv.recording.OneLine;

/**
 * Runs any MOA task from its string and says honestly how it went; MOA's own {@code DoTask} exits with 0 after any failure and
 * reports the wrong one. The result is printed as {@code DoTask} prints it.
 */
public final class TaskRunner {

    /** Exit codes. */
    public static final int DONE = 0;
    /** The data or the model is at fault. */
    public static final int DATA_FAULT = 1;
    /** The task's words cannot be understood. */
    public static final int WRONG_USAGE = 2;
    /** The program is at fault. */
    public static final int OUR_FAULT = 3;

    /** Before a line that says what is wrong, as of every command. */
    private static final String WHOSE = "wbv: ";
    private static final String INDENT = "  caused by ";

    private TaskRunner() {}

    public static void main(String[] words) {
        AdmittedClasses.enforce();
        int code = run(String.join(" ", words), System.out, System.err);
        if (code == DONE && System.out.checkError()) {
            System.err.println(WHOSE + "standard output: cannot be written");
            code = DATA_FAULT;
        }
        System.exit(code);
    }

    /**
     * Runs a task.
     *
     * @param task such as {@code wbv.task.TrackBody -s (wbv.stream.RigStream -r 7)}
     * @param out  takes the result
     * @param err  takes the cause of a failure
     * @return one of the exit codes
     */
    public static int run(String task, PrintStream out, PrintStream err) {
        if (task.isBlank()) {
            err.println(WHOSE + "a task is needed, such as: wbv.task.TrackBody -s (wbv.stream.RigStream -r 7)");
            return WRONG_USAGE;
        }
        MainTask parsed;
        try {
            parsed = (MainTask) ClassOption.cliStringToObject(task, MainTask.class, null);
        } catch (Exception wrong) {
            explain("cannot read the task", wrong, err);
            return WRONG_USAGE;
        }
        try {
            parsed.prepareForUse();
            out.println(parsed.doTask());
            return DONE;
        } catch (RuntimeException failed) {
            return failure(failed, err);
        }
    }

    private static int failure(RuntimeException failed, PrintStream err) {
        for (Throwable cause = failed; cause != null; cause = cause.getCause()) {
            if (cause instanceof DataFault) {
                err.println(WHOSE + message(cause));
                return DATA_FAULT;
            }
            if (cause instanceof UncheckedIOException file) {
                err.println(WHOSE + message(file.getCause()));
                return DATA_FAULT;
            }
            if (cause instanceof IllegalArgumentException) {
                err.println(WHOSE + message(cause));
                return WRONG_USAGE;
            }
        }
        explain("the task failed", failed, err);
        return ofMoa(failed) ? WRONG_USAGE : OUR_FAULT;
    }

    /** Whether a failure arose in a class of MOA's, which checks few of its options: then the task, not wbv, is at fault. */
    private static boolean ofMoa(RuntimeException failed) {
        for (StackTraceElement frame : failed.getStackTrace()) {
            if (!frame.getClassName().startsWith("java.") && !frame.getClassName().startsWith("jdk.")) {
                return frame.getClassName().startsWith("moa.") || frame.getClassName().startsWith("com.");
            }
        }
        return false;
    }

    private static void explain(String what, Throwable failure, PrintStream err) {
        err.println(WHOSE + what + ": " + message(failure));
        for (Throwable cause = failure.getCause(); cause != null; cause = cause.getCause()) {
            err.println(INDENT + message(cause));
        }
    }

    private static String message(Throwable failure) {
        return OneLine.of(failure.getMessage() == null ? failure.getClass().getName() : failure.getMessage());
    }
}
