package wbv.diagnosis;

import java.util.ArrayList;
import java.util.List;
import wbv.diagnosis.search.Priors;

/** Reads a verdict off a posterior, and nothing else. */
final class DecisionRule {

    /** What a posterior says. */
    enum Verdict { NOTHING_MISSING, PARAMETERS_ONLY, MISSING_PHYSICS, AMBIGUOUS, SOMETHING_ELSE }

    /**
     * @param claims what is answered, likeliest first; their probabilities are the posterior's
     * @param probability of all of them together
     */
    record Reading(Verdict verdict, List<Claim> claims, double probability) {

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
     * Nothing missing, or values only, where physics is no likelier than none; one name where it holds enough; something else where that is
     * likelier than not; otherwise the fewest claims that hold enough together. A claim from which the first is told apart, by odds at
     * which one name of two would hold enough, is none of them, however many such there are.
     */
    static Reading read(Posterior posterior) {
        if (posterior.mass(claim -> !claim.isPhysics()) >= Priors.MAJORITY) {
            boolean given = posterior.of(Claim.NOTHING) >= posterior.of(Claim.VALUES);
            return new Reading(given ? Verdict.NOTHING_MISSING : Verdict.PARAMETERS_ONLY, List.of(given ? Claim.NOTHING : Claim.VALUES),
                    posterior.mass(claim -> !claim.isPhysics()));
        }
        double other = posterior.mass(claim -> claim.kind() == Claim.Kind.ELSE);
        List<Claim> elsewhere = posterior.ranked().stream().filter(claim -> claim.kind() == Claim.Kind.ELSE).toList();
        return other >= Priors.MAJORITY ? new Reading(Verdict.SOMETHING_ELSE, elsewhere, other) : fewest(posterior);
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
        return new Reading(named ? Verdict.MISSING_PHYSICS : Verdict.AMBIGUOUS, List.copyOf(set), held);
    }
}
