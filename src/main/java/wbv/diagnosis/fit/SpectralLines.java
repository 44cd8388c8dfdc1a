package wbv.diagnosis.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/** Frequencies at which a whitened residual stands out from its neighbourhood: what a steady force leaves behind. */
public final class SpectralLines {

    private static final int NEIGHBOURS = 40;
    private static final int LOOKED_AT = 12;
    private static final int MOST = 3;
    private static final double APART = 0.3;
    /** Among ten thousand lines of noise in two or more outputs none is as strong, beside the median. */
    private static final double OUTSTANDING = 20;

    private SpectralLines() {}

    /**
     * The frequencies.
     *
     * @param residual whitened, by line. Not modified.
     * @return as many as stand out, up to three frequencies [Hz], the most outstanding first
     */
    public static double[] of(double[] residual, Window window) {
        double[] prominence = prominence(residual, window);
        List<Integer> order = IntStream.range(0, prominence.length).boxed().sorted(Comparator.comparingDouble(i -> -prominence[i]))
                .limit(LOOKED_AT).toList();
        List<Double> found = new ArrayList<>();
        for (int line : order) {
            double f = window.frequency(line);
            if (found.size() < MOST && found.stream().allMatch(other -> Math.abs(other - f) > APART)) {
                found.add(f);
            }
        }
        return found.stream().mapToDouble(Double::doubleValue).toArray();
    }

    /**
     * Whether any line stands out as no noise's does.
     *
     * @param residual whitened, by line. Not modified.
     */
    public static boolean standOut(double[] residual, Window window) {
        return Arrays.stream(prominence(residual, window)).anyMatch(p -> p > OUTSTANDING);
    }

    /** Power of each line over the median of its neighbours'. */
    private static double[] prominence(double[] residual, Window window) {
        int lines = window.lines();
        double[] power = new double[lines];
        for (int i = 0; i < residual.length; i += 2) {
            power[i / 2 % lines] += residual[i] * residual[i] + residual[i + 1] * residual[i + 1];
        }
        double[] prominence = new double[lines];
        for (int line = 0; line < lines; line++) {
            double[] near = Arrays.copyOfRange(power, Math.max(0, line - NEIGHBOURS), Math.min(lines, line + NEIGHBOURS));
            Arrays.sort(near);
            prominence[line] = power[line] / Math.max(near[near.length / 2], 1e-300);
        }
        return prominence;
    }
}
