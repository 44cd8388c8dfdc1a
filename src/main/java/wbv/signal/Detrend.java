package wbv.signal;

/** What is taken out of a segment before its spectrum, so that a sensor's bias and drift do not leak into the lowest bins. */
public enum Detrend {
    /** Nothing. */
    NONE {
        @Override
        void apply(double[] segment) {}
    },
    /** The segment's mean. */
    MEAN {
        @Override
        void apply(double[] segment) {
            subtract(segment, 0);
        }
    },
    /** The least-squares straight line. */
    LINEAR {
        @Override
        void apply(double[] segment) {
            double centre = (segment.length - 1) / 2.0;
            double product = 0;
            double squares = 0;
            for (int n = 0; n < segment.length; n++) {
                product += (n - centre) * segment[n];
                squares += (n - centre) * (n - centre);
            }
            subtract(segment, product / squares);
        }
    };

    /**
     * The lowest bin that is free of what was taken out, or left in. A mean under Hann's window lies in bins 0 and 1. Taking a
     * line out takes a little of every slow motion too, which reappears in bin 2 some 38 dB down.
     */
    int firstBin() {
        return this == LINEAR ? 3 : 2;
    }

    /**
     * Takes the trend out.
     *
     * @param segment Modified.
     */
    abstract void apply(double[] segment);

    /** Takes out the mean and a line of this slope [per sample] that is zero at the centre. */
    private static void subtract(double[] segment, double slope) {
        double mean = 0;
        for (double value : segment) {
            mean += value;
        }
        mean /= segment.length;
        double centre = (segment.length - 1) / 2.0;
        for (int n = 0; n < segment.length; n++) {
            segment[n] -= mean + slope * (n - centre);
        }
    }
}
