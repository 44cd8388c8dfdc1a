package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Start;

/**
 * A mechanism once it is found in its plain form, in one with more numbers: a hidden mass on a spring that stiffens, a softening that
 * sets in more slowly or takes a part of the stiffness, friction with bristles. They have to pay for themselves.
 */
final class FurtherForm {

    private final Refinement refinement;
    private final Fitter.State base;
    private final List<Hypothesis> all;

    /**
     * @param base on top of which the mechanism was found
     * @param all hypotheses of the library
     */
    FurtherForm(Refinement refinement, Fitter.State base, List<Hypothesis> all) {
        this.refinement = refinement;
        this.base = base;
        this.all = all;
    }

    /** The same fit in further forms that pay, one from another, polished; none where there is none, or nothing asks for it. */
    List<Fitter.State> rivals(Fitter.State fit) {
        List<Fitter.State> out = new ArrayList<>();
        List<Fitter.State> from = List.of(fit);
        while (!from.isEmpty()) {
            // A number more may do nothing by itself and much with a second.
            from = polished(from.stream().flatMap(this::forms).toList());
            Fitter.State simpler = out.isEmpty() ? fit : out.get(out.size() - 1);
            for (Fitter.State other : from) {
                List<Fitter.State> shorter = shorter(other);
                out.addAll(shorter);
                if (pays(other, simpler) && shorter.stream().allMatch(without -> refinement.pays(other, without, more(other, without)))) {
                    out.add(other);
                }
            }
        }
        return out;
    }

    /**
     * A form from where another fit stands.
     *
     * @param starts of the form's numbers, each in its unit
     */
    private record Begun(Fitter.State at, Hypothesis form, List<double[]> starts) {}

    private List<Fitter.State> polished(List<Begun> forms) {
        return Parallel.map(forms, begun -> refinement.polished(base.candidate(), begun.form(), numbers(begun.at()), begun.at().frame(),
                begun.starts())).stream().flatMap(List::stream).toList();
    }

    private Stream<Begun> forms(Fitter.State fit) {
        double[] found = values(fit);
        Hypothesis plain = fit.candidate().last();
        return Stream
                .concat(plain.kind().further(plain, found).stream(),
                        plain.form().isEmpty() ? all.stream().filter(form -> form.claim().equals(plain.claim()))
                                .flatMap(form -> plain.kind().begunAt(form, found).stream()) : Stream.empty())
                .map(form -> new Begun(fit, form, form.starts().stream().map(Start::values).toList()));
    }

    /**
     * The forms of the same law that do without one of a form's numbers, begun where that stands, polished: of a command by stretch and one
     * by its speed either may be all there is, and from far off no step leads to it.
     */
    private List<Fitter.State> shorter(Fitter.State further) {
        Hypothesis found = further.candidate().last();
        return polished(all.stream()
                .filter(form -> form.claim().equals(found.claim()) && form.free() < found.free() && form.keys().equals(found.keys()))
                .map(form -> new Begun(further, form, List.of(values(further)))).toList());
    }

    private static int more(Fitter.State further, Fitter.State simpler) {
        return further.candidate().last().free() - simpler.candidate().last().free();
    }

    /**
     * Whether the numbers more are worth their price beside the simpler form, fitted on the same noise from where the further one stands.
     */
    private boolean pays(Fitter.State further, Fitter.State simpler) {
        double[] found = values(simpler);
        Fitter.State without = refinement.fitted(base.candidate(), simpler.candidate().last(), numbers(further), further.frame(),
                List.of(found, Arrays.copyOf(values(further), found.length)));
        return without.failed() || refinement.pays(further, without, more(further, simpler));
    }

    /** Coordinates of what the mechanism stands on [1], one a knob. */
    private double[] numbers(Fitter.State fit) {
        return Arrays.copyOf(fit.x(), base.x().length);
    }

    /** Numbers of the mechanism, each in its unit. */
    private static double[] values(Fitter.State fit) {
        return fit.candidate().values(fit.candidate().last(), fit.x());
    }
}
