package wbv.diagnosis;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import wbv.signal.LogSum;

/**
 * How likely each claim is once the data are seen: {@code π Z}, over all claims together 1.
 *
 * @param probabilities by claim, likeliest first
 */
record Posterior(Map<Claim, Double> probabilities) {

    Posterior {
        Map<Claim, Double> sorted = new LinkedHashMap<>();
        probabilities.entrySet().stream().sorted(Map.Entry.<Claim, Double>comparingByValue(Comparator.reverseOrder())
                .thenComparing(entry -> entry.getKey().kind()).thenComparing(entry -> entry.getKey().name()))
                .forEach(entry -> sorted.put(entry.getKey(), entry.getValue()));
        double sum = sorted.values().stream().mapToDouble(Double::doubleValue).sum();
        if (!(Math.abs(sum - 1) < 1e-9)) {
            throw new IllegalArgumentException("probabilities must add up to 1: " + sum);
        }
        probabilities = java.util.Collections.unmodifiableMap(sorted);
    }

    /**
     * A hypothesis that was weighed.
     *
     * @param prior probability before the data, 0 or more
     * @param evidence log of it
     */
    record Weighed(Claim claim, double prior, double evidence) {}

    /** Of hypotheses, of which several may make the same claim. */
    static Posterior of(List<Weighed> all) {
        double[] logs = all.stream().mapToDouble(one -> Math.log(one.prior()) + one.evidence()).toArray();
        double sum = LogSum.of(logs, logs.length);
        Map<Claim, Double> out = new LinkedHashMap<>();
        for (int i = 0; i < logs.length; i++) {
            out.merge(all.get(i).claim(), Math.exp(logs[i] - sum), Double::sum);
        }
        return new Posterior(out);
    }

    /** The same where a part of the probability belongs to one claim, whatever the evidence. */
    Posterior but(double part, Claim claim) {
        Map<Claim, Double> out = new LinkedHashMap<>();
        probabilities.forEach((each, p) -> out.put(each, (1 - part) * p));
        out.merge(claim, part, Double::sum);
        return new Posterior(out);
    }

    double of(Claim claim) {
        return probabilities.getOrDefault(claim, 0.0);
    }

    /** How likely any of some claims is. */
    double mass(Predicate<Claim> claims) {
        return probabilities.entrySet().stream().filter(entry -> claims.test(entry.getKey())).mapToDouble(Map.Entry::getValue).sum();
    }

    /** Claims from the likeliest down. */
    List<Claim> ranked() {
        return List.copyOf(probabilities.keySet());
    }
}
