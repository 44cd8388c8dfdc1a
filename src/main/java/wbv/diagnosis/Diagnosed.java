package wbv.diagnosis;

import java.util.List;

/** A diagnosis with what it rests on, from which its pictures can be drawn. */
public final class Diagnosed {

    private final Diagnosis diagnosis;
    final Evidence evidence;
    private final Fitter.State given;
    final Fitter.State base;
    final Fitter.State chosen;
    /** Single mechanisms that were fitted, most credible first. */
    final List<Fitter.State> leaders;

    Diagnosed(Diagnosis diagnosis, Evidence evidence, Fitter.State given, Fitter.State base, Fitter.State chosen, List<Fitter.State> leaders) {
        this.diagnosis = diagnosis;
        this.evidence = evidence;
        this.given = given;
        this.base = base;
        this.chosen = chosen;
        this.leaders = List.copyOf(leaders);
    }

    public Diagnosis diagnosis() {
        return diagnosis;
    }

    /** The data held out beside what the last model makes of them: two simulations more. */
    public Predicted predicted() {
        return Predicted.of(diagnosis, evidence, chosen);
    }

    /** Draws: a few simulations more. */
    public Pictures pictures() {
        return Pictures.of(evidence, given, base, chosen, diagnosis);
    }
}
