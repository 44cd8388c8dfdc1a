package wbv.diagnosis;

import wbv.diagnosis.mechanism.Library;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import wbv.diagnosis.mechanism.Hypothesis;

/** Families are alike whatever their size, and the library and what is beside it hold all of the probability that physics has. */
class HypothesisPriorTest {

    private static Hypothesis of(String mechanism, String where) {
        return new Hypothesis(Library.standard().of(mechanism).orElseThrow(), where, "", List.of(), List.of(), List.of());
    }

    @Test
    void familiesShareAlike() {
        List<Hypothesis> library = List.of(of("friction.coulomb", "a"), of("friction.coulomb", "b"), of("friction.coulomb", "c"), of("sensor.gain", "a"));
        HypothesisPrior prior = new HypothesisPrior(Priors.USUAL, library, Set.of("input.unmeasured"));
        double friction = library.subList(0, 3).stream().mapToDouble(h -> prior.named(List.of(h))).sum();
        assertEquals(0.5 / 3, friction, 1e-15);
        assertEquals(friction, prior.named(List.of(library.get(3))), 1e-15);
        assertEquals(friction, 2 * prior.beside(2), 1e-15);
        assertEquals(0.5, friction + prior.named(List.of(library.get(3))) + 2 * prior.beside(2), 1e-15);
        assertEquals(0.5, 2 * prior.noPhysics(), 1e-15);
        assertEquals(friction / 10, prior.free(), 1e-15);
        assertEquals(0.1 * 0.5 / 3 / 3 / 3, prior.named(List.of(library.get(0), library.get(3))), 1e-15);
        assertEquals(prior.named(library.subList(0, 1)) / 10, prior.freeBeside(library.subList(0, 1)), 1e-15);
    }
}
