package wbv.filter;

import java.io.Serializable;
import wbv.filter.model.Spec;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Takes gravity and sensor bias out of two signals with one and the same first-order high-pass, so that what relates them
 * stays as it was. A constant that differs between them is forgotten with {@link #decay} from sample to sample.
 */
final class HighPassPair implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;

    private final double decay;
    private double inputMean;
    private double outputMean;
    private boolean started;
    private boolean hasOutput;

    HighPassPair(Spec spec) {
        this.decay = Math.exp(-2 * Math.PI * spec.adaptation().information().corner() / spec.rate());
    }

    double decay() {
        return decay;
    }

    void reset() {
        started = false;
        hasOutput = false;
        inputMean = 0;
        outputMean = 0;
    }

    boolean started() {
        return started;
    }

    /** Starts from samples that are both present. */
    void start(double input, double output) {
        inputMean = input;
        outputMean = output;
        started = true;
        hasOutput = true;
    }

    /** Starts from an input that is present while no output is: the output is foreseen as if it had no mean of its own. */
    void startInput(double input) {
        inputMean = input;
        started = true;
    }

    /** Whether there was ever an output. */
    boolean hasOutput() {
        return hasOutput;
    }

    /** The first output after {@link #startInput}. */
    void startOutput(double output) {
        outputMean = output;
        hasOutput = true;
    }

    /** Moves the input's mean on while there never was an output; after {@link #input}. */
    void advanceInput(double input) {
        inputMean += (1 - decay) * (input - inputMean);
    }

    double input(double raw) {
        return decay * (raw - inputMean);
    }

    double output(double raw) {
        return decay * (raw - outputMean);
    }

    /** The raw output sample that {@link #output} would turn into this one. */
    double rawOutput(double blocked) {
        return outputMean + blocked / decay;
    }

    /** Moves both means on; call it only with samples that are both present, after {@link #input} and {@link #output}. */
    void advance(double input, double output) {
        inputMean += (1 - decay) * (input - inputMean);
        outputMean += (1 - decay) * (output - outputMean);
    }

    @Override
    public void save(StateWriter out) {
        out.put(inputMean);
        out.put(outputMean);
        out.put(started);
        out.put(hasOutput);
    }

    @Override
    public void load(StateReader in) {
        inputMean = in.number();
        outputMean = in.number();
        started = in.flag();
        hasOutput = in.flag();
    }
}
