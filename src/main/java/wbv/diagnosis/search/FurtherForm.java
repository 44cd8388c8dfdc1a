package wbv.diagnosis.search;

import java.util.Arrays;
import java.util.List;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * A mechanism once it is found in its plain form, in one with a number more: a hidden mass on a spring that stiffens, a softening that
 * sets in more slowly. The number has to pay for itself (Schwarz 1978).
 */
final class FurtherForm {

    private final Refinement refinement;
    private final Fitter.State base;

    /** @param base on top of which the mechanism was found */
    FurtherForm(Refinement refinement, Fitter.State base) {
        this.refinement = refinement;
        this.base = base;
    }

    /** The same fit in the further form, polished; none where there is no such form, or nothing asks for it. */
    List<Fitter.State> rivals(Fitter.State fit) {
        Hypothesis last = fit.candidate().last();
        double[] found = Arrays.stream(fit.candidate().positions(last))
                .mapToDouble(i -> fit.candidate().knobs().get(i).value(fit.x()[i])).toArray();
        double degrees = fit.frame().whitening().degrees();
        return last.kind().further(last, found).stream()
                .flatMap(form -> refinement.polished(base.candidate(), form, Arrays.copyOf(fit.x(), base.x().length), fit.frame(),
                        form.starts().stream().map(Hypothesis.Start::values).toList()).stream())
                .filter(other -> (fit.reduced() - other.reduced()) * degrees > Math.log(degrees)).toList();
    }
}
