package wbv.proof;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.apache.commons.math3.optim.MaxEval;
import org.apache.commons.math3.optim.nonlinear.scalar.GoalType;
import org.apache.commons.math3.optim.univariate.BrentOptimizer;
import org.apache.commons.math3.optim.univariate.SearchInterval;
import org.apache.commons.math3.optim.univariate.UnivariateObjectiveFunction;
import org.apache.commons.math3.optim.univariate.UnivariatePointValuePair;
import wbv.diagnosis.search.Calibration;

/** Finds how many parts the form of a law has, such that what answers to concealed recordings turned out to be is likeliest. */
final class Calibrating {

    private static final double FEWEST = 0.5;
    private static final double MOST = 60;
    private static final int TRIES = 200;
    /** Held so firmly an answer should not be wrong but by a lapse. */
    private static final double FIRM = 0.97;

    private final List<Case> cases;
    private final double chance;

    /**
     * What an answer by one name rests on.
     *
     * @param left mean squares: of the name, then of its rivals, of nothing and of what is in no library
     */
    private record Case(double[] left, boolean right) {

        double probability(Calibration calibration) {
            double[] evidence = calibration.evidence(left);
            return 1 / Arrays.stream(evidence).map(each -> Math.exp(each - evidence[0])).sum();
        }
    }

    private Calibrating(List<Case> cases, double chance) {
        this.cases = cases;
        this.chance = chance;
    }

    /**
     * Empty where no answer tells.
     *
     * @param chance excess that chance leaves
     * @param command that made the answers
     * @param commit of which program
     */
    static Optional<Calibration> of(List<Marking> markings, double chance, String command, String commit) {
        List<Case> cases = markings.stream().flatMap(marking -> of(marking).stream()).toList();
        return cases.isEmpty() ? Optional.empty() : Optional.of(new Calibrating(cases, chance).calibration(command, commit));
    }

    /** A single name of the library, of which the excess is known. */
    private static Optional<Case> of(Marking marking) {
        ProofAnswer answer = marking.answer();
        boolean single = answer.missing().size() == 1 && !answer.verdict().equals("unexplained") && marking.truth().concealed().size() == 1
                && !answer.missing().get(0).mechanism().equals(ProofAnswer.LEARNED) && Double.isFinite(answer.missing().get(0).left());
        if (!single) {
            return Optional.empty();
        }
        List<Double> left = new ArrayList<>(
                List.of(answer.missing().get(0).left(), answer.before(), 1 + Calibration.unlisted(answer.before() - 1)));
        answer.alternatives().forEach(rival -> left.add(rival.left()));
        boolean right = marking.mark() == Marking.Mark.RIGHT || marking.mark() == Marking.Mark.IN_SET && marking.parts() > 0
                && answer.missing().get(0).mechanism().equals(marking.truth().concealed().get(0).mechanism());
        return Optional.of(new Case(left.stream().mapToDouble(Double::doubleValue).toArray(), right));
    }

    private Calibration calibration(String command, String commit) {
        UnivariatePointValuePair best = new BrentOptimizer(1e-6, 1e-8).optimize(new MaxEval(TRIES), GoalType.MAXIMIZE,
                new SearchInterval(FEWEST, MOST),
                new UnivariateObjectiveFunction(forms -> score(new Calibration(forms, chance, 0.5, cases.size(), 0, command, commit))));
        Calibration sharp = new Calibration(best.getPoint(), chance, 0.5, cases.size(), best.getValue(), command, commit);
        List<Case> firm = cases.stream().filter(each -> each.probability(sharp) >= FIRM).toList();
        double lapse = (firm.stream().filter(each -> !each.right()).count() + 1.0) / (firm.size() + 2.0);
        return new Calibration(best.getPoint(), chance, lapse, cases.size(), best.getValue(), command, commit);
    }

    /** Mean logarithm of the probability of what was right about the answers. */
    private double score(Calibration calibration) {
        double least = 1.0 / (cases.size() + 2.0);
        return cases.stream().mapToDouble(each -> {
            double p = Math.max(least, Math.min(1 - least, each.probability(calibration)));
            return Math.log(each.right() ? p : 1 - p);
        }).average().orElseThrow();
    }
}
