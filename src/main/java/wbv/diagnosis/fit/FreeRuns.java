package wbv.diagnosis.fit;

import java.util.Arrays;
import java.util.Optional;
import wbv.body.Assembly;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Sensitivities;
import wbv.body.simulate.Simulator;

/**
 * What candidates do, simulated by themselves from the input. The last run is remembered, since a fit looks more than once where it stands.
 * Threads may share it.
 */
final class FreeRuns {

    private final Excitation excitation;
    private final Simulator simulator;
    /** What goes beyond small motions, where it is held. */
    private final Optional<Simulator.Bends> held;
    /** What was simulated last with nothing given. */
    private volatile Optional<Ran> last = Optional.empty();

    /** @param held what goes beyond small motions in all of them; empty where each finds its own */
    FreeRuns(Excitation excitation, Optional<Simulator.Bends> held) {
        this.excitation = excitation;
        this.simulator = new Simulator(excitation);
        this.held = held;
    }

    /**
     * What a candidate did at some numbers.
     *
     * @param x coordinates [1], one a knob. Not a copy
     * @param slopes derivatives that the response has
     */
    private record Ran(Candidate candidate, double[] x, Sensitivities slopes, Simulator.Response response) {
        private boolean is(Candidate asked, double[] where) {
            return candidate == asked && Arrays.equals(x, where);
        }

        private boolean has(Sensitivities asked) {
            return slopes.compareTo(asked) >= 0;
        }
    }

    /** The input. */
    Excitation excitation() {
        return excitation;
    }

    /** Whether what goes beyond small motions is the same in all of them. */
    boolean areHeld() {
        return held.isPresent();
    }

    /** What a candidate does; empty where it left all bounds. */
    Optional<Simulator.Response> of(Candidate candidate, double[] x) {
        return of(candidate, x, Sensitivities.NONE, Optional.empty());
    }

    /**
     * The same with derivatives.
     *
     * @param bends what goes beyond small motions, where it is given
     */
    Optional<Simulator.Response> of(Candidate candidate, double[] x, Sensitivities sensitivities, Optional<Simulator.Bends> bends) {
        Optional<Simulator.Bends> given = bends.or(() -> held);
        Optional<Ran> known = given.isPresent() ? Optional.empty() : last.filter(ran -> ran.is(candidate, x));
        if (known.filter(ran -> ran.has(sensitivities)).isPresent()) {
            return known.map(Ran::response);
        }
        Optional<Simulator.Response> response = assembly(candidate, x)
                .map(model -> simulator.run(model, sensitivities, given.or(() -> known.flatMap(ran -> ran.response.bends()))))
                .filter(run -> !run.diverged());
        if (given.isEmpty() && response.isPresent()) {
            last = response.map(run -> new Ran(candidate, x.clone(), sensitivities, run));
        }
        return response;
    }

    /** Empty where the numbers are none that a model may have. */
    private static Optional<Assembly> assembly(Candidate candidate, double[] x) {
        try {
            return Optional.of(candidate.at(x));
        } catch (IllegalArgumentException outside) {
            return Optional.empty();
        }
    }
}
