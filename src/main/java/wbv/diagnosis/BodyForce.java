package wbv.diagnosis;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Excitation;
import wbv.body.Model;
import wbv.body.Simulator;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.signal.CrossSpectrum;
import wbv.signal.Detrend;
import wbv.signal.FrequencyResponse;
import wbv.signal.Segmentation;

/**
 * A force that acts on one body all the time and has nothing to do with the ride: breath, voice, muscles, hands. No model predicts it,
 * so it belongs to the noise that every model is judged by.
 *
 * @param body  index of the body
 * @param rms   root mean square [N], as far as the fit's window shows it; below a hertz no stronger than above
 * @param even  the same of a force as strong in every band as in the middle one [N]: where accelerations hardly show a force, its
 *              estimate is mostly their noise
 * @param bands upper edges of the bands [Hz], rising
 * @param power by band: variance of the real and of the imaginary part of a line of {@link Window#spectrum} [N²]
 * @param carried part of the excess that it carries
 * @param slope how its level follows that of the ride from block to block: 0 not at all, 1 in proportion
 * @param doubt standard deviation of the slope; infinite where the ride has one level
 * @param lead  how much more of the excess it carries than a force in any link would: little for the first body and for a head, whose
 *              links could do the same; negative infinity where a link with a law that was found would carry nearly as much
 */
record BodyForce(int body, double rms, double even, double[] bands, double[] power, double carried, double slope, double doubt, double lead) {

    /** Part of the excess that a single body has to carry before the force is believed. */
    private static final double CARRIED = 0.6;
    /** How much more of what the body carries a link has to carry to be believed instead. */
    private static final double BETTER = 0.05;
    /** Part of what a body carries by which another may carry less and still be as likely. */
    private static final double ALIKE = 0.02;
    /** By how much, of its neighbours' level, that of a band may differ from it (one standard deviation). */
    private static final double ROUGH = 0.7;
    private static final int ROUNDS = 10;
    /** Bands within which a neighbour's word is worth a third of a band's own. */
    private static final double NEIGHBOURS = 1.5;
    private static final double FIRST_EDGE = 0.7;
    private static final double SHOWN = 1.2;
    /** What sitting still may take [N]. */
    private static final double ORDINARY = 4;
    /** Part of the heaviest body's mass from which on a body belongs to the trunk. */
    private static final double TRUNK = 0.3;
    private static final double LEAD = 0.03;
    /** The same over a link that holds a law that was found, whose form is never the last word. */
    private static final double CLEAR = 0.1;
    private static final double FOLLOWING = 0.5;
    private static final double INDEPENDENT = 0.4;
    private static final double STEADY = 0.8;
    private static final double ALL = 0.9;
    private static final double BLOCK = 4;
    private static final int SEGMENT = 256;
    private static final double COHERENT = 0.35;

    /** Whether a person sitting still could be the cause: small, on the trunk, and not following the ride. */
    boolean ordinary(Evidence evidence) {
        List<Model.Body> bodies = evidence.model().bodies();
        double heaviest = bodies.stream().mapToDouble(Model.Body::mass).max().orElse(0);
        // What hangs within the trunk, unseen, cannot be told from it.
        boolean trunk = bodies.get(body).mass() > TRUNK * heaviest || bodies.get(body).sensor().isEmpty();
        return trunk && Math.min(rms, even) < ORDINARY && slope - 2 * Math.min(doubt, 1) < FOLLOWING;
    }

    /** Whether its level is known not to follow that of the ride, as that of everything does which the ride causes. */
    boolean steady() {
        return slope + 2 * doubt < STEADY;
    }

    /**
     * Whether it is known to be a cause of its own: its level does not follow the ride's, or it carries all where the ride has one level.
     * Where a link could do the same, what lives in links has to be ruled out by the level alone.
     */
    boolean independent() {
        if (lead < LEAD) {
            return lead > Double.NEGATIVE_INFINITY && Math.abs(slope) + 2 * doubt < INDEPENDENT;
        }
        return doubt < FOLLOWING ? slope < INDEPENDENT && slope + 2 * doubt < 1 : carried > ALL;
    }

    /** The same force where all masses are greater by a factor. */
    BodyForce scaled(double factor) {
        return new BodyForce(body, factor * rms, factor * even, bands, Arrays.stream(power).map(p -> factor * factor * p).toArray(), carried,
                slope, doubt, lead);
    }

    /** Variance of each part of a line at a frequency [N²]. */
    double power(double frequency) {
        for (int i = 0; i < bands.length; i++) {
            if (frequency <= bands[i]) {
                return power[i];
            }
        }
        return power[power.length - 1];
    }

    /** The force on the one body that carries most of what a fit leaves; empty where no body carries it better than links and sensors do. */
    static Optional<BodyForce> in(Evidence evidence, Fitter.State state) {
        return in(evidence, state, false);
    }

    /** @param onBase whether bodies on the base count: a force there cannot be told from one in the base's link, where friction lives */
    static Optional<BodyForce> in(Evidence evidence, Fitter.State state, boolean onBase) {
        int outputs = evidence.outputs().size();
        if (outputs < 2 || evidence.onRig()) {
            return Optional.empty();
        }
        Simulator simulator = new Simulator(evidence.excitation());
        Assembly assembly = simulator.equivalent(state.candidate().at(state.x()));
        Simulator.Linearised linear = simulator.linearised(assembly);
        List<Model.Body> bodies = evidence.model().bodies();
        double[] left = new double[bodies.size()];
        for (int b = 0; b < left.length; b++) {
            left[b] = onBase || !onBase(assembly, b) ? left(evidence, state, linear.ofBodyForce(b)) : Double.POSITIVE_INFINITY;
        }
        double least = Arrays.stream(left).min().orElseThrow();
        if (least == Double.POSITIVE_INFINITY) {
            return Optional.empty();
        }
        // Where the link between two bodies is ignored, a force on one is as good as one on the other: then it acts on the heavier.
        int best = IntStream.range(0, left.length).filter(b -> left[b] - least <= ALIKE * Math.max(0, state.reduced() - least)).boxed()
                .max(Comparator.comparingDouble(b -> bodies.get(b).mass())).orElseThrow();
        double link = Double.POSITIVE_INFINITY;
        double answering = Double.POSITIVE_INFINITY;
        for (int l = 0; l < evidence.model().links().size(); l++) {
            double there = left(evidence, state, linear.ofLinkForce(l));
            // A law that was found answers to the force too, the more the farther it is from linear, and so seems to carry it.
            if (holdsLaw(state, l)) {
                answering = Math.min(answering, there);
            } else {
                link = Math.min(link, there);
            }
        }
        double lead = (link - least) / (state.reduced() - least);
        if (lead < -BETTER || least - 1 > (1 - CARRIED) * (state.reduced() - 1)) {
            return Optional.empty();
        }
        boolean form = answering - least < CLEAR * (state.reduced() - least);
        lead = form ? Double.NEGATIVE_INFINITY : lead;
        BodyForce found = of(evidence, state, best, linear.ofBodyForce(best), (state.reduced() - least) / (state.reduced() - 1), lead);
        return found.slope() < Double.POSITIVE_INFINITY ? Optional.of(found) : Optional.empty();
    }

    /** Whether a law that is not linear was added in a link. */
    private static boolean holdsLaw(Fitter.State state, int link) {
        return state.candidate().added().stream().flatMap(h -> h.additions().stream())
                .anyMatch(a -> a instanceof Hypothesis.Addition.InLink in && in.link() == link && !in.law().isLinear());
    }

    private static boolean onBase(Assembly assembly, int body) {
        return IntStream.range(0, assembly.structure().links()).anyMatch(l -> assembly.structure().from()[l] < 0
                && assembly.structure().to()[l] == body);
    }

    /** How much more of the residual than noise lies along a direction, at least 0. */
    static double along(Evidence evidence, Fitter.State state, double[][] direction) {
        Whitening plain = state.frame().whitening();
        if (evidence.outputs().size() == 1 || evidence.model().driven()) {   // there is but one direction
            return Math.max(0, state.square() - plain.degrees());
        }
        double lines = 2.0 * plain.window().lines();
        double rest = left(evidence, state, direction) * (plain.degrees() - lines);
        return Math.max(0, state.square() - rest - lines);
    }

    /** Mean square of the residual that is left when an arbitrary signal along a direction is taken out. */
    static double left(Evidence evidence, Fitter.State state, double[][] direction) {
        Whitening plain = state.frame().whitening();
        double[] unit = plain.whiten(seen(evidence, state, direction));
        double[] r = state.residual();
        int m = 2 * evidence.outputs().size();
        double sum = Fitter.dot(r, r);
        for (int line = 0; line < plain.window().lines(); line++) {
            double size = 0;
            double re = 0;
            double im = 0;
            for (int i = m * line; i < m * (line + 1); i += 2) {
                size += unit[i] * unit[i] + unit[i + 1] * unit[i + 1];
                re += unit[i] * r[i] + unit[i + 1] * r[i + 1];
                im += unit[i] * r[i + 1] - unit[i + 1] * r[i];
            }
            sum -= size > 0 ? (re * re + im * im) / size : 0;
        }
        return sum / (plain.degrees() - 2.0 * plain.window().lines());
    }

    /** A direction at the lines of the fit's window, as sensors with the fit's errors read it. */
    private static double[][] seen(Evidence evidence, Fitter.State state, double[][] direction) {
        double[][] way = evidence.atLines(evidence.excitation(), direction, state.frame().whitening().window());
        return state.frame().nuisances().seen(way, state.errors());
    }

    private static BodyForce of(Evidence evidence, Fitter.State state, int body, double[][] direction, double carried,
                                double lead) {
        Whitening plain = state.frame().whitening();
        Window window = plain.window();
        double[] unit = plain.whiten(seen(evidence, state, direction));
        double[] r = state.residual();
        int m = 2 * evidence.outputs().size();
        double[] force = new double[2 * window.lines()];
        double[] variance = new double[window.lines()];
        for (int line = 0; line < window.lines(); line++) {
            double size = 0;
            for (int i = m * line; i < m * (line + 1); i += 2) {
                size += unit[i] * unit[i] + unit[i + 1] * unit[i + 1];
                force[2 * line] += unit[i] * r[i] + unit[i + 1] * r[i + 1];
                force[2 * line + 1] += unit[i] * r[i + 1] - unit[i + 1] * r[i];
            }
            force[2 * line] /= size;
            force[2 * line + 1] /= size;
            variance[line] = 1 / size;
        }
        double[] bands = edges(window);
        double[] power = new double[bands.length];
        int[] count = new int[bands.length];
        double[] noise = new double[bands.length];
        for (int line = 0, band = 0; line < window.lines(); line++) {
            while (window.frequency(line) > bands[band]) {
                band++;
            }
            power[band] += (force[2 * line] * force[2 * line] + force[2 * line + 1] * force[2 * line + 1]) / 2;
            noise[band] += variance[line];
            count[band]++;
        }
        for (int i = 0; i < bands.length; i++) {
            power[i] /= Math.max(1, count[i]);
            noise[i] /= Math.max(1, count[i]);
        }
        power = levels(power, noise, count);
        // Far below its resonance a body hardly moves under a force, and what the sensors' small errors make of the ride looks like a large one.
        double[] shown = power.clone();
        for (int i = bands.length - 2; i >= 0; i--) {
            if (bands[i] < SHOWN) {
                shown[i] = Math.min(shown[i], shown[i + 1]);
            }
        }
        double total = IntStream.range(0, bands.length).mapToDouble(i -> shown[i] * count[i]).sum();
        double[] sorted = power.clone();
        Arrays.sort(sorted);
        double half = window.length() / 2.0;
        double even = Math.sqrt(sorted[sorted.length / 2] * window.lines() / half);
        double[] level = follows(evidence, window, force);
        return new BodyForce(body, Math.sqrt(total / half), even, bands, power, carried, level[0], level[1], lead);
    }

    /**
     * Power of a force by band, from estimates with noise: what a band and its neighbours show together, and its own the more the better it is known.
     *
     * @param power of estimates that hold the noise's too @param count lines by band
     */
    static double[] levels(double[] power, double[] noise, int[] count) {
        double[] level = new double[power.length];
        for (int round = 0; round < ROUNDS; round++) {
            double[] before = level.clone();
            for (int i = 0; i < level.length; i++) {
                double sum = 0;
                double weights = 0;
                for (int j = 0; j < power.length; j++) {
                    double deviation = before[i] + noise[j];
                    double weight = Math.exp(-Math.abs(i - j) / NEIGHBOURS) * count[j] / (deviation * deviation);
                    sum += count[j] == 0 ? 0 : weight * (power[j] - noise[j]);
                    weights += count[j] == 0 ? 0 : weight;
                }
                level[i] = Math.max(0, sum / weights);
            }
        }
        for (int i = 0; i < level.length; i++) {
            double own = power[i] - noise[i];
            double known = Math.pow((level[i] + noise[i]) / (ROUGH * level[i]), 2) / Math.max(1, count[i]);
            level[i] = level[i] == 0 ? Math.max(0, own) : Math.max(0, level[i] + (own - level[i]) / (1 + known));
        }
        return level;
    }

    /** Third-octave edges over the window's lines. */
    private static double[] edges(Window window) {
        double top = window.frequency(window.lines() - 1);
        int n = (int) Math.ceil(3 * Math.log(top / FIRST_EDGE) / Math.log(2));
        double[] out = new double[n + 1];
        for (int i = 0; i <= n; i++) {
            out[i] = FIRST_EDGE * Math.pow(2, i / 3.0);
        }
        return out;
    }

    /** Slope of the force's level over the ride's, in logarithms, over blocks of a few seconds, and its standard deviation. */
    private static double[] follows(Evidence evidence, Window window, double[] force) {
        double[] series = window.series(force);
        Excitation excitation = evidence.excitation();
        double[] ride = excitation.series(excitation.baseSpectrum());
        if (answersTo(evidence, window, series)) {
            return new double[] {Double.POSITIVE_INFINITY, 0};
        }
        int block = (int) (BLOCK * evidence.recording().clock().rate());
        int blocks = window.length() / block;
        double[] x = new double[blocks];
        double[] y = new double[blocks];
        for (int b = 0; b < blocks; b++) {
            for (int i = b * block; i < (b + 1) * block; i++) {
                x[b] += ride[window.start() + i] * ride[window.start() + i];
                y[b] += series[i] * series[i];
            }
            x[b] = Math.log(x[b] + 1e-12);
            y[b] = Math.log(y[b] + 1e-12);
        }
        double mx = Arrays.stream(x).average().orElse(0);
        double my = Arrays.stream(y).average().orElse(0);
        double sxy = 0;
        double sxx = 0;
        for (int b = 0; b < blocks; b++) {
            sxy += (x[b] - mx) * (y[b] - my);
            sxx += (x[b] - mx) * (x[b] - mx);
        }
        // A ride of one level tells nothing: then only the size speaks.
        if (sxx / blocks < 0.05) {
            return new double[] {0, Double.POSITIVE_INFINITY};
        }
        double slope = sxy / sxx;
        double left = 0;
        for (int b = 0; b < blocks; b++) {
            left += Math.pow(y[b] - my - slope * (x[b] - mx), 2);
        }
        return new double[] {slope, Math.sqrt(left / Math.max(1, blocks - 2) / sxx)};
    }

    /** Whether any other channel of the recording explains a good part of the force: then something couples it in, and nobody pushes. */
    private static boolean answersTo(Evidence evidence, Window window, double[] force) {
        Segmentation segmentation = new Segmentation(evidence.recording().clock().rate(), SEGMENT, 0.5);
        for (Channel channel : evidence.recording().channels()) {
            boolean along = channel.axis() == evidence.model().axis() && channel.quantity() == Quantity.ACCELERATION;
            if (along || channel.quantity() == Quantity.QUATERNION || channel.quantity() == Quantity.MAGNETIC_FIELD) {
                continue;   // motion along the model's own axis answers the force itself
            }
            double[] series = evidence.series(channel);
            CrossSpectrum spectra = new CrossSpectrum(segmentation, Detrend.MEAN, 1);
            for (int i = 0; i < force.length; i++) {
                spectra.accept(series[window.start() + i], force[i]);
            }
            if (spectra.averaged(0) > 8 && coherent(spectra.response(0, FrequencyResponse.Excited.USUAL)) > COHERENT) {
                return true;
            }
        }
        return false;
    }

    /** Share of the output's power that is coherent with the input. */
    private static double coherent(FrequencyResponse response) {
        double sum = 0;
        double total = 0;
        for (int k = 2; k < response.frequency().length; k++) {
            sum += response.coherence()[k] * response.outputDensity()[k];
            total += response.outputDensity()[k];
        }
        return sum / total;
    }
}
