package wbv.body.simulate;

import java.util.Optional;
import wbv.body.Assembly;
import wbv.body.SensorFault;
import wbv.body.Spectra;
import wbv.body.number.Numbers;

/** What a faulty sensor makes of the true reading, and of its derivatives. */
final class Sensing {

    /** Part of a line's power that a filter lets through at least where what was there is told [1]: a thousandth of it, below any noise. */
    private static final double LEAST = 1e-6;

    private final Excitation excitation;

    Sensing(Excitation excitation) {
        this.excitation = excitation;
    }

    /**
     * What a sensor of an assembly reports.
     *
     * @param slopes as for {@link #apply}. Modified.
     * @param from parameter that the first of them is to
     */
    double[] report(Assembly assembly, int output, double[] reading, double[][] slopes, int from) {
        double[] out = reading;
        int fault = assembly.faultIndex(output, 0) - from;
        for (SensorFault each : assembly.outputs().get(output).faults()) {
            out = apply(each, out, slopes, fault);
            fault += Numbers.values((Record) each).length;
        }
        return out;
    }

    /**
     * The part of a report that the sensor's other channels make, as they were recorded: late as they are, however late the sensor is.
     * Empty where there is none.
     */
    double[] recorded(Assembly assembly, int output) {
        double[] out = new double[0];
        for (SensorFault each : assembly.outputs().get(output).faults()) {
            if (out.length > 0) {
                out = apply(each, out, new double[0][], 0);
            } else if (readsOthers(each)) {
                out = add(each, new double[2 * excitation.omega().length]);
            }
        }
        return out;
    }

    private static boolean readsOthers(SensorFault fault) {
        return fault instanceof SensorFault.Misalignment || fault instanceof SensorFault.Turned || fault instanceof SensorFault.LeverArm;
    }

    /**
     * Applies one fault.
     *
     * @param reading spectrum of the true reading. Not modified.
     * @param slopes  its derivatives by parameter; become those of the faulty reading. Modified.
     * @param own     index of the fault's first own parameter in {@code slopes}
     * @return spectrum of the faulty reading
     */
    double[] apply(SensorFault fault, double[] reading, double[][] slopes, int own) {
        if (fault instanceof SensorFault.Clipping clipping) {
            return clip(clipping, reading, slopes, own);
        }
        if (fault instanceof SensorFault.Rectifying) {
            return rectify(reading, slopes);
        }
        if (fault instanceof SensorFault.Quantised steps) {   // on average over its steps it follows what it reads
            double[] x = excitation.series(reading);
            java.util.Arrays.setAll(x, i -> steps.level() + steps.step() * Math.rint((x[i] - steps.level()) / steps.step()));
            return excitation.spectrum(x);
        }
        if (fault instanceof SensorFault.Beside beside) {
            double[] out = reading.clone();
            Spectra.add(out, excitation.other(beside.channel()), 1);
            return out;
        }
        if (fault instanceof SensorFault.StiffeningMount mount) {
            return ride(mount, reading, slopes, own);
        }
        if (fault instanceof SensorFault.Late late && late.varies()) {
            return warp(late, reading, slopes, own);
        }
        double[] filter = filter(fault);
        for (int p = 0; p < slopes.length; p++) {
            slopes[p] = Spectra.product(filter, slopes[p]);
        }
        double[] out = add(fault, Spectra.product(filter, reading));
        double[] values = Numbers.values((Record) fault);
        for (int i = 0; i < values.length && slopes.length > 0; i++) {
            double h = 1e-5 * Math.max(Math.abs(values[i]), 1e-3);
            double kept = values[i];
            values[i] = kept + h;
            double[] high = shifted(fault, values, reading);
            values[i] = kept - h;
            double[] low = shifted(fault, values, reading);
            values[i] = kept;
            for (int k = 0; k < out.length; k++) {
                slopes[own + i][k] += (high[k] - low[k]) / (2 * h);
            }
        }
        return out;
    }

    /**
     * The true reading of which a fault made another: what came on top taken off, and its filter undone, but for lines that it does not
     * let through. Empty where no filter says it, as of a reading that was clipped.
     *
     * @param read spectrum of the faulty reading. Not modified.
     */
    Optional<double[]> undone(SensorFault fault, double[] read) {
        boolean filters = fault instanceof SensorFault.Late late && !late.varies() || fault instanceof SensorFault.MountResonance
                || fault instanceof SensorFault.AcCoupling || fault instanceof SensorFault.Gain || fault instanceof SensorFault.Bias
                || readsOthers(fault);
        if (!filters) {
            return Optional.empty();
        }
        double[] out = read.clone();
        Spectra.add(out, add(fault, new double[read.length]), -1);
        double[] filter = filter(fault);
        for (int k = 0; k < out.length; k += 2) {
            double size = filter[k] * filter[k] + filter[k + 1] * filter[k + 1];
            double re = size > LEAST ? (out[k] * filter[k] + out[k + 1] * filter[k + 1]) / size : 0;
            double im = size > LEAST ? (out[k + 1] * filter[k] - out[k] * filter[k + 1]) / size : 0;
            out[k] = re;
            out[k + 1] = im;
        }
        return Optional.of(out);
    }

    private double[] shifted(SensorFault fault, double[] values, double[] reading) {
        SensorFault other = (SensorFault) Numbers.with((Record) fault, values);
        return other instanceof SensorFault.Late late && late.varies()
                ? warped(late, reading) : add(other, Spectra.product(filter(other), reading));
    }

    /** The frequency response by which the true reading is multiplied. */
    private double[] filter(SensorFault fault) {
        double[] omega = excitation.omega();
        double[] out = new double[2 * omega.length];
        for (int k = 0; k < omega.length; k++) {
            out[2 * k] = 1;
            if (fault instanceof SensorFault.MountResonance mount) {
                double w0 = 2 * Math.PI * mount.frequency();
                double u = omega[k] / w0;
                double re = 1 - u * u;
                double im = 2 * mount.dampingRatio() * u;
                double size = re * re + im * im;
                out[2 * k] = (re + im * im) / size;
                out[2 * k + 1] = (im * re - im) / size;
            } else if (fault instanceof SensorFault.AcCoupling coupled) {
                double u = omega[k] / (2 * Math.PI * coupled.corner());
                out[2 * k] = u * u / (1 + u * u);
                out[2 * k + 1] = u / (1 + u * u);
            } else if (fault instanceof SensorFault.Delay delay) {
                out[2 * k] = Math.cos(omega[k] * delay.delay());
                out[2 * k + 1] = -Math.sin(omega[k] * delay.delay());
            } else if (fault instanceof SensorFault.Gain gain) {
                out[2 * k] = gain.factor();
            } else if (fault instanceof SensorFault.Misalignment tilt) {
                out[2 * k] = Math.sqrt(1 + Math.pow(Math.tan(tilt.towardsX()), 2) + Math.pow(Math.tan(tilt.towardsY()), 2));
            } else if (fault instanceof SensorFault.Turned turned) {
                out[2 * k] = 1 / Math.cos(turned.angle());
            }
        }
        return out;
    }

    /**
     * What comes on top of the filtered reading.
     *
     * @param reading Modified and returned.
     */
    private double[] add(SensorFault fault, double[] reading) {
        if (fault instanceof SensorFault.Bias bias) {
            double[] constant = new double[excitation.samples()];
            java.util.Arrays.fill(constant, bias.bias());
            Spectra.add(reading, excitation.spectrum(constant), 1);
        } else if (fault instanceof SensorFault.Misalignment tilt) {
            Spectra.add(reading, excitation.other(tilt.across()), Math.tan(tilt.towardsX()));
            Spectra.add(reading, excitation.other(tilt.beside()), Math.tan(tilt.towardsY()));
        } else if (fault instanceof SensorFault.Turned turned) {
            Spectra.add(reading, excitation.other(turned.across()), Math.tan(turned.angle()));
        } else if (fault instanceof SensorFault.LeverArm lever) {
            double[] omega = excitation.omega();
            double[] rate = excitation.other(lever.rate());
            for (int k = 0; k < omega.length; k++) {
                reading[2 * k] -= lever.arm() * omega[k] * rate[2 * k + 1];
                reading[2 * k + 1] += lever.arm() * omega[k] * rate[2 * k];
            }
        }
        return reading;
    }

    private double[] clip(SensorFault.Clipping clipping, double[] reading, double[][] slopes, int own) {
        double[] x = excitation.fineSeries(reading);
        double[] y = new double[x.length];
        double[] inside = new double[x.length];
        double[] below = new double[x.length];
        double[] above = new double[x.length];
        for (int j = 0; j < x.length; j++) {
            y[j] = Math.max(clipping.low(), Math.min(clipping.high(), x[j]));
            below[j] = x[j] < clipping.low() ? 1 : 0;
            above[j] = x[j] > clipping.high() ? 1 : 0;
            inside[j] = 1 - below[j] - above[j];
        }
        weigh(slopes, inside);
        if (slopes.length > 0) {
            Spectra.add(slopes[own], excitation.spectrumOfFine(below), 1);
            Spectra.add(slopes[own + 1], excitation.spectrumOfFine(above), 1);
        }
        return excitation.spectrumOfFine(y);
    }

    private double[] rectify(double[] reading, double[][] slopes) {
        double[] x = excitation.fineSeries(reading);
        double[] sign = new double[x.length];
        for (int j = 0; j < x.length; j++) {
            sign[j] = Math.signum(x[j]);
            x[j] = Math.abs(x[j]);
        }
        weigh(slopes, sign);
        return excitation.spectrumOfFine(x);
    }

    private double[] ride(SensorFault.StiffeningMount mount, double[] reading, double[][] slopes, int own) {
        double step = excitation.fineStep();
        double[] a = excitation.held(reading);
        MountMotion motion = new MountMotion(mount, step);
        double[] out = motion.reading(a);
        for (int p = 0; p < slopes.length; p++) {
            slopes[p] = excitation.spectrumOfFine(motion.answer(a, excitation.held(slopes[p])));
        }
        double[] values = Numbers.values(mount);
        for (int i = 0; i < values.length && slopes.length > 0; i++) {
            double h = 1e-4 * Math.max(Math.abs(values[i]), 1e-3);
            double kept = values[i];
            values[i] = kept + h;
            double[] high = new MountMotion(Numbers.with(mount, values), step).reading(a);
            values[i] = Math.max(kept - h, 0);
            double width = kept + h - values[i];
            double[] low = new MountMotion(Numbers.with(mount, values), step).reading(a);
            values[i] = kept;
            for (int j = 0; j < high.length; j++) {
                high[j] = (high[j] - low[j]) / width;
            }
            Spectra.add(slopes[own + i], excitation.spectrumOfFine(high), 1);
        }
        return excitation.spectrumOfFine(out);
    }

    private void weigh(double[][] slopes, double[] weight) {
        for (int p = 0; p < slopes.length; p++) {
            double[] series = excitation.fineSeries(slopes[p]);
            for (int j = 0; j < series.length; j++) {
                series[j] *= weight[j];
            }
            slopes[p] = excitation.spectrumOfFine(series);
        }
    }

    private double[] warp(SensorFault.Late late, double[] reading, double[][] slopes, int own) {
        for (int p = 0; p < slopes.length; p++) {
            slopes[p] = warped(late, slopes[p]);
        }
        double[] values = Numbers.values((Record) late);
        double[] slope = slopes.length > 0 ? interpolated(late, reading, true) : values;
        for (int i = 0; i < values.length && slopes.length > 0; i++) {
            double h = 1e-5 * Math.max(Math.abs(values[i]), 1e-3);
            double kept = values[i];
            values[i] = kept + h;
            SensorFault.Late high = (SensorFault.Late) Numbers.with((Record) late, values);
            values[i] = kept - h;
            SensorFault.Late low = (SensorFault.Late) Numbers.with((Record) late, values);
            values[i] = kept;
            double[] part = slope.clone();
            for (int j = 0; j < part.length; j++) {
                double t = j * excitation.fineStep();
                part[j] *= (high.at(t) - low.at(t)) / (2 * h);
            }
            Spectra.add(slopes[own + i], excitation.spectrumOfFine(part), 1);
        }
        return warped(late, reading);
    }

    private double[] warped(SensorFault.Late late, double[] reading) {
        return excitation.spectrumOfFine(interpolated(late, reading, false));
    }

    /** What was there as much earlier as it is late, by cubic interpolation of the fine series, or the interpolant's derivative to that. */
    private double[] interpolated(SensorFault.Late late, double[] reading, boolean slope) {
        double step = excitation.fineStep();
        double[] x = excitation.fineSeries(reading);
        double[] y = new double[x.length];
        for (int j = 0; j < x.length; j++) {
            double at = j - late.at(j * step) / step;
            int i = (int) Math.floor(at);
            if (i >= 1 && i + 2 < x.length) {
                double u = at - i;
                double one = 0.5 * (x[i + 1] - x[i - 1]);
                double two = 0.5 * (2 * x[i - 1] - 5 * x[i] + 4 * x[i + 1] - x[i + 2]);
                double three = 0.5 * (3 * (x[i] - x[i + 1]) + x[i + 2] - x[i - 1]);
                y[j] = slope ? -(one + u * (2 * two + 3 * three * u)) / step : x[i] + u * (one + u * (two + u * three));
            }
        }
        return y;
    }
}
