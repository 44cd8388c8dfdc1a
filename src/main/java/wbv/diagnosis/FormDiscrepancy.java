package wbv.diagnosis;

import java.util.Arrays;
import java.util.function.UnaryOperator;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Simulator;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * How wrong a mechanism's formula may be: beside it acts a process whose power is ρ² times that of its own force, what a spring, a dashpot or a
 * mass there would do left out, smoothed over a third of an octave.
 *
 * @param place    where the mechanism acts
 * @param way      what a unit there does to each output, at the window's lines
 * @param whitened the same, whitened
 * @param force    power of the mechanism's own force by line, smoothed
 * @param shares   the ρ that are summed over, 0 first
 */
record FormDiscrepancy(Place place, double[][] way, double[] whitened, double[] force, double[] shares) {

    /** Steps of ρ; between them the likelihood changes by less than one nat. */
    private static final double STEP = 0.05;

    /**
     * Of one part of a fit in a whitening without any such process.
     *
     * @param baseline the model that all parts were added to @param linear the fit's model, made linear @param seen what sensors read of something that reaches the outputs
     */
    static FormDiscrepancy of(Evidence evidence, Candidate baseline, Fitter.State fit, Hypothesis part, Assembly linear,
                              UnaryOperator<double[][]> seen, Priors priors) {
        Place place = Place.of(part);
        Whitening whitening = fit.frame().whitening();
        double[][] way = evidence.atLines(evidence.excitation(), place.direction(evidence.excitation(), linear), whitening.window());
        way = place.kind() == Place.Kind.SENSOR ? way : seen.apply(way);
        double[] force = force(evidence, baseline, fit, part, place, whitening);
        double most = part.byTheClock() ? priors.formInTime() : priors.form();
        int n = (int) Math.round(most / STEP);
        return new FormDiscrepancy(place, way, whitening.whiten(way), OwnForce.smoothed(whitening.window(), force),
                IntStream.rangeClosed(0, n).mapToDouble(i -> most * i / n).toArray());
    }

    /** Power by line of the process at a share. */
    double[] power(double share) {
        return Arrays.stream(force).map(power -> share * share * power).toArray();
    }

    /** Spectrum of the part's own force at the lines of the fit's window, without what a spring, a dashpot or a mass at its place would do. */
    private static double[] force(Evidence evidence, Candidate baseline, Fitter.State fit, Hypothesis part, Place place, Whitening whitening) {
        Simulator simulator = new Simulator(evidence.excitation());
        Assembly bare = bare(baseline, fit, part);
        Assembly full = fit.candidate().at(fit.x());
        Simulator.Response response = simulator.run(full, false);
        double[][] change = response.outputs();
        double[][] rest = simulator.run(bare, false).outputs();
        for (int o = 0; o < change.length; o++) {
            for (int i = 0; i < change[o].length; i++) {
                change[o][i] -= rest[o][i];
            }
        }
        double[] moved = evidence.whitened(evidence.excitation(), change, 1, whitening);
        double[] unit = whitening.whiten(evidence.atLines(evidence.excitation(), place.direction(evidence.excitation(), bare), whitening.window()));
        double[] sizes = RankOne.sizes(unit, whitening.outputs());
        double[] force = RankOne.along(unit, moved, whitening.outputs());
        for (int i = 0; i < force.length; i++) {
            force[i] /= sizes[i / 2] > 0 ? sizes[i / 2] : 1;
        }
        if (place.kind() == Place.Kind.LINK && part.isLaw()) {
            double[] stretch = lines(evidence, response.stretch()[place.index()]);
            remove(force, new double[][] {stretch, turned(evidence.fit(), stretch)}, sizes);
        } else if (place.kind() == Place.Kind.BODY) {
            remove(force, new double[][] {lines(evidence, simulator.accelerations(full)[place.index()])}, sizes);
        }
        return force;
    }

    private static double[] lines(Evidence evidence, double[] spectrum) {
        double[] series = evidence.excitation().series(spectrum);
        boolean[] all = new boolean[series.length];
        Arrays.fill(all, true);
        return evidence.fit().spectrum(series, all);
    }

    /** The derivative to time. */
    private static double[] turned(Window window, double[] x) {
        double[] out = new double[x.length];
        for (int line = 0; line < window.lines(); line++) {
            double omega = 2 * Math.PI * window.frequency(line);
            out[2 * line] = -omega * x[2 * line + 1];
            out[2 * line + 1] = omega * x[2 * line];
        }
        return out;
    }

    /** Takes out of a force what real factors of some motions make of it. @param force Modified. @param weights by line */
    private static void remove(double[] force, double[][] motions, double[] weights) {
        int n = motions.length;
        double[][] a = new double[n][n];
        double[] b = new double[n];
        for (int k = 0; k < force.length; k++) {
            for (int i = 0; i < n; i++) {
                b[i] += weights[k / 2] * motions[i][k] * force[k];
                for (int j = 0; j < n; j++) {
                    a[i][j] += weights[k / 2] * motions[i][k] * motions[j][k];
                }
            }
        }
        double[] factors = Fitter.solve(a, b, new boolean[n], 0);
        for (int k = 0; k < force.length; k++) {
            for (int i = 0; i < n; i++) {
                force[k] -= factors[i] * motions[i][k];
            }
        }
    }

    /** The fit's model without the part, all other numbers as they are. */
    private static Assembly bare(Candidate baseline, Fitter.State fit, Hypothesis part) {
        Candidate out = baseline;
        double[] x = Arrays.copyOf(fit.x(), baseline.knobs().size());
        for (Hypothesis each : fit.candidate().added()) {
            if (each != part) {
                out = out.with(each);
                double[] own = Arrays.stream(fit.candidate().positions(each)).mapToDouble(i -> fit.x()[i]).toArray();
                x = DoubleStream.concat(Arrays.stream(x), Arrays.stream(own)).toArray();
            }
        }
        return out.at(x);
    }
}
