package wbv.state;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Probabilities that were said, and whether it came so. */
public final class Reliability {

    private static final int BINS = 10;

    private final List<Said> said = new ArrayList<>();

    private record Said(double probability, boolean came) {}

    /**
     * A tenth of the range of probabilities.
     *
     * @param said mean probability
     * @param came share that came
     * @param count in it
     */
    public record Bin(double said, double came, int count) {}

    /** Takes a probability that was said, and whether it came so; NaN is left out. */
    public void add(double probability, boolean came) {
        if (!Double.isNaN(probability)) {
            said.add(new Said(probability, came));
        }
    }

    /** Probabilities taken. */
    public int count() {
        return said.size();
    }

    /** Share that came. */
    public double base() {
        return said.stream().filter(Said::came).count() / (double) said.size();
    }

    /** Area under the receiver operating characteristic: Mann and Whitney's U, ties halved, 0 to 1. NaN if all or none came. */
    public double area() {
        List<Said> sorted = said.stream().sorted(Comparator.comparingDouble(Said::probability)).toList();
        double ranks = 0;
        long came = 0;
        for (int i = 0; i < sorted.size();) {
            int end = i;
            while (end < sorted.size() && sorted.get(end).probability() == sorted.get(i).probability()) {
                end++;
            }
            for (int j = i; j < end; j++) {
                if (sorted.get(j).came()) {
                    ranks += (i + end + 1) / 2.0;
                    came++;
                }
            }
            i = end;
        }
        return (ranks - came * (came + 1) / 2.0) / (came * (double) (sorted.size() - came));
    }

    /** Tenths of probability that are not empty. */
    public List<Bin> bins() {
        List<Bin> bins = new ArrayList<>();
        for (int b = 0; b < BINS; b++) {
            int bin = b;
            List<Said> in = said.stream().filter(each -> Math.min(BINS - 1, (int) (each.probability() * BINS)) == bin).toList();
            if (!in.isEmpty()) {
                bins.add(new Bin(in.stream().mapToDouble(Said::probability).average().orElseThrow(),
                        in.stream().filter(Said::came).count() / (double) in.size(), in.size()));
            }
        }
        return bins;
    }

    /** Expected calibration error, as a probability: what bins are off, weighted by how many they hold. */
    public double calibrationError() {
        return bins().stream().mapToDouble(bin -> Math.abs(bin.said() - bin.came()) * bin.count()).sum() / said.size();
    }
}
