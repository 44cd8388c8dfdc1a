package wbv.diagnosis;

import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
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
    private static final int RIDES = 3;
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
    private final double[] rides;
    private final double[] ridePriors;
    private final double rough;
    private final double[][] logPowers;
    private final BandLevels bands;
    /** Powers by band of a force of 1 N. */
    private final double[] still;
    private final double[] riding;

    OwnForce(Evidence evidence, Priors all) {
        bodies = bodies(evidence, all);
        levels = levels(all, LEVELS);
        priors = priors(all, levels);
        double[] with = levels(all, RIDES);
        rides = DoubleStream.concat(DoubleStream.of(0), Arrays.stream(with)).toArray();
        // It may be absent as well as not.
        ridePriors = DoubleStream.concat(DoubleStream.of(0), Arrays.stream(priors(all, with))).map(log -> log - Math.log(2)).toArray();
        rough = Math.log(all.ownShape());
        Window window = evidence.fit();
        double scatter = Math.pow(all.ownShape(), FARTHEST);
        bands = new BandLevels(window, levels[0] / LOUDEST / scatter, levels[levels.length - 1] * scatter);
        logPowers = IntStream.range(0, BandLevels.BANDS).mapToObj(band -> Arrays.stream(bands.powers(band)).map(Math::log).toArray()).toArray(double[][]::new);
        still = bands.mean(unit(window, IntStream.range(0, window.lines()).mapToDouble(line -> 1 / (1 + Math.pow(window.frequency(line) / all.ownCorner(), 2)))
                .toArray()));
        riding = bands.mean(unit(window, ride(evidence)));
    }

    private static double[] levels(Priors all, int eachSide) {
        return IntStream.rangeClosed(-eachSide, eachSide).mapToDouble(i -> all.own() * Math.pow(all.ownSpread(), (double) FARTHEST * i / eachSide)).toArray();
    }

    private static double[] priors(Priors all, double[] levels) {
        double[] logs = Arrays.stream(levels).map(level -> -0.5 * Math.pow(Math.log(level / all.own()) / Math.log(all.ownSpread()), 2)).toArray();
        double sum = LogSum.of(logs);
        return Arrays.stream(logs).map(log -> log - sum).toArray();
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
        int n = rides.length;
        double[] terms = new double[levels.length * n];
        double[] power = bands.spread(shape(levels.length / 2 * n));
        int best = 0;
        for (int round = 0; round < ROUNDS; round++) {
            LogLikelihood.Held held = likelihood.held(whitened, power);
            double[][] logs = bands.likelihood(held);
            for (int i = 0; i < terms.length; i++) {
                double[] shape = shape(i);
                terms[i] = held.known() + priors[i / n] + ridePriors[i % n] + IntStream.range(0, shape.length).mapToDouble(band -> LogSum.of(tied(band, logs[band], shape[band]))).sum();
            }
            best = LogSum.greatest(terms);
            double[] shape = shape(best);
            power = bands.spread(IntStream.range(0, shape.length).mapToDouble(band -> bands.expected(band, tied(band, logs[band], shape[band]))[0]).toArray());
        }
        return new Summed(LogSum.of(terms), List.of(new Whitening.Source(power, way)), 0, levels[best / n], rides[best % n]);
    }

    /** Probability of each level in a band, log-normal about a usual power, with what the data say of it. */
    private double[] tied(int band, double[] logs, double usual) {
        double[] powers = logPowers[band];
        double middle = Math.log(usual);
        double deviation = 2 * rough;
        double prior = Math.log((powers[1] - powers[0]) / deviation / Math.sqrt(2 * Math.PI));
        double[] out = new double[logs.length];
        for (int step = 0; step < out.length; step++) {
            double z = (powers[step] - middle) / deviation;
            out[step] = logs[step] + prior - 0.5 * z * z;
        }
        return out;
    }

    /** Power by band. @param node of the grid of levels */
    private double[] shape(int node) {
        double own = Math.pow(levels[node / rides.length], 2);
        double with = Math.pow(rides[node % rides.length], 2);
        return IntStream.range(0, still.length).mapToDouble(band -> own * still[band] + with * riding[band]).toArray();
    }
}
