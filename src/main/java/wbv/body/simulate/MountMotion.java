package wbv.body.simulate;

import wbv.body.SensorFault;

/**
 * How a sensor moves on a mount that stiffens, step by step (Runge and Kutta's fourth order), and how that answers to what changes a
 * little.
 */
final class MountMotion {

    /** Largest step over a radian of the mount [rad]. */
    private static final double FINE = 0.2;

    private final double spring;
    private final double loss;
    private final double cubic;
    private final double step;
    private final int parts;

    /** @param step of the series [s] */
    MountMotion(SensorFault.StiffeningMount mount, double step) {
        double omega = 2 * Math.PI * mount.frequency();
        this.spring = omega * omega;
        this.loss = 2 * mount.dampingRatio() * omega;
        this.cubic = mount.cubic();
        this.parts = (int) Math.ceil(omega * step / FINE);
        this.step = step / parts;
    }

    /**
     * What the sensor reads, by sample.
     *
     * @param a acceleration of what it sits on [m/s²]. Not modified.
     */
    double[] reading(double[] a) {
        double[] out = new double[a.length];
        double x = 0;
        double v = 0;
        for (int i = 0; i < a.length; i++) {
            out[i] = -loss * v - spring * x * (1 + cubic * x * x);
            double slope = i + 1 < a.length ? (a[i + 1] - a[i]) / parts : 0;
            for (int part = 0; part < parts; part++) {
                double from = a[i] + part * slope;
                double b1 = bend(x, v, from);
                double v2 = v + step / 2 * b1;
                double b2 = bend(x + step / 2 * v, v2, from + slope / 2);
                double v3 = v + step / 2 * b2;
                double b3 = bend(x + step / 2 * v2, v3, from + slope / 2);
                double v4 = v + step * b3;
                double b4 = bend(x + step * v3, v4, from + slope);
                x += step / 6 * (v + 2 * v2 + 2 * v3 + v4);
                v += step / 6 * (b1 + 2 * b2 + 2 * b3 + b4);
            }
        }
        return out;
    }

    private double bend(double x, double v, double a) {
        return -a - loss * v - spring * x * (1 + cubic * x * x);
    }

    /**
     * What the sensor reads more where what it sits on accelerates a little more: exact, as every stage of a step is followed.
     *
     * @param more by sample [m/s²]. Not modified.
     */
    double[] answer(double[] a, double[] more) {
        double[] out = new double[a.length];
        double x = 0;
        double v = 0;
        double dx = 0;
        double dv = 0;
        for (int i = 0; i < a.length; i++) {
            out[i] = -loss * dv - spring * (1 + 3 * cubic * x * x) * dx;
            boolean last = i + 1 == a.length;
            double slope = last ? 0 : (a[i + 1] - a[i]) / parts;
            double rise = last ? 0 : (more[i + 1] - more[i]) / parts;
            for (int part = 0; part < parts; part++) {
                double from = a[i] + part * slope;
                double with = more[i] + part * rise;
                double b1 = bend(x, v, from);
                double d1 = answer(x, dx, dv, with);
                double x2 = x + step / 2 * v;
                double v2 = v + step / 2 * b1;
                double dv2 = dv + step / 2 * d1;
                double b2 = bend(x2, v2, from + slope / 2);
                double d2 = answer(x2, dx + step / 2 * dv, dv2, with + rise / 2);
                double x3 = x + step / 2 * v2;
                double v3 = v + step / 2 * b2;
                double dv3 = dv + step / 2 * d2;
                double b3 = bend(x3, v3, from + slope / 2);
                double d3 = answer(x3, dx + step / 2 * dv2, dv3, with + rise / 2);
                double x4 = x + step * v3;
                double v4 = v + step * b3;
                double dv4 = dv + step * d3;
                double b4 = bend(x4, v4, from + slope);
                double d4 = answer(x4, dx + step * dv3, dv4, with + rise);
                dx += step / 6 * (dv + 2 * dv2 + 2 * dv3 + dv4);
                dv += step / 6 * (d1 + 2 * d2 + 2 * d3 + d4);
                x += step / 6 * (v + 2 * v2 + 2 * v3 + v4);
                v += step / 6 * (b1 + 2 * b2 + 2 * b3 + b4);
            }
        }
        return out;
    }

    private double answer(double x, double dx, double dv, double da) {
        return -da - loss * dv - spring * (1 + 3 * cubic * x * x) * dx;
    }
}
