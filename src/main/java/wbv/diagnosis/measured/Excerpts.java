package wbv.diagnosis.measured;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.body.Model;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Leaps;
import wbv.recording.Recording;

/**
 * What a diagnosis judges of a long recording: pieces of one length, evenly spread over it, laid end to end. More samples than these
 * would tell numbers more finely than any model of a body holds, and take hours. Each piece keeps its time, so that what changes
 * through the recording shows; what a body was doing when one begins dies down before its outputs count ({@link Unseen}).
 *
 * @param recording  the pieces, with what lies between them lost
 * @param provedFrom time on the clock of the pieces from which on they serve for the proof only [s]; empty for their last part
 * @param sentence   what was taken, for the user
 */
public record Excerpts(Recording recording, OptionalDouble provedFrom, String sentence) {

    /**
     * Readings, which are samples times outputs, that are judged of a recording: seven minutes of five sensors at a sitter's rate. A fit
     * holds some 2.5 kB of each, derivatives to all numbers included: a third of a gigabyte.
     */
    private static final int READINGS = 1 << 17;
    /** A recording is judged whole that is no longer than so many times that: pieces lose what follows their beginnings. */
    private static final double WHOLE = 1.5;
    /** Part of a piece that may pass until its outputs count [1], an effort: with more there are more pieces, and less of each. */
    private static final double SETTLING = 0.1;
    /** Pieces at most: a change through the recording is seen at as many moments. */
    private static final int MOST = 12;

    /**
     * Pieces of a recording; empty where it is hardly longer than they would be, or has to be judged in one, since something in it goes on
     * as it was sent.
     *
     * @param provedFrom see {@link wbv.diagnosis.Question#provedFrom}
     */
    public static Optional<Excerpts> of(Model model, Recording recording, OptionalDouble provedFrom) {
        return of(model, recording, provedFrom, READINGS);
    }

    static Optional<Excerpts> of(Model model, Recording recording, OptionalDouble provedFrom, int readings) {
        double rate = recording.clock().rate();
        double judged = model.isRig() ? rate : Math.min(rate, SitterRate.USUAL);
        // Where forces may take other ways than a model's, beside a simulation, a fit holds twice as much.
        int series = Math.max(1, model.outputs().size() + Measured.beside(model).size());
        double budget = rate / judged * readings / series;
        int pause = (int) Math.max(Dropouts.BRIDGED + 1, Math.min(recording.length(), Math.ceil(Unseen.settling(model) * rate)));
        int pieces = (int) Math.min(MOST, budget * SETTLING / pause);
        if (recording.length() <= WHOLE * budget || pieces < 2) {
            return Optional.empty();
        }
        int length = (int) (budget / pieces) - pause;
        int split = provedFrom.isPresent() ? (int) recording.clock().nearest(provedFrom.getAsDouble()) : recording.length();
        // As many of a proof as there would be without it.
        int fitted = provedFrom.isEmpty() ? pieces : Math.max(1, (int) Math.round(Measured.FIT_SHARE * pieces));
        List<int[]> spans = new ArrayList<>(spread(0, split, fitted, length));
        int proof = spans.size();
        spans.addAll(spread(split, recording.length(), pieces - fitted, length));
        Laid laid = new Laid(recording, spans, pause);
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
     * @param spans from where to where each goes
     * @param pause samples between two
     */
    private record Laid(Recording whole, List<int[]> spans, int pause) {

        /** First sample of a piece. */
        int begin(int piece) {
            return spans.subList(0, piece).stream().mapToInt(span -> span[1] - span[0] + pause).sum();
        }

        Recording recording() {
            Map<Channel, double[]> values = new LinkedHashMap<>();
            whole.channels().forEach(channel -> values.put(channel, laid(whole.values(channel))));
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

        private double[] laid(double[] x) {
            double[] out = new double[begin(spans.size()) - pause];
            Arrays.fill(out, Double.NaN);
            for (int piece = 0; piece < spans.size(); piece++) {
                int[] span = spans.get(piece);
                System.arraycopy(x, span[0], out, begin(piece), span[1] - span[0]);
            }
            return out;
        }
    }
}
