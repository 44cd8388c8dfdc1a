package wbv.diagnosis.surrogate;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.stream.Stream;
import wbv.body.Model;
import wbv.diagnosis.fit.Parallel;
import wbv.recording.Channel;
import wbv.recording.Recording;

/**
 * Looks for the least arrangement of bodies and links that does what was measured: the measured bodies as their motion says or in a chain,
 * with a body or a link more as long as each halves what is missed, in another order where nothing else helps. Where none is found that
 * does all of it, the simulation is no such net, and what is missed says nothing of where bodies and links are missing: then it is taken
 * for what most are, a person who leans on a backrest, with soft parts that swing in the trunk and masses about the usual ones
 * ({@link MassPrior}).
 */
final class ChainSearch {

    /** An arrangement that misses more may have its bodies in another order. */
    private static final double POOR = 0.1;
    /** Orders of so many bodies are all tried. */
    private static final int MOST_ORDERED = 4;
    /** As much of a recording as arrangements are tried on: in time [s], and in samples at least. */
    private static final double PART = 30;
    private static final int FEWEST = 1536;
    /** As much as the last of them is fitted to, in samples: what was computed has no noise that more would lessen. */
    private static final int MOST = 1 << 15;

    private final Recording driven;
    private final Recording part;
    private final Channel input;
    private final List<Channel> outputs;
    private final ChainArrangements arrangements;
    private final ChainFit fit;

    /**
     * Of what was simulated.
     *
     * @param driven  input and outputs, nothing else
     * @param subject that is simulated
     */
    ChainSearch(Recording driven, Channel input, List<Channel> outputs, Model.Subject subject) {
        this.driven = loudest(driven, input, MOST);
        part = loudest(driven, input, (int) Math.max(PART * driven.clock().rate(), FEWEST));
        this.input = input;
        this.outputs = outputs;
        arrangements = new ChainArrangements(input,
                outputs.stream().sorted(Comparator.comparingInt(output -> Segment.order(output.location()))).toList());
        // What was computed has no noise; one that is small beside every output lets all of them count.
        double faintest = outputs.stream().mapToDouble(output -> Missed.deviation(driven.values(output), 0)).min().orElseThrow();
        fit = new ChainFit(FittedNet.GOOD * faintest, subject);
    }

    /** So many samples of a recording, where its input is greatest. */
    private static Recording loudest(Recording driven, Channel input, int most) {
        int length = Math.min(driven.length(), most);
        int best = 0;
        double greatest = -1;
        for (int from = 0; from + length <= driven.length(); from += Math.max(1, length / 4)) {
            double size = Missed.deviation(Arrays.copyOfRange(driven.values(input), from, from + length), 0);
            best = size > greatest ? from : best;
            greatest = Math.max(size, greatest);
        }
        return driven.part(best, best + length);
    }

    /** The measured bodies alone, fitted as their motion says that they hang together, or in a chain in their usual order. */
    FittedChain plain() {
        Optional<Model> read = ReadChain.of(part, input, outputs);
        return read.map(this::tried).filter(chain -> chain.worst() <= FittedNet.GOOD)
                .orElseGet(() -> nearest(tried(arrangements.plain()), read.stream().toList()));
    }

    /**
     * The best on a part, fitted to more.
     *
     * @param plain as {@link #plain()} gives it
     * @param progress told the step and the share of it that is done, 0 to 1
     */
    FittedChain best(FittedChain plain, BiConsumer<String, Double> progress) {
        progress.accept(Enrichment.STEP, 0.0);
        FittedChain net = net(plain, progress);
        List<Model> seated = net.worst() > FittedNet.GOOD ? arrangements.seated() : List.of();
        FittedChain found = seated.isEmpty() ? net
                : nearest(Parallel.map(seated, model -> fit.of(model, part, MassPrior.beside(net))).stream());
        return fit.of(found.model(), driven, found.masses());
    }

    /** Of any bodies and links, with masses that are the data's. */
    private FittedChain net(FittedChain plain, BiConsumer<String, Double> progress) {
        FittedChain chain = plain.worst() > FittedNet.GOOD ? nearest(plain, arrangements.startedElsewhere()) : plain;
        FittedChain usual = enriched(chain, progress);
        boolean mayBeReordered = usual.worst() > POOR && outputs.size() > 1 && outputs.size() <= MOST_ORDERED;
        FittedChain other = mayBeReordered ? nearest(usual, arrangements.reordered()) : usual;
        return other == usual ? usual : enriched(other, progress);
    }

    private FittedChain enriched(FittedChain chain, BiConsumer<String, Double> progress) {
        return Enrichment.of(chain, known -> nearest(known, arrangements.richer(known.model())),
                (known, more) -> !(more.worst() > known.worst() / 2), progress);
    }

    private FittedChain nearest(FittedChain known, List<Model> models) {
        return nearest(Stream.concat(Stream.of(known), Parallel.map(models, this::tried).stream()));
    }

    private static FittedChain nearest(Stream<FittedChain> fits) {
        return fits.min(Comparator.comparingDouble(FittedChain::worst)).orElseThrow();
    }

    private FittedChain tried(Model model) {
        return fit.of(model, part, MassPrior.FREE);
    }
}
