package wbv.identify;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Which orders a recording supports: every candidate is fitted, and Schwarz's criterion decides.
 *
 * @param tried all candidates that could be fitted, best first
 */
public record OrderSelection(List<Candidate> tried) {

    /**
     * A candidate.
     *
     * @param orders
     * @param fit
     * @param criterion Schwarz's [1], the lower the better
     */
    public record Candidate(Orders orders, ArmaxFit fit, double criterion) {}

    public OrderSelection {
        tried = List.copyOf(tried);
        if (tried.isEmpty()) {
            throw new IllegalArgumentException("none of the orders fits so few samples");
        }
    }

    /** The orders chosen. */
    public Candidate best() {
        return tried.get(0);
    }

    /** Tries orders; those that need more samples are passed over. */
    public static OrderSelection among(List<Orders> candidates, Samples samples) {
        List<Candidate> tried = new ArrayList<>();
        for (Orders orders : candidates) {
            PredictionError method = new PredictionError(orders);
            if (samples.length() >= method.fewest(samples.inputs())) {
                ArmaxFit fit = method.fit(samples);
                tried.add(new Candidate(orders, fit, fit.schwarz()));
            }
        }
        tried.sort(Comparator.comparingDouble(Candidate::criterion));
        return new OrderSelection(tried);
    }
}
