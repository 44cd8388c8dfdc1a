package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Entering;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;

/** Which of the hypotheses that were screened are refitted. */
final class Shortlist {

    /** Gain that chance seldom makes: of one strength, twice its nats are χ² with one degree of freedom. */
    private static final double SEEN = new ChiSquaredDistribution(1).inverseCumulativeProbability(1 - Priors.CHANCE);

    private final Evidence evidence;

    Shortlist(Evidence evidence) {
        this.evidence = evidence;
    }

    /**
     * In the order of their scores.
     *
     * @param second whether they stand beside a mechanism that explains most
     */
    List<Screening.Score> of(Fitter.State base, List<Screening.Score> scores, boolean second) {
        Set<String> links = scores.stream().filter(score -> score.hypothesis().runsFree()).map(score -> score.hypothesis().where())
                .collect(Collectors.toSet());
        return choose(scores, second, links.size() <= Effort.FEW ? links : second ? Set.of() : Set.of(carryingLink(base)),
                Refinement.bent(base));
    }

    /** The link in which an arbitrary force would explain most; empty with a single output, where each would explain all. */
    private String carryingLink(Fitter.State base) {
        if (evidence.outputs().size() < 2) {
            return "";
        }
        Simulator.Linearised linear = new Simulator(evidence.excitation()).linearised(base.candidate().at(base.x()));
        return IntStream.range(0, evidence.model().links().size()).boxed()
                .min(Comparator.comparingDouble(l -> Entering.left(evidence, base, linear.ofLinkForce(l))))
                .map(l -> evidence.model().links().get(l).name()).orElseThrow();
    }

    /**
     * The best linear hypotheses and the best laws, and those whose effect a first-order look may miss: such as every kind of law in the
     * links that carry the mismatch, since a refit that went far turns the sign of what is seen to first order: then every form of it too,
     * for what acts one way only looks as if it acted the other.
     *
     * @param bent whether the refit went far
     */
    private static List<Screening.Score> choose(List<Screening.Score> scores, boolean second, Set<String> carrying, boolean bent) {
        int mostLaws = second ? Effort.LAWS / 2 : Effort.LAWS;
        int mostLinear = second ? Effort.LINEAR / 2 : Effort.LINEAR;
        List<Screening.Score> chosen = new ArrayList<>();
        int linear = 0;
        int laws = 0;
        Set<String> kinds = new HashSet<>();
        for (Screening.Score score : scores) {
            boolean law = score.hypothesis().runsFree();
            boolean first = law && carrying.contains(score.hypothesis().where())
                    && (kinds.add(score.hypothesis().mechanism() + score.hypothesis().where()) || bent && !second);
            if (first || !second && (score.hypothesis().overturns() || score.hypothesis().kind().isAlwaysRefitted())
                    || score.gain() > SEEN && (law ? laws++ < mostLaws : linear++ < mostLinear)) {
                chosen.add(score);
            }
        }
        return chosen;
    }
}
