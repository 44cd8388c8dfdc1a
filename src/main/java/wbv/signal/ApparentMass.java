package wbv.signal;

import java.util.OptionalDouble;

/**
 * Apparent mass: the force at the driving point over the acceleration there, {@code M = F/A} [kg], at every frequency.
 *
 * <p>A rigid body's is its mass at all frequencies; a person's is the sitting mass at low ones and peaks where the body
 * resonates.
 * The driving-point impedance is {@code Z = F/V = jω M} [N·s/m]. Arrays are not copied: treat them as read-only.
 *
 * @param frequency by bin, rising [Hz]
 * @param mass      M at each [kg]
 */
public record ApparentMass(double[] frequency, ComplexSeries mass) {

    /** Where a sitting mass is read off: people do not resonate there yet [Hz]. */
    private static final double STATIC = 0.5;
    private static final double STILL_STATIC = 1.5;

    public ApparentMass {
        if (frequency.length != mass.length()) {
            throw new IllegalArgumentException("as many masses as frequencies: " + mass.length() + " and " + frequency.length);
        }
    }

    /**
     * Without a mass that moves with the driving point between it and the load cell, such as the seat's top plate.
     *
     * @param plate [kg], &gt;= 0
     */
    public ApparentMass without(double plate) {
        if (!(plate >= 0) || Double.isInfinite(plate)) {
            throw new IllegalArgumentException("mass of the plate must be >= 0 kg: " + plate);
        }
        double[] re = mass.re().clone();
        for (int k = 0; k < re.length; k++) {
            re[k] -= plate;
        }
        return new ApparentMass(frequency, new ComplexSeries(re, mass.im()));
    }

    /** Driving-point impedance {@code jω M} [N·s/m]. Thesis: Eq. 2-6. */
    public ComplexSeries impedance() {
        double[] re = new double[frequency.length];
        double[] im = new double[frequency.length];
        for (int k = 0; k < re.length; k++) {
            double omega = 2 * Math.PI * frequency[k];
            re[k] = -omega * mass.im()[k];
            im[k] = omega * mass.re()[k];
        }
        return new ComplexSeries(re, im);
    }

    /**
     * The mass that sits there [kg]: |M| at the usable frequency nearest 0.5 Hz, of those below 1.5 Hz; empty if there is none.
     *
     * @param usable where M is backed by excitation. Not modified.
     */
    public OptionalDouble sitting(boolean[] usable) {
        int best = -1;
        for (int k = 0; k < frequency.length; k++) {
            if (usable[k] && frequency[k] <= STILL_STATIC
                    && (best < 0 || Math.abs(frequency[k] - STATIC) < Math.abs(frequency[best] - STATIC))) {
                best = k;
            }
        }
        return best < 0 ? OptionalDouble.empty() : OptionalDouble.of(mass.magnitude(best));
    }

    /**
     * |M| over the sitting mass [1], by frequency, which makes people of different mass comparable.
     *
     * @param sitting [kg], &gt; 0
     */
    public double[] normalised(double sitting) {
        if (!(sitting > 0)) {
            throw new IllegalArgumentException("sitting mass must be > 0 kg: " + sitting);
        }
        double[] ratio = mass.magnitudes();
        for (int k = 0; k < ratio.length; k++) {
            ratio[k] /= sitting;
        }
        return ratio;
    }
}
