package wbv.diagnosis.measured;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import wbv.body.Model;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Leaps;
import wbv.recording.Recording;

/**
 * What a diagnosis judges of a long recording: pieces of one length, evenly spread over it, laid end to end. More samples than these would
 * tell numbers more finely than any model of a body holds, and take hours. Each piece keeps its time, so that what changes through the
 * recording shows; what a body was doing when one begins dies down before its outputs count.
 *
 * @param recording  the pieces, with what lies between them lost
 * @param provedFrom time on the clock of the pieces from which on they serve for the proof only [s]; empty for their last part
 * @param sentence   what was taken, for the user
 */
public record Excerpts(Recording recording, OptionalDouble provedFrom, String sentence) {

    /**
     * Readings, which are samples times outputs, that are judged of a recording: half an hour of five sensors at a sitter's rate. A fit holds
     * some 2.5 kB of each, derivatives to all numbers included, so they fit in half a gigabyte.
     */
    static final int READINGS = 1 << 17;
    /** Pieces at most: a change through the recording is seen at as many moments. */
    private static final int MOST = 12;
    /** Part of an amplitude that is left when a piece's outputs begin to count [1]: less than the sensors' noise is of it. */
    private static final double LEFT = 1e-3;
    /** Part of a piece that may pass until then [1]. */
    private static final double MOST_SETTLING = 0.1;
    /** Lost samples that nothing bridges. */
    private static final int LEAST_PAUSE = 4;

    /**
     * Pieces of a recording; empty where it is no longer than they would be, or has to be judged in one, since something in it goes on as it
     * was sent.
     *
     * @param provedFrom see {@link wbv.diagnosis.Question#provedFrom}
     */
    public static Optional<Excerpts> of(Model model, Recording recording, OptionalDouble provedFrom) {
        double rate = recording.clock().rate();
        double judged = model.isRig() ? rate : Math.min(rate, SitterRate.USUAL);
        double budget = rate / judged * READINGS / Math.max(1, model.outputs().size());
        double settling = model.driven() ? 0 : -Math.log(LEFT) / model.assembly().structure().slowestDecay();
        int pause = (int) Math.max(LEAST_PAUSE, Math.min(recording.length(), Math.ceil(settling * rate)));
        int pieces = (int) Math.min(MOST, budget * MOST_SETTLING / pause);
        if (recording.length() <= budget || pieces < 2) {
            return Optional.empty();
        }
        int length = (int) (budget / pieces) - pause;
        int split = provedFrom.isPresent() ? (int) recording.clock().nearest(provedFrom.getAsDouble()) : recording.length();
        // As many of a proof as there would be without it.
        int fitted = provedFrom.isEmpty() ? pieces : Math.max(1, (int) Math.round(Measured.FIT_SHARE * pieces));
        List<int[]> spans = new ArrayList<>(spread(0, split, fitted, length));
        int proof = spans.size();
        spans.addAll(spread(split, recording.length(), pieces - fitted, length));
        Laid laid = new Laid(recording, spans, model.driven() ? Set.of() : Set.copyOf(model.outputs()), pause);
        Recording joined = laid.recording();
        return Optional.of(new Excerpts(joined,
                provedFrom.isPresent() ? OptionalDouble.of(joined.clock().time(laid.begin(proof))) : OptionalDouble.empty(),
                said(recording, spans)));
    }

    /** From where to where each of some pieces goes, evenly spread over a stretch; the stretch itself where it is no longer than they. */
    private static List<int[]> spread(int from, int to, int pieces, int length) {
        if (to - from <= (long) pieces * length) {
            return to > from ? List.of(new int[] {from, to}) : List.of();
        }
        List<int[]> out = new ArrayList<>();
        for (int piece = 0; piece < pieces; piece++) {
            int begin = pieces == 1 ? from : from + (int) ((long) piece * (to - from - length) / (pieces - 1));
            out.add(new int[] {begin, begin + length});
        }
        return out;
    }

    private static String said(Recording recording, List<int[]> spans) {
        double rate = recording.clock().rate();
        double judged = spans.stream().mapToDouble(span -> span[1] - span[0]).sum() / rate;
        return String.format(Locale.ROOT, "Of %.4g min of recording %.3g min were judged, in %d pieces evenly spread over it.",
                recording.duration() / 60, judged / 60, spans.size());
    }

    /**
     * Pieces laid end to end.
     *
     * @param spans   from where to where each goes
     * @param settling channels of which the beginning of a piece does not count
     * @param pause   samples between two, and at the beginning of a piece
     */
    private record Laid(Recording whole, List<int[]> spans, Set<Channel> settling, int pause) {

        /** First sample of a piece. */
        int begin(int piece) {
            return spans.subList(0, piece).stream().mapToInt(span -> span[1] - span[0] + pause).sum();
        }

        Recording recording() {
            Map<Channel, double[]> values = new LinkedHashMap<>();
            whole.channels().forEach(channel -> values.put(channel, laid(whole.values(channel), settling.contains(channel))));
            double rate = whole.clock().rate();
            List<Leaps.Leap> leaps = new ArrayList<>();
            for (int piece = 0; piece < spans.size(); piece++) {
                double later = whole.elapsed(spans.get(piece)[0]) - begin(piece) / rate;
                if (later > 0) {
                    leaps.add(new Leaps.Leap(begin(piece), later));
                }
            }
            return new Recording(new Clock(whole.clock().start(), rate), values, whole.metadata(), new Leaps(leaps));
        }

        private double[] laid(double[] x, boolean settles) {
            double[] out = new double[begin(spans.size()) - pause];
            Arrays.fill(out, Double.NaN);
            for (int piece = 0; piece < spans.size(); piece++) {
                int[] span = spans.get(piece);
                // A recording's own beginning is as it was: bodies at rest, or what is done with it everywhere.
                int unsettled = settles && span[0] > 0 ? Math.min(pause, span[1] - span[0]) : 0;
                System.arraycopy(x, span[0] + unsettled, out, begin(piece) + unsettled, span[1] - span[0] - unsettled);
            }
            return out;
        }
    }
}
