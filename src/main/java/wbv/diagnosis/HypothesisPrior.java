package wbv.diagnosis;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * How likely each hypothesis is before the data are seen: families of the library are equally likely, sensors no less than physics, and so are the
 * places and forms of a family.
 */
final class HypothesisPrior {

    private final Priors priors;
    private final Map<String, Long> alternatives;
    private final int families;

    /** @param library every hypothesis that could be asked @param beside families that are asked in another way than by a hypothesis */
    HypothesisPrior(Priors priors, Collection<Hypothesis> library, Set<String> beside) {
        this.priors = priors;
        alternatives = library.stream().collect(Collectors.groupingBy(Hypothesis::mechanism, Collectors.counting()));
        Set<String> all = new TreeSet<>(beside);
        all.addAll(alternatives.keySet());
        families = all.size();
    }

    /** Of the model as given, and of the model with values of its own. */
    double noPhysics() {
        return priors.noPhysics() / 2;
    }

    /** Of mechanisms that act together. */
    double named(List<Hypothesis> parts) {
        double p = (1 - priors.noPhysics()) * Math.pow(priors.further(), parts.size() - 1);
        for (Hypothesis part : parts) {
            p /= families * (double) alternatives.getOrDefault(part.mechanism(), 1L);
        }
        return p;
    }

    /** Of a member of a family that is asked in another way. @param members places of that family */
    double beside(int members) {
        return (1 - priors.noPhysics()) / families / members;
    }

    /** Of something else at one place. */
    double free() {
        return (1 - priors.noPhysics()) * priors.freePlace() / families;
    }

    /** Of something else beside mechanisms, at the place of one. */
    double freeBeside(List<Hypothesis> parts) {
        return named(parts) * priors.freePlace();
    }
}
