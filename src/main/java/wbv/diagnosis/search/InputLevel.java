package wbv.diagnosis.search;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import wbv.body.Assembly;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Entering;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.InputWay;
import wbv.diagnosis.fit.Window;
import wbv.diagnosis.measured.InputNoise;
import wbv.diagnosis.measured.NoiseLevel;
import wbv.diagnosis.measured.SmallError;
import wbv.recording.Channel;
import wbv.signal.LostSamples;

/**
 * How noisy the sensors of a rig's input are. No band of what moves a rig is known to hold noise alone, so that it shows in what a fit
 * leaves only: as something white that enters where the input does, and is a small part of it. Likeliest values, one sensor after the other
 * (errors in variables: Söderström 2007).
 */
public final class InputLevel {

    /**
     * Part of what it measures that a sensor's noise is at most [1]: as many standard deviations as any small error of a sensor, of that of
     * a gain.
     */
    private static final double MOST = SmallError.MOST * SmallError.Kind.GAIN.deviation();
    /** Levels that are tried, in octaves below the highest. */
    private static final int OCTAVES = 16;
    private static final int STEPS = 16;

    private final Evidence evidence;

    /** Of the sensors of this evidence's input. */
    public InputLevel(Evidence evidence) {
        this.evidence = evidence;
    }

    /** Standard deviations of a sample that make what a fit leaves likeliest, by sensor; only those that are likelier than none. */
    public Map<Channel, Double> of(Fitter.State fit) {
        Map<Channel, Double> found = new LinkedHashMap<>();
        Assembly assembly = new Simulator(evidence.excitation()).equivalent(fit.candidate().at(fit.x()));
        for (InputWay way : ways(assembly)) {
            Evidence heard = evidence.with(found);
            Fitter.State seen = found.isEmpty() ? fit : new Fitter(heard).look(fit.candidate(), fit.x(), heard.fit());
            Entering entering = Entering.along(heard, seen, way.transfer().get());
            double level = likeliest(entering, shape(way, heard.fit()), most(way.sensor()));
            if (level > 0) {
                found.put(way.sensor(), level);
            }
        }
        return found;
    }

    private List<InputWay> ways(Assembly assembly) {
        return InputWay.of(evidence, evidence.excitation(), assembly);
    }

    /** White noise is no stronger than the quietest band of what the sensor reads. */
    private double most(Channel sensor) {
        double[] read = evidence.recording().values(sensor);
        double mean = LostSamples.mean(read);
        double square = Arrays.stream(read).filter(value -> !Double.isNaN(value)).map(value -> Math.pow(value - mean, 2)).average()
                .orElse(0);
        return Math.min(new NoiseLevel().bound(read), MOST * Math.sqrt(square));
    }

    /** Power of the noise of a sensor of 1, by line. */
    private static double[] shape(InputWay way, Window window) {
        double[] out = new double[window.lines()];
        Arrays.setAll(out, line -> new InputNoise(1, way.noise().order()).power(2 * Math.PI * window.frequency(line)));
        return out;
    }

    /** The level at which the signal that entered is likeliest, of itself and of noise that stays; 0 where none is likelier. */
    private static double likeliest(Entering entering, double[] shape, double most) {
        double best = 0;
        double least = cost(entering, shape, 0);
        for (int step = 0; step <= OCTAVES * STEPS; step++) {
            double level = most * Math.pow(2, -(double) step / STEPS);
            double cost = cost(entering, shape, level);
            if (cost < least) {
                least = cost;
                best = level;
            }
        }
        return best;
    }

    /** Minus twice the logarithm of the likelihood. */
    private static double cost(Entering entering, double[] shape, double level) {
        double sum = 0;
        for (int line = 0; line < shape.length; line++) {
            double own = entering.variance()[line];
            if (own < Double.POSITIVE_INFINITY) {
                double all = own + level * level * shape[line];
                double re = entering.signal()[2 * line];
                double im = entering.signal()[2 * line + 1];
                sum += (re * re + im * im) / all + 2 * Math.log(all / own);
            }
        }
        return sum;
    }
}
