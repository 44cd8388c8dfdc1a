package wbv.diagnosis.measured;

import wbv.body.simulate.Excitation;

/**
 * What models are simulated with.
 *
 * @param fitted up to the end of the fit's window
 * @param whole of the recording
 */
public record Inputs(Excitation fitted, Excitation whole) {

    /** As it was measured. Fits need it up to their window's end and no more: half the lines, half the time. */
    public static Inputs of(Measured measured) {
        int end = measured.split() + (int) measured.recording().clock().rate();
        return new Inputs(Excitation.of(measured.model(), measured.recording(), Math.min(measured.recording().length(), end)),
                measured.input());
    }

    /** All of it for fits too. */
    public static Inputs whole(Excitation whole) {
        return new Inputs(whole, whole);
    }

    /**
     * With a force on a body beside it.
     *
     * @param force [N], by sample of the recording. Not modified.
     */
    public Inputs pushed(int body, double[] force) {
        return new Inputs(fitted.pushed(body, force), whole.pushed(body, force));
    }
}
