package wbv.diagnosis.search;

import java.util.List;
import wbv.body.Assembly;
import wbv.body.LawAt;
import wbv.body.Spectra;
import wbv.body.Structure;
import wbv.body.law.Law;
import wbv.body.simulate.ModulatorSeries;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis;

/** What laws in links make of the motion as it was measured. */
final class LinkLaws {

    private final Evidence evidence;
    private final Structure structure;
    private final Motion motion;
    private final ModulatorSeries modulators;

    /** @param structure whose links they are in */
    LinkLaws(Evidence evidence, Structure structure, Motion motion, ModulatorSeries modulators) {
        this.evidence = evidence;
        this.structure = structure;
        this.motion = motion;
        this.modulators = modulators;
    }

    /** Whether a hypothesis is laws in a link that are not linear. */
    static boolean isInLink(Hypothesis hypothesis) {
        return hypothesis.runsFree() && hypothesis.additions().stream().allMatch(addition -> addition instanceof Addition.OfLink);
    }

    /** The link that a hypothesis is laws in. */
    static int link(Hypothesis hypothesis) {
        return ((Addition.OfLink) hypothesis.additions().get(0)).link();
    }

    /**
     * The force of all laws of a hypothesis, at the free run's rate, by sample [N].
     *
     * @param hypothesis that is laws in a link
     * @param values by number, in its unit. Not modified.
     */
    double[] force(Hypothesis hypothesis, double[] values) {
        int link = link(hypothesis);
        return force(hypothesis, values, structure.stiffness()[link], structure.damping()[link]);
    }

    /** The same in a link of other numbers [N/m] and [N s/m]. */
    double[] force(Hypothesis hypothesis, double[] values, double stiffness, double damping) {
        int link = link(hypothesis);
        double[] sum = new double[motion.displacement(link).length];
        for (Law law : hypothesis.laws(values)) {
            Spectra.add(sum, force(law, link, motion, stiffness, damping), 1);
        }
        return sum;
    }

    /** What a law of the model carries along this motion beyond what it does along another, likewise. */
    double[] beyond(LawAt at, Motion other) {
        double stiffness = structure.stiffness()[at.link()];
        double damping = structure.damping()[at.link()];
        double[] out = force(at.law(), at.link(), motion, stiffness, damping);
        Spectra.add(out, force(at.law(), at.link(), other, stiffness, damping), -1);
        return out;
    }

    private double[] force(Law law, int link, Motion along, double stiffness, double damping) {
        return law.series(along.displacement(link), along.velocity(link), stiffness, damping, evidence.excitation().fineStep(),
                modulators.of(law.modulator()));
    }

    /** Those of an assembly that are not linear. */
    static List<LawAt> of(Assembly assembly) {
        return assembly.laws().stream().filter(at -> !at.law().isLinear()).toList();
    }
}
