package wbv.proof;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * One answer marked.
 *
 * @param mark  how good it was
 * @param place whether the right place was given, whatever the name
 * @param family whether a mechanism of the right family was named at the right place
 * @param held  probability at which the first name was held; NaN where nothing was named
 * @param correlation of the force that the answer adds with the one that was concealed; NaN where one of them is not known, or it is
 *                    elsewhere
 * @param parts of a pair that were found
 * @param spurious names that are not among what was concealed
 */
record Marking(Suite.Question question, Truth truth, ProofAnswer answer, Mark mark, boolean place, boolean family, double held,
        int parts, int spurious, double correlation) {

    /** How good an answer is. */
    enum Mark {
        /** Mechanism and place, or rightly silent, or rightly unknown. */
        RIGHT,
        /** Called ambiguous, and the truth is one of the two named. */
        IN_SET,
        /** The mechanism, elsewhere. */
        ELSEWHERE,
        /** Another mechanism. */
        WRONG,
        /** Refused although it is in the library, or named nothing that fits. */
        UNKNOWN,
        /** Silent although something is missing. */
        SILENT,
        /** No answer. */
        FAILED
    }

    private static final Map<String, String> FAMILIES = Map.of("hysteresis", "dry", "friction.coulomb", "dry",
            "memory.viscoelastic", "memory", "muscle.reflex", "memory", "contact.bumpstop", "one-sided", "contact.loss", "one-sided",
            "stiffness.asymmetric", "one-sided", "drift.step", "drift", "drift.slow", "drift");

    static Marking of(Suite.Question question, Truth truth, ProofAnswer answer) {
        return of(question, truth, answer, Optional.empty());
    }

    /** @param force that was concealed; for laws that are to be learned */
    static Marking of(Suite.Question question, Truth truth, ProofAnswer answer, Optional<ForceMatch> force) {
        List<ProofAnswer.Name> named = named(answer);
        double held = named.isEmpty() ? Double.NaN : named.get(0).probability();
        List<Truth.Concealed> concealed = truth.concealed();
        int parts = (int) concealed.stream().filter(c -> named.stream().anyMatch(n -> same(truth, c, n))).count();
        int spurious = (int) named.stream().filter(n -> concealed.stream().noneMatch(c -> same(truth, c, n))).count();
        boolean family = !concealed.isEmpty() && named.stream().anyMatch(n -> truth.samePlace(concealed.get(0).where(), n.where())
                && family(n.mechanism()).equals(family(concealed.get(0).mechanism())));
        boolean place = !concealed.isEmpty() && place(answer, named).stream().anyMatch(w -> truth.samePlace(concealed.get(0).where(), w));
        boolean none = answer.verdict().equals(ProofAnswer.FAILED)
                || answer.verdict().equals(ProofAnswer.REFUSED) && question.group() != Suite.Group.UNRELATED;
        Mark mark = none ? Mark.FAILED : switch (question.kind()) {
            // Whatever is named, in whatever words, is wrong.
            case UNRELATED -> silent(answer) ? Mark.SILENT : answer.missing().isEmpty() ? Mark.RIGHT : Mark.WRONG;
            case NOTHING -> silent(answer) ? Mark.RIGHT : refused(answer) ? Mark.UNKNOWN : Mark.WRONG;
            case OPEN -> silent(answer) ? Mark.SILENT : answer.verdict().equals("unexplained") || learned(answer) ? Mark.RIGHT
                    : refused(answer) ? Mark.UNKNOWN : Mark.WRONG;
            case UNLISTED -> refused(answer) || learned(answer) || parts == 1 && spurious == 0 ? Mark.RIGHT : silent(answer) ? Mark.SILENT
                    : Mark.WRONG;
            default -> mark(truth, answer, named, parts, spurious);
        };
        double correlation = force.flatMap(f -> answer.force().filter(a -> concealed.stream().anyMatch(c -> c.where().equals(a.where())))
                .map(a -> f.correlation(a, truth.band().get(0), truth.band().get(1)))).orElse(Double.NaN);
        return new Marking(question, truth, answer, mark, place, family, held, parts, spurious, correlation);
    }

    private static Mark mark(Truth truth, ProofAnswer answer, List<ProofAnswer.Name> named, int parts, int spurious) {
        int wanted = truth.concealed().size();
        if (silent(answer)) {
            return Mark.SILENT;
        }
        if (refused(answer) || learned(answer)) {
            return Mark.UNKNOWN;
        }
        if (answer.verdict().equals("ambiguous")) {
            List<ProofAnswer.Name> set = new ArrayList<>(named);
            answer.alternatives().stream().limit(1).forEach(set::add);
            return truth.concealed().stream().allMatch(c -> set.stream().anyMatch(n -> same(truth, c, n))) ? Mark.IN_SET
                    : Mark.WRONG;
        }
        if (parts == wanted && spurious == 0) {
            return Mark.RIGHT;
        }
        boolean mechanism = wanted == 1 && named.stream().anyMatch(n -> n.mechanism().equals(truth.concealed().get(0).mechanism()));
        return mechanism && parts == 0 ? Mark.ELSEWHERE : Mark.WRONG;
    }

    /** Named, alone or in a set of two. */
    boolean good() {
        return mark == Mark.RIGHT || mark == Mark.IN_SET;
    }

    /** Part of the held-out excess over the noise that the answer's model removes. */
    double removed() {
        return (answer.heldBefore() - answer.heldAfter()) / Math.max(1e-9, answer.heldBefore() - 1);
    }

    /** Whether the answer's law has the terms of the one that was concealed; empty where one of them does not say. */
    Optional<Boolean> terms() {
        return truth.concealed().size() == 1 ? answer.force().flatMap(f -> ComparedTerm.same(truth.concealed().get(0).law(), f.terms()))
                : Optional.empty();
    }

    /** What an answer claims of the library; a refusal claims nothing, and what was learned is not of it. */
    private static List<ProofAnswer.Name> named(ProofAnswer answer) {
        return refused(answer) ? List.of()
                : answer.missing().stream().filter(name -> !name.mechanism().equals(ProofAnswer.LEARNED)).toList();
    }

    /** The place an answer points to: of its first name, or of the best latent signal, or of the best rival. */
    private static List<String> place(ProofAnswer answer, List<ProofAnswer.Name> named) {
        if (!named.isEmpty() && !learned(answer)) {
            return named.stream().map(ProofAnswer.Name::where).toList();
        }
        if (learned(answer)) {
            return List.of(answer.missing().get(0).where());
        }
        Optional<String> first = answer.latent().stream().findFirst()
                .or(() -> answer.missing().stream().map(ProofAnswer.Name::where).findFirst())
                .or(() -> answer.alternatives().stream().map(ProofAnswer.Name::where).findFirst());
        return first.map(List::of).orElse(List.of());
    }

    private static boolean same(Truth truth, Truth.Concealed concealed, ProofAnswer.Name name) {
        // A hand that pushes is in no library by name, but a force that nobody measured is what it is.
        boolean hand = concealed.mechanism().equals("unknown") && concealed.form().startsWith("hand")
                && name.mechanism().equals("input.unmeasured");
        return (hand || concealed.mechanism().equals(name.mechanism())) && (concealed.mechanism().equals("input.unmeasured")
                ? truth.samePlace(concealed.where(), name.where()) : truth.sameWords(concealed.where(), name.where()));
    }

    private static boolean silent(ProofAnswer answer) {
        return answer.verdict().equals("nothing-missing") || answer.verdict().equals("parameters-only");
    }

    static boolean refused(ProofAnswer answer) {
        return answer.verdict().equals("unexplained") || answer.verdict().equals("cannot-tell");
    }

    /** Called in no library, with a law that was learned at a place. */
    static boolean learned(ProofAnswer answer) {
        return answer.verdict().equals(ProofAnswer.LEARNED_LAW)
                && answer.missing().stream().limit(1).anyMatch(n -> n.mechanism().equals(ProofAnswer.LEARNED));
    }

    static String family(String mechanism) {
        return FAMILIES.getOrDefault(mechanism, mechanism);
    }
}
