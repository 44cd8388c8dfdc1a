package wbv.diagnosis.learn;

import java.util.Arrays;
import java.util.Set;
import java.util.stream.Collectors;
import wbv.body.Assembly;
import wbv.body.number.Modulator;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.search.Refinement;

/**
 * Where terms of a law are scored.
 *
 * @param on what they are to stand on
 * @param x its coordinates [1], one a knob
 * @param motion of the links
 * @param begun terms that are begun there where the model went far
 * @param kin modulators of terms that are begun beside them, whatever their score
 */
record Ground(Candidate on, double[] x, Motion motion, int begun, Set<Modulator> kin) {

    /**
     * The motion as it was measured.
     *
     * @param x the model's numbers
     */
    static Ground asMeasured(Evidence evidence, Candidate on, double[] x, int begun) {
        return new Ground(on, x, Motion.measured(evidence, on.at(x)), begun, Set.of());
    }

    /**
     * In the place of a fit's terms, along the motion that it makes: even that of half a law is nearer to the truth than two
     * accelerometers twice integrated.
     */
    static Ground along(Evidence evidence, Candidate on, Fitter.State fit, int begun) {
        Assembly assembly = fit.candidate().at(fit.x());
        Set<Modulator> kin = assembly.laws().stream().map(at -> at.law().modulator())
                .filter(modulator -> !(modulator instanceof Modulator.None)).collect(Collectors.toSet());
        return new Ground(on, Arrays.copyOf(fit.x(), on.knobs().size()), Motion.simulated(evidence, assembly), begun, kin);
    }

    /**
     * Beside a fit's terms; along the motion that these make where they explain nearly all. Where there are none, along the model's own:
     * along what was measured of a body that something pushes, anything would explain the push.
     */
    static Ground beside(Evidence evidence, Fitter.State base, Fitter.State fit) {
        Assembly assembly = fit.candidate().at(fit.x());
        boolean told = fit.candidate().added().isEmpty() || Refinement.explainsNearlyAll(base, fit);
        return new Ground(fit.candidate(), fit.x(), told ? Motion.simulated(evidence, assembly) : Motion.measured(evidence, assembly), 0,
                Set.of());
    }
}
