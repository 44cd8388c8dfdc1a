package wbv.signal;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Which other motion, of several recorded, an output follows where its own inputs do not make it.
 *
 * <p>At a bin it is the one of highest partial coherence with the output, what the inputs explain taken out of both, if that is
 * more than chance gives any of them in 5 % of cases: where nothing is related it is Beta(1, n - m - 1), n independent averages, m
 * inputs. (Bendat and Piersol, Random Data, 2010, chapter 7.) Motions that move together all show; the highest is no proof that it
 * is the cause.
 */
public final class OtherCauses {

    private static final double RARE = 0.05;

    /**
     * The motion named most often.
     *
     * @param partial median partial coherence where it is named
     * @param bins where it is named
     */
    public record Likeliest(int candidate, double partial, int bins) {}

    private final int[] named;
    private final double[] partial;
    private final int candidates;
    private final int asked;

    /**
     * Looks for other causes.
     *
     * @param spectra of the inputs first, then of the candidates, the output last
     * @param inputs  how many of the channels are inputs, at least 1
     * @param backing of the output's responses. Not modified.
     */
    public static OtherCauses of(SpectralMatrix spectra, int inputs, Backing[] backing) {
        return new OtherCauses(spectra, inputs, backing);
    }

    private OtherCauses(SpectralMatrix spectra, int inputs, Backing[] backing) {
        candidates = spectra.channels() - inputs - 1;
        named = new int[backing.length];
        Arrays.fill(named, -1);
        partial = new double[backing.length];
        Arrays.fill(partial, Double.NaN);
        asked = (int) Arrays.stream(backing).filter(Backing.NOT_CAUSED::equals).count();
        double free = spectra.independent() - inputs - 1;
        if (candidates < 1 || asked == 0 || !(free > 0)) {
            return;
        }
        double least = 1 - Math.pow(RARE / candidates, 1 / free);
        int[] chosen = IntStream.range(0, inputs + 2).toArray();
        chosen[inputs + 1] = spectra.channels() - 1;
        for (int c = 0; c < candidates; c++) {
            chosen[inputs] = inputs + c;
            double[] own = ResponseMatrix.of(spectra.only(chosen), inputs + 1, FrequencyResponse.Excited.USUAL)
                    .partialCoherence(0, inputs);
            for (int k = 0; k < named.length; k++) {
                if (backing[k] == Backing.NOT_CAUSED && own[k] >= least && (named[k] < 0 || own[k] > partial[k])) {
                    named[k] = c;
                    partial[k] = own[k];
                }
            }
        }
    }

    /** Index of the candidate that is named at each bin; -1 where none is, or none is asked for. */
    public int[] named() {
        return named;
    }

    /** Its partial coherence by bin; NaN where none is named. */
    public double[] partial() {
        return partial;
    }

    /** The candidate that is named most often, if any is named at more bins than chance names, see {@link Backing#isBeyondChance}. */
    public Optional<Likeliest> likeliest() {
        int any = (int) Arrays.stream(named).filter(c -> c >= 0).count();
        if (!Backing.isBeyondChance(any, asked)) {
            return Optional.empty();
        }
        int[] count = new int[candidates];
        Arrays.stream(named).filter(c -> c >= 0).forEach(c -> count[c]++);
        int best = 0;
        for (int c = 1; c < candidates; c++) {
            best = count[c] > count[best] ? c : best;
        }
        int most = best;
        double[] values = IntStream.range(0, named.length).filter(k -> named[k] == most).mapToDouble(k -> partial[k]).sorted()
                .toArray();
        return Optional.of(new Likeliest(best, values[values.length / 2], count[best]));
    }
}
