package wbv.diagnosis;

import java.util.ArrayList;
import java.util.List;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.signal.Differentiator;

/**
 * What one standard deviation of each small error of the sensors adds to the outputs' spectra in a window, before any whitening.
 *
 * @param names   output and error @param owners index of the output, or {@link Nuisances#INPUT}
 * @param spectra by error and output; an empty array where it adds nothing
 */
record ErrorShapes(List<String> names, List<Integer> owners, List<double[][]> spectra) {

    /** The errors of all acceleration sensors of the outputs, and the delay of the input's; none of what was computed. */
    static ErrorShapes of(Evidence evidence, Window window) {
        ErrorShapes shapes = new ErrorShapes(new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
        double step = evidence.recording().clock().step();
        double[][] early = new double[evidence.outputs().size()][0];
        for (int o = 0; o < early.length && !evidence.isComputed(); o++) {
            Channel channel = evidence.outputs().get(o);
            double[] slope = slope(evidence.measured(o), step);
            early[o] = spectrum(evidence, window, o, slope, Nuisances.DELAY * step);
            if (channel.quantity() == Quantity.ACCELERATION) {
                shapes.addSensor(evidence, window, o, slope);
            }
        }
        if (!shapes.names().isEmpty()) {
            shapes.names().add("input" + Nuisances.DELAYED);
            shapes.owners().add(Nuisances.INPUT);
            shapes.spectra().add(early);
        }
        return new ErrorShapes(List.copyOf(shapes.names()), List.copyOf(shapes.owners()), List.copyOf(shapes.spectra()));
    }

    private void addSensor(Evidence evidence, Window window, int o, double[] slope) {
        Channel channel = evidence.outputs().get(o);
        double step = evidence.recording().clock().step();
        add(evidence, window, o, Nuisances.GAINED, evidence.measured(o), Nuisances.GAIN);
        add(evidence, window, o, Nuisances.DELAYED, slope, -Nuisances.DELAY * step);
        for (Channel across : evidence.companions(channel.location(), Quantity.ACCELERATION)) {
            add(evidence, window, o, " tilt to " + across.axis(), evidence.series(across), Nuisances.TILT);
            addSway(evidence, window, o, across);
        }
        addCentripetal(evidence, window, o, channel);
        for (Channel rate : evidence.companions(channel.location(), Quantity.ANGULAR_RATE)) {
            add(evidence, window, o, " arm on " + rate.axis(), slope(evidence.series(rate), step), Nuisances.ARM);
        }
    }

    /** A sensor that sways tilts, and sees the acceleration across times its angle: pitch for the fore-aft axis, roll for the lateral. */
    private void addSway(Evidence evidence, Window window, int output, Channel across) {
        char axis = across.axis() == 'x' ? 'y' : 'x';
        for (Channel rate : evidence.companions(across.location(), Quantity.ANGULAR_RATE)) {
            if (rate.axis() == axis) {
                double[] angle = integrated(evidence.series(rate), evidence.recording().clock().step());
                double[] a = evidence.series(across);
                for (int i = 0; i < angle.length; i++) {
                    angle[i] *= a[i];
                }
                add(evidence, window, output, " sway to " + across.axis(), angle, Nuisances.SWAY);
            }
        }
    }

    /** A sensor above the axis about which its place turns is pulled inwards: height times the square of the rate. */
    private void addCentripetal(Evidence evidence, Window window, int output, Channel channel) {
        List<Channel> rates = evidence.companions(channel.location(), Quantity.ANGULAR_RATE);
        if (!rates.isEmpty()) {
            double[] square = new double[evidence.measured(output).length];
            for (Channel rate : rates) {
                double[] w = evidence.series(rate);
                for (int i = 0; i < square.length; i++) {
                    square[i] -= w[i] * w[i];
                }
            }
            add(evidence, window, output, " height", square, Nuisances.HEIGHT);
        }
    }

    private void add(Evidence evidence, Window window, int output, String name, double[] series, double deviation) {
        double[][] own = new double[evidence.outputs().size()][0];
        own[output] = spectrum(evidence, window, output, series, deviation);
        names.add(evidence.outputs().get(output) + name);
        owners.add(output);
        spectra.add(own);
    }

    /** Angle from rate, what is slower than a tenth of a hertz left out. */
    private static double[] integrated(double[] rate, double step) {
        double[] out = new double[rate.length];
        double decay = Math.exp(-2 * Math.PI * 0.1 * step);
        for (int i = 1; i < out.length; i++) {
            out[i] = decay * (out[i - 1] + step * (rate[i] + rate[i - 1]) / 2);
        }
        return out;
    }

    private static double[] spectrum(Evidence evidence, Window window, int output, double[] series, double factor) {
        double[] scaled = new double[series.length];
        for (int i = 0; i < scaled.length; i++) {
            scaled[i] = factor * series[i];
        }
        return window.spectrum(scaled, evidence.valid(output));
    }

    /** Time derivative, right up to the highest line that counts; 0 at both ends, where none does. */
    private static double[] slope(double[] x, double step) {
        Differentiator differentiator = new Differentiator(1 / step);
        double[] out = new double[x.length];
        for (int i = 0; i < x.length; i++) {
            double slope = differentiator.accept(x[i]);
            if (!Double.isNaN(slope)) {
                out[i - differentiator.delay()] = slope;
            }
        }
        return out;
    }
}
