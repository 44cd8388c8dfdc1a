package wbv.diagnosis;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Model;

/**
 * The force that a sitter makes on the trunk all the time: breath, voice, muscles. It is part of every hypothesis, as a process of unknown
 * level below a few hertz, and as a second one that goes with the ride's spectrum, which may be absent. Levels and the body of the trunk are
 * summed over, and so is what each band has more or less than such a spectrum: nobody knows its shape.
 */
final class OwnForce {

    /** Levels on either side of the usual one, and the farthest of them in deviations. */
    private static final int LEVELS = 5;
    private static final int FARTHEST = 3;
    /** How many times stronger the whole is than its weakest band, at most. */
    private static final double LOUDEST = 30;
    /** Rounds in which the sensors' errors and the levels settle beside each other. */
    private static final int ROUNDS = 2;
    /** Half a third of an octave, by which the ride's spectrum is smoothed. */
    private static final double SMOOTH = Math.pow(2, 1.0 / 6);

    private final List<Place> bodies;
    private final double[] levels;
    private final double[] priors;
    private final double rough;
    private final BandLevels bands;
    /** Powers by band of a force of 1 N. */
    private final double[] still;
    private final double[] riding;

    OwnForce(Evidence evidence, Priors all) {
        bodies = bodies(evidence, all);
        levels = IntStream.rangeClosed(-LEVELS, LEVELS).mapToDouble(i -> all.own() * Math.pow(all.ownSpread(), (double) FARTHEST * i / LEVELS)).toArray();
        double[] logs = Arrays.stream(levels).map(level -> -0.5 * Math.pow(Math.log(level / all.own()) / Math.log(all.ownSpread()), 2)).toArray();
        double sum = LogSum.of(logs);
        priors = Arrays.stream(logs).map(log -> log - sum).toArray();
        rough = Math.log(all.ownShape());
        Window window = evidence.fit();
        double scatter = Math.pow(all.ownShape(), FARTHEST);
        bands = new BandLevels(window, levels[0] / LOUDEST / scatter, levels[levels.length - 1] * scatter);
        still = bands.mean(unit(window, IntStream.range(0, window.lines()).mapToDouble(line -> 1 / (1 + Math.pow(window.frequency(line) / all.ownCorner(), 2)))
                .toArray()));
        riding = bands.mean(unit(window, ride(evidence)));
    }

    private static List<Place> bodies(Evidence evidence, Priors all) {
        List<Model.Body> bodies = evidence.model().bodies();
        double heaviest = bodies.stream().mapToDouble(Model.Body::mass).max().orElse(0);
        return evidence.onRig() ? List.of() : IntStream.range(0, bodies.size()).filter(b -> bodies.get(b).mass() >= all.trunk() * heaviest)
                .mapToObj(b -> new Place(Place.Kind.BODY, b)).toList();
    }

    private static double[] ride(Evidence evidence) {
        Window window = evidence.fit();
        double[] series = evidence.excitation().series(evidence.excitation().baseSpectrum());
        boolean[] all = new boolean[series.length];
        Arrays.fill(all, true);
        return smoothed(window, window.spectrum(series, all));
    }

    /** Variance of each part of a spectrum's lines, averaged over a third of an octave. */
    static double[] smoothed(Window window, double[] spectrum) {
        int n = window.lines();
        double[] sums = new double[n + 1];
        for (int line = 0; line < n; line++) {
            sums[line + 1] = sums[line] + (spectrum[2 * line] * spectrum[2 * line] + spectrum[2 * line + 1] * spectrum[2 * line + 1]) / 2;
        }
        double[] out = new double[n];
        int low = 0;
        int high = 0;
        for (int line = 0; line < n; line++) {
            double f = window.frequency(line);
            while (window.frequency(low) < f / SMOOTH) {
                low++;
            }
            while (high + 1 < n && window.frequency(high + 1) <= f * SMOOTH) {
                high++;
            }
            high = Math.max(high, line);
            out[line] = (sums[high + 1] - sums[low]) / (high + 1 - low);
        }
        return out;
    }

    /** A power by line that makes a root mean square of 1 over a window. @param shape Not modified. */
    private static double[] unit(Window window, double[] shape) {
        double square = Arrays.stream(shape).sum() / (window.length() / 2.0);
        return Arrays.stream(shape).map(power -> square > 0 ? power / square : 0).toArray();
    }

    /**
     * A likelihood with it.
     *
     * @param value log of the likelihood, summed over levels and bodies @param source the likeliest force, as noise; none on a rig
     * @param body  which of the trunk's it acts on
     * @param level of what does not follow the ride [N] @param riding of what does [N]
     */
    record Summed(double value, List<Whitening.Source> source, int body, double level, double riding) { }

    /** Ways of a force on each body of the trunk. */
    List<double[][]> ways(Evidence evidence, Assembly assembly) {
        return bodies.stream().map(body -> evidence.atLines(evidence.excitation(), body.direction(evidence.excitation(), assembly), evidence.fit())).toList();
    }

    /** @param ways as {@link #ways} gives them @param whitened the same as the likelihood's residual is */
    Summed sum(LogLikelihood likelihood, List<double[][]> ways, List<double[]> whitened) {
        if (bodies.isEmpty()) {
            return new Summed(likelihood.value(), List.of(), 0, 0, 0);
        }
        double[] terms = new double[bodies.size()];
        Summed[] all = new Summed[terms.length];
        for (int b = 0; b < terms.length; b++) {
            all[b] = sum(likelihood, ways.get(b), whitened.get(b));
            terms[b] = all[b].value() - Math.log(terms.length);
        }
        int body = LogSum.greatest(terms);
        return new Summed(LogSum.of(terms), all[body].source(), body, all[body].level(), all[body].riding());
    }

    /** On one body. */
    private Summed sum(LogLikelihood likelihood, double[][] way, double[] whitened) {
        int n = levels.length;
        double[] terms = new double[n * (n + 1)];
        double[] power = bands.spread(shape(n / 2 * (n + 1)));
        int best = 0;
        for (int round = 0; round < ROUNDS; round++) {
            LogLikelihood.Held held = likelihood.held(whitened, power);
            double[][] logs = bands.likelihood(held);
            for (int i = 0; i < terms.length; i++) {
                double[][] tied = tied(logs, shape(i));
                int ride = i % (n + 1);
                terms[i] = held.known() + Arrays.stream(tied).mapToDouble(LogSum::of).sum() + priors[i / (n + 1)] - Math.log(2) + (ride == 0 ? 0 : priors[ride - 1]);
            }
            best = LogSum.greatest(terms);
            double[][] tied = tied(logs, shape(best));
            power = bands.spread(IntStream.range(0, BandLevels.BANDS).mapToDouble(band -> bands.expected(band, tied[band])[0]).toArray());
        }
        int ride = best % (n + 1);
        return new Summed(LogSum.of(terms), List.of(new Whitening.Source(power, way)), 0, levels[best / (n + 1)], ride == 0 ? 0 : levels[ride - 1]);
    }

    /** Probability of each level in each band, log-normal about a shape, with what the data say of it. */
    private double[][] tied(double[][] logs, double[] shape) {
        double[][] out = new double[logs.length][];
        for (int band = 0; band < out.length; band++) {
            double[] powers = bands.powers(band);
            double[] prior = new double[powers.length];
            for (int step = 0; step < prior.length; step++) {
                prior[step] = -0.5 * Math.pow(Math.log(powers[step] / shape[band]) / 2 / rough, 2);
            }
            double sum = LogSum.of(prior);
            out[band] = new double[prior.length];
            for (int step = 0; step < prior.length; step++) {
                out[band][step] = logs[band][step] + prior[step] - sum;
            }
        }
        return out;
    }

    /** Power by band. @param node of the grid of levels */
    private double[] shape(int node) {
        int level = node / (levels.length + 1);
        int ride = node % (levels.length + 1);
        double own = levels[level] * levels[level];
        double with = ride == 0 ? 0 : levels[ride - 1] * levels[ride - 1];
        return IntStream.range(0, still.length).mapToDouble(band -> own * still[band] + with * riding[band]).toArray();
    }
}
