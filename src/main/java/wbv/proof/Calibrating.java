package wbv.proof;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.apache.commons.math3.optim.InitialGuess;
import org.apache.commons.math3.optim.MaxEval;
import org.apache.commons.math3.optim.PointValuePair;
import org.apache.commons.math3.optim.nonlinear.scalar.GoalType;
import org.apache.commons.math3.optim.nonlinear.scalar.ObjectiveFunction;
import org.apache.commons.math3.optim.nonlinear.scalar.noderiv.NelderMeadSimplex;
import org.apache.commons.math3.optim.nonlinear.scalar.noderiv.SimplexOptimizer;
import wbv.diagnosis.search.Calibration;
import wbv.signal.LogSum;

/**
 * Finds how many parts the form of a law has and how much chance leaves, such that what answers to concealed recordings turned out to be is
 * likeliest.
 */
final class Calibrating {

    /** More evaluations than any search of two numbers needs: one that does not end is a fault. */
    private static final int TRIES = 2000;
    /** Where the search begins: logarithms of the parts and of what chance leaves. */
    private static final double[] START = {Math.log(8), Math.log(0.05)};
    /** First step of the search, in the same logarithms [1]: by about as much the calibrations of two seeds differ. */
    private static final double STEP = 0.3;
    /** Held so firmly an answer should not be wrong but by a lapse. */
    private static final double FIRM = 0.97;

    /** Not told by answers, which say nothing of what was not named: kept as it is. */
    private static final double NULLS = Calibration.standard().nulls();

    private final List<Case> cases;

    /**
     * What an answer by one name rests on.
     *
     * @param left mean squares: of the name, then of nothing, of what is in no library, and of the name's rivals
     * @param numbers how likely the model's own numbers are with each, as many [nat]
     */
    private record Case(double[] left, double[] numbers, boolean right) {

        double probability(Calibration calibration) {
            double least = Arrays.stream(left).min().orElseThrow();
            double[] nats = IntStream.range(0, left.length).mapToDouble(i -> calibration.evidence(left[i], least) + numbers[i]).toArray();
            return Math.exp(nats[0] - LogSum.of(nats, nats.length));
        }
    }

    private Calibrating(List<Case> cases) {
        this.cases = cases;
    }

    /**
     * Empty where no answer tells.
     *
     * @param command that made the answers
     * @param commit of which program
     */
    static Optional<Calibration> of(List<Marking> markings, String command, String commit) {
        List<Case> cases = markings.stream().flatMap(marking -> of(marking).stream()).toList();
        return cases.isEmpty() ? Optional.empty() : Optional.of(new Calibrating(cases).calibration(command, commit));
    }

    /** A single name of the library that a fit found: a force that nobody measured is named without one, and leaves what there was. */
    private static Optional<Case> of(Marking marking) {
        ProofAnswer answer = marking.answer();
        boolean single = answer.missing().size() == 1 && !answer.verdict().equals("unexplained") && marking.truth().concealed().size() == 1
                && !answer.missing().get(0).mechanism().equals(ProofAnswer.LEARNED) && answer.missing().get(0).left() < answer.before();
        if (!single) {
            return Optional.empty();
        }
        ProofAnswer.Name first = answer.missing().get(0);
        List<ProofAnswer.Name> rivals = answer.alternatives();
        // Nothing, and what is in no library, move the model's numbers as the name does.
        double[] left = Stream.concat(Stream.of(first.left(), answer.before(), 1 + Calibration.unlisted(answer.before() - 1)),
                rivals.stream().map(ProofAnswer.Name::left)).mapToDouble(Double::doubleValue).toArray();
        double[] numbers = Stream.concat(Stream.of(first.numbers(), first.numbers(), first.numbers()),
                rivals.stream().map(ProofAnswer.Name::numbers)).mapToDouble(Double::doubleValue).toArray();
        boolean right = marking.mark() == Marking.Mark.RIGHT || marking.mark() == Marking.Mark.IN_SET && marking.parts() > 0
                && first.mechanism().equals(marking.truth().concealed().get(0).mechanism());
        return Optional.of(new Case(left, numbers, right));
    }

    private Calibration calibration(String command, String commit) {
        PointValuePair best = new SimplexOptimizer(1e-8, 1e-8).optimize(new MaxEval(TRIES), GoalType.MAXIMIZE, new InitialGuess(START),
                new NelderMeadSimplex(START.length, STEP),
                new ObjectiveFunction(
                        logs -> score(new Calibration(Math.exp(logs[0]), Math.exp(logs[1]), 0.5, NULLS, cases.size(), 0, "", ""))));
        double forms = Math.exp(best.getPoint()[0]);
        double chance = Math.exp(best.getPoint()[1]);
        Calibration sharp = new Calibration(forms, chance, 0.5, NULLS, cases.size(), best.getValue(), command, commit);
        List<Case> firm = cases.stream().filter(each -> each.probability(sharp) >= FIRM).toList();
        double lapse = (firm.stream().filter(each -> !each.right()).count() + 1.0) / (firm.size() + 2.0);
        return new Calibration(forms, chance, lapse, NULLS, cases.size(), best.getValue(), command, commit);
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
