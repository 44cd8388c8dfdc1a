package wbv.diagnosis.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.measured.SmallError;
import wbv.diagnosis.measured.SmallError.Kind;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.signal.Differentiator;

/**
 * What one standard deviation of each small error of the sensors adds to the outputs, before any whitening.
 *
 * @param shapes by error and output: series over the whole recording, or their spectra in a window; an empty array where it adds nothing
 */
record ErrorShapes(List<SmallError> errors, List<double[][]> shapes) {

    /**
     * The errors of all sensors of acceleration and rates among the outputs, of a rig of all, and the delay of the input's, as series; none
     * of what was computed.
     */
    static ErrorShapes of(Evidence evidence) {
        ErrorShapes all = new ErrorShapes(new ArrayList<>(), new ArrayList<>());
        double step = evidence.recording().clock().step();
        double[][] early = new double[evidence.outputs().size()][0];
        for (int o = 0; o < early.length && !evidence.measured().computed(); o++) {
            early[o] = scaled(slope(evidence.measured(o), step),
                    new SmallError(Kind.DELAY, SmallError.INPUT, "").deviation(evidence.measured().sample()));
        }
        for (int o = 0; o < early.length && !evidence.measured().computed(); o++) {
            if (errs(evidence, o) && (o > 0 || !evidence.measuresForces())) {   // else the first is what others are measured by
                all.add(evidence, new SmallError(Kind.GAIN, o, ""), evidence.measured(o));
            }
            all.addDelay(evidence, o, early);
            if (evidence.outputs().get(o).quantity() == Quantity.ACCELERATION) {
                all.addPose(evidence, o, step);
            }
        }
        int axes = evidence.measured().computed() || evidence.model().base().further().isEmpty() ? 0
                : evidence.model().base().sensors().size();
        for (int axis = 0; axis < axes; axis++) {
            if (axis > 0) {
                all.addAxis(evidence, axis, step);
            }
            all.addPoseOfBase(evidence, axis);
        }
        if (!all.errors().isEmpty()) {
            all.errors().add(new SmallError(Kind.DELAY, SmallError.INPUT, ""));
            all.shapes().add(early);
        }
        return new ErrorShapes(List.copyOf(all.errors()), List.copyOf(all.shapes()));
    }

    /** The same as spectra, from series. */
    ErrorShapes in(Evidence evidence, Window window) {
        return new ErrorShapes(errors, shapes.stream().map(series -> {
            double[][] spectra = new double[series.length][0];
            for (int o = 0; o < series.length; o++) {
                spectra[o] = series[o].length == 0 ? series[o] : window.spectrum(series[o], evidence.valid(o));
            }
            return spectra;
        }).toList());
    }

    private static boolean errs(Evidence evidence, int o) {
        Quantity quantity = evidence.outputs().get(o).quantity();
        return quantity == Quantity.ACCELERATION || quantity == Quantity.ANGULAR_RATE || evidence.onRig();
    }

    /** Of the first of outputs that are late together, what all read less while they grow. */
    private void addDelay(Evidence evidence, int o, double[][] early) {
        List<Integer> channels = Place.late(evidence, o);
        if (channels.get(0) == o && channels.stream().anyMatch(channel -> errs(evidence, channel))) {
            double[][] late = new double[early.length][0];
            channels.forEach(channel -> late[channel] = scaled(early[channel], -1));
            errors.add(new SmallError(Kind.DELAY, o, ""));
            shapes.add(late);
        }
    }

    /** How an accelerometer sits. */
    private void addPose(Evidence evidence, int o, double step) {
        Channel channel = evidence.outputs().get(o);
        for (Channel across : evidence.measured().companions(channel, Quantity.ACCELERATION)) {
            add(evidence, new SmallError(Kind.TILT, o, axis(across)), evidence.series(across));
            addSway(evidence, o, across);
        }
        addCentripetal(evidence, o, channel);
        for (Channel rate : evidence.measured().companions(channel, Quantity.ANGULAR_RATE)) {
            add(evidence, new SmallError(Kind.ARM, o, axis(rate)), slope(evidence.series(rate), step));
        }
    }

    /** What comes from the base's motion along a further axis is more or less, and early, as far as the model as it was given tells. */
    private void addAxis(Evidence evidence, int axis, double step) {
        String name = evidence.model().base().sensors().get(axis).toString();
        double[][] answer = answer(evidence, axis, axis);
        addOfBase(evidence, new SmallError(Kind.AXIS_GAIN, SmallError.INPUT, name), -1, answer);
        List<Channel> sensors = evidence.model().base().sensors();
        boolean oneClock = !evidence.onRig() && !evidence.standsForSimulation()
                && sensors.get(axis).location().equals(sensors.get(0).location());
        if (!oneClock) {
            addOfBase(evidence, new SmallError(Kind.AXIS_DELAY, SmallError.INPUT, name), 1,
                    Arrays.stream(answer).map(each -> slope(each, step)).toArray(double[][]::new));
        }
    }

    /** A sensor of the base that is tilted, or not where it should be, reads what the base does along its other axes. */
    private void addPoseOfBase(Evidence evidence, int axis) {
        List<Channel> sensors = evidence.model().base().sensors();
        for (int other = 0; other < sensors.size() && sensors.get(axis).quantity() == Quantity.ACCELERATION; other++) {
            boolean turns = sensors.get(other).quantity() == Quantity.ANGULAR_RATE;
            if (other != axis && (turns || sensors.get(other).quantity() == Quantity.ACCELERATION)) {
                String name = sensors.get(axis) + "_by_" + sensors.get(other);
                addOfBase(evidence, new SmallError(turns ? Kind.AXIS_ARM : Kind.AXIS_TILT, SmallError.INPUT, name), -1,
                        answer(evidence, axis, other));
            }
        }
    }

    private static double[][] answer(Evidence evidence, int axis, int as) {
        return Arrays.stream(new Simulator(evidence.whole()).ofAxis(evidence.model().assembly(), axis, as)).map(evidence.whole()::series)
                .toArray(double[][]::new);
    }

    /** @param series by output, of which an error of 1 adds this factor */
    private void addOfBase(Evidence evidence, SmallError error, double factor, double[][] series) {
        errors.add(error);
        shapes.add(Arrays.stream(series).map(each -> scaled(each, factor * error.deviation(evidence.measured().sample())))
                .toArray(double[][]::new));
    }

    private static String axis(Channel channel) {
        return String.valueOf(channel.axis());
    }

    /** A sensor that sways tilts, and sees the acceleration across times its angle: pitch for the fore-aft axis, roll for the lateral. */
    private void addSway(Evidence evidence, int output, Channel across) {
        char axis = across.axis() == 'x' ? 'y' : 'x';
        for (Channel rate : evidence.measured().companions(across, Quantity.ANGULAR_RATE)) {
            if (rate.axis() == axis) {
                double[] angle = integrated(evidence.series(rate), evidence.recording().clock().step());
                double[] a = evidence.series(across);
                for (int i = 0; i < angle.length; i++) {
                    angle[i] *= a[i];
                }
                add(evidence, new SmallError(Kind.SWAY, output, axis(across)), angle);
            }
        }
    }

    /** A sensor above the axis about which its place turns is pulled inwards: height times the square of the rate. */
    private void addCentripetal(Evidence evidence, int output, Channel channel) {
        List<Channel> rates = evidence.measured().companions(channel, Quantity.ANGULAR_RATE);
        if (!rates.isEmpty()) {
            double[] square = new double[evidence.measured(output).length];
            for (Channel rate : rates) {
                double[] w = evidence.series(rate);
                for (int i = 0; i < square.length; i++) {
                    square[i] -= w[i] * w[i];
                }
            }
            add(evidence, new SmallError(Kind.HEIGHT, output, ""), square);
        }
    }

    /** @param series that an error of 1 adds */
    private void add(Evidence evidence, SmallError error, double[] series) {
        double[][] own = new double[evidence.outputs().size()][0];
        own[error.owner()] = scaled(series, error.deviation(evidence.measured().sample()));
        errors.add(error);
        shapes.add(own);
    }

    /**
     * Adds a series that comes late.
     *
     * @param outputs how many there are
     * @param late samples
     */
    void addLate(SmallError error, int outputs, double[] series, int late, double factor) {
        double[][] own = new double[outputs][0];
        own[error.owner()] = new double[series.length];
        for (int i = late; i < series.length; i++) {
            own[error.owner()][i] = factor * series[i - late];
        }
        errors.add(error);
        shapes.add(own);
    }

    /**
     * Adds how a rig begins anew.
     *
     * @param owner an output, or {@link SmallError#INPUT} where it shows at all
     * @param shape series by output, an empty array where it adds nothing. Not a copy
     */
    void addStart(int owner, double[][] shape) {
        errors.add(new SmallError(Kind.START, owner, ""));
        shapes.add(shape);
    }

    /** These and others. */
    ErrorShapes and(ErrorShapes more) {
        return more.errors().isEmpty() ? this : new ErrorShapes(Stream.concat(errors.stream(), more.errors().stream()).toList(),
                Stream.concat(shapes.stream(), more.shapes().stream()).toList());
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

    private static double[] scaled(double[] series, double factor) {
        return Arrays.stream(series).map(value -> factor * value).toArray();
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
