package wbv.body.simulate;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.Optional;
import java.util.function.Supplier;
import wbv.body.Structure;

/**
 * The last structures that were solved at the lines of an excitation, so that what asks again for one of them, such as one hypothesis after
 * the other on the same linear part, need not solve it again. For several threads.
 */
final class SolvedLines {

    /** One that is fitted and the one that stands for it in noise. */
    private static final int KEPT = 2;

    private final Deque<Solved> kept = new ArrayDeque<>();

    /**
     * A solved structure.
     *
     * @param stiffness dynamic stiffness by link, spectra. Not copied, not to be modified
     * @param inverse   Z⁻¹ as n·n spectra, symmetric: entry (i, j) at i n + j. Likewise
     */
    record Solved(Structure structure, double[][] stiffness, double[][] inverse) {

        private boolean isOf(Structure other) {
            return structure.held() == other.held() && structure.kinematics().equals(other.kinematics())
                    && Arrays.equals(structure.stiffness(), other.stiffness())
                    && Arrays.equals(structure.damping(), other.damping()) && Arrays.equals(structure.mass(), other.mass());
        }
    }

    /** A structure's lines, solved where they are not kept. */
    Solved of(Structure structure, Supplier<Solved> solve) {
        return find(structure).orElseGet(() -> keep(solve.get()));
    }

    private synchronized Optional<Solved> find(Structure structure) {
        return kept.stream().filter(each -> each.isOf(structure)).findFirst();
    }

    private synchronized Solved keep(Solved solved) {
        kept.addFirst(solved);
        if (kept.size() > KEPT) {
            kept.removeLast();
        }
        return solved;
    }
}
