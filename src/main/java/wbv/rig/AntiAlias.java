package wbv.rig;

import java.util.Locale;
import java.util.function.Supplier;

/** How a sensor comes from its inner rate to its output rate. */
public enum AntiAlias {
    /**
     * The mean over one output interval, as strap-down integration gives it (the sensor sends velocity increments). It droops
     * as sinc(f / rate): 0.989 at 5 Hz and 60 Hz, and lets through 0.637 at half the rate.
     */
    BOXCAR,
    /** A windowed sinc, flat to 0.28 of the output rate and shut from 0.52; the output is twelve intervals late. */
    LINEAR,
    /** None: the value at the instant; everything up to the sensor's bandwidth folds back. */
    NONE;

    /** The word of this filter, such as {@code boxcar}. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** @throws IllegalArgumentException if there is no such filter */
    static AntiAlias parse(String word) {
        for (AntiAlias filter : values()) {
            if (filter.toString().equals(word)) {
                return filter;
            }
        }
        throw new IllegalArgumentException("an anti-alias filter is one of boxcar linear none: '" + word + "'");
    }

    /**
     * A maker of decimators.
     *
     * @param ticks inner samples in an output interval, &gt;= 1, not always whole
     */
    Supplier<Decimator> decimators(double ticks) {
        if (this == LINEAR) {
            WindowedSinc.Kernel kernel = new WindowedSinc.Kernel(ticks);
            return () -> new WindowedSinc(kernel);
        }
        return this == BOXCAR ? () -> new Boxcar(ticks) : Instant::new;
    }

    /**
     * The bandwidth of white noise at the output [Hz].
     *
     * @param rate output rate [Hz]
     * @param bandwidth of the sensor [Hz]
     */
    double noiseBandwidth(double rate, double bandwidth) {
        return switch (this) {
            case BOXCAR -> Math.min(rate / 2, bandwidth * Math.PI / 2);
            case LINEAR -> Math.min(rate * WindowedSinc.CUTOFF, bandwidth * Math.PI / 2);
            case NONE -> bandwidth * Math.PI / 2;
        };
    }

    /** The exact mean of the polyline through the inner samples since the last output. */
    private static final class Boxcar implements Decimator {
        private final double ticks;
        private double previous = Double.NaN;
        private double current = Double.NaN;
        private double whole;
        private double last;

        Boxcar(double ticks) {
            this.ticks = ticks;
        }

        @Override
        public void accept(double value) {
            previous = Double.isNaN(current) ? value : current;
            current = value;
            whole += last;
            last = (previous + current) / 2;
        }

        @Override
        public double take(double fraction) {
            double part = fraction * (previous + (current - previous) * fraction / 2);
            double mean = (whole + part) / ticks;
            whole = 0;
            last -= part;
            return mean;
        }
    }

    private static final class Instant implements Decimator {
        private double previous;
        private double current;

        @Override
        public void accept(double value) {
            previous = current;
            current = value;
        }

        @Override
        public double take(double fraction) {
            return previous + (current - previous) * fraction;
        }
    }
}
