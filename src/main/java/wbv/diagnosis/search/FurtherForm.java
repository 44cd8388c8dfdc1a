package wbv.diagnosis.search;

import java.util.Arrays;
import java.util.List;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * A mechanism once it is found in its plain form, in one with a number more: a hidden mass on a spring that stiffens, a softening that
 * sets in more slowly. The number has to pay for itself.
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
        double[] found = values(fit);
        Hypothesis plain = fit.candidate().last();
        return plain.kind().further(plain, found).stream()
                .flatMap(form -> refinement.polished(base.candidate(), form, numbers(fit), fit.frame(),
                        form.starts().stream().map(Hypothesis.Start::values).toList()).stream())
                .filter(other -> pays(other, plain, found)).toList();
    }

    /**
     * Whether the number more is worth its price beside the plain form, fitted on the same noise from where the further one stands, on
     * data that were not used too.
     */
    private boolean pays(Fitter.State further, Hypothesis plain, double[] found) {
        Fitter.State without = refinement.fitted(base.candidate(), plain, numbers(further), further.frame(),
                List.of(found, Arrays.copyOf(values(further), found.length)));
        return without.failed() || new Chosen(further, Calibration.standard().price()).outweighs(refinement.heldOut(further),
                Chosen.single(without), refinement.heldOut(without));
    }

    /** Coordinates of what the mechanism stands on [1], one a knob. */
    private double[] numbers(Fitter.State fit) {
        return Arrays.copyOf(fit.x(), base.x().length);
    }

    /** Numbers of the mechanism, each in its unit. */
    private static double[] values(Fitter.State fit) {
        return Arrays.stream(fit.candidate().positions(fit.candidate().last()))
                .mapToDouble(i -> fit.candidate().knobs().get(i).value(fit.x()[i])).toArray();
    }
}
