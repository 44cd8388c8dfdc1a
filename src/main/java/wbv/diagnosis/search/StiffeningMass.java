package wbv.diagnosis.search;

import java.util.Arrays;
import java.util.List;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.mechanism.HiddenMass;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * A hidden mass once it is found on a linear spring, on one that stiffens: its frequency is another on a rougher stretch. The number more
 * has to pay for itself (Schwarz 1978).
 */
final class StiffeningMass {

    private final Refinement refinement;
    private final Fitter.State base;

    /** @param base on top of which the mass was found */
    StiffeningMass(Refinement refinement, Fitter.State base) {
        this.refinement = refinement;
        this.base = base;
    }

    /** The same fit with a spring that stiffens, polished; none where the last hypothesis is no such mass, or nothing asks for it. */
    List<Fitter.State> rivals(Fitter.State fit) {
        Hypothesis last = fit.candidate().last();
        if (!(last.additions().get(0) instanceof Hypothesis.Addition.Hidden hidden) || hidden.mode().cubic() > 0) {
            return List.of();
        }
        double[] found = Arrays.stream(fit.candidate().positions(last))
                .mapToDouble(i -> fit.candidate().knobs().get(i).value(fit.x()[i])).toArray();
        Hypothesis stiffening = new HiddenMass().stiffening(last, found);
        double degrees = fit.frame().whitening().degrees();
        return refinement.polished(base.candidate(), stiffening, Arrays.copyOf(fit.x(), base.x().length), fit.frame(),
                stiffening.starts().stream().map(Hypothesis.Start::values).toList()).stream()
                .filter(other -> (fit.reduced() - other.reduced()) * degrees > Math.log(degrees)).toList();
    }
}
