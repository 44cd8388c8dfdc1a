package wbv.diagnosis;

import java.util.ArrayList;
import java.util.List;
import wbv.diagnosis.search.Priors;

/** Reads a verdict off a posterior, and nothing else. */
final class DecisionRule {

    /** What a posterior says. */
    enum Verdict { PARAMETERS_ONLY, MISSING_PHYSICS, AMBIGUOUS, SOMETHING_ELSE }

    /** @param claims what is answered, likeliest first; their probabilities are the posterior's */
    record Reading(Verdict verdict, List<Claim> claims) {

        /** Whether no name is the answer, nor a set of which one is. */
        boolean isUnknown() {
            return names() == 0;
        }

        /** How many names of the library the answer holds. */
        long names() {
            return claims.stream().filter(claim -> claim.kind() == Claim.Kind.NAMED).count();
        }
    }

    private static final double ROUNDING = 1e-9;

    private DecisionRule() {}

    /**
     * Values only where physics is no likelier than none; something else where that is likelier than not; one name where it holds enough;
     * otherwise the fewest claims that hold enough together. A claim from which the first is told apart, by odds at
     * which one name of two would hold enough, is none of them, however many such there are.
     */
    static Reading read(Posterior posterior) {
        return posterior.of(Claim.VALUES) >= Priors.MAJORITY ? new Reading(Verdict.PARAMETERS_ONLY, List.of(Claim.VALUES))
                : posterior.of(Claim.UNKNOWN) >= Priors.MAJORITY ? new Reading(Verdict.SOMETHING_ELSE, List.of(Claim.UNKNOWN))
                        : fewest(posterior);
    }

    private static Reading fewest(Posterior posterior) {
        List<Claim> set = new ArrayList<>();
        double held = 0;
        double near = posterior.of(posterior.ranked().get(0)) * Priors.ODDS;
        for (Claim claim : posterior.ranked()) {
            if (held < Priors.HELD - ROUNDING && posterior.of(claim) > near) {
                set.add(claim);
                held += posterior.of(claim);
            }
        }
        boolean named = set.size() == 1 && set.get(0).kind() == Claim.Kind.NAMED;
        return new Reading(named ? Verdict.MISSING_PHYSICS : Verdict.AMBIGUOUS, List.copyOf(set));
    }
}
