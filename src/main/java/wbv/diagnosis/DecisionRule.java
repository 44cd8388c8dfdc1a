package wbv.diagnosis;

import java.util.ArrayList;
import java.util.List;
import wbv.diagnosis.search.Priors;

/** Reads a verdict off a posterior, and nothing else. */
final class DecisionRule {

    /** @param claims what is answered, likeliest first; their probabilities are the posterior's */
    record Reading(List<Claim> claims) {

        /** Whether one name is the answer. */
        boolean isName() {
            return claims.size() == 1 && !isUnknown();
        }

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
     * Values only where physics is no likelier than none; something else where that is likelier than not; otherwise the fewest claims that
     * hold enough together. A claim from which the first is told apart, by odds at which one name of two would hold enough, is none of
     * them, however many such there are.
     */
    static Reading read(Posterior posterior) {
        return posterior.of(Claim.VALUES) >= Priors.MAJORITY ? new Reading(List.of(Claim.VALUES))
                : posterior.of(Claim.UNKNOWN) >= Priors.MAJORITY ? new Reading(List.of(Claim.UNKNOWN)) : fewest(posterior);
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
        return new Reading(List.copyOf(set));
    }
}
