package wbv.diagnosis.picture;

import java.util.List;

/**
 * What the missing physics looks like in the recording: data to be drawn, taken from the measurement with as little assumed of
 * its cause as can be, and what was found beside it.
 *
 * @param title  what is drawn
 * @param x      what is drawn along
 * @param y      what is drawn up
 * @param trails what is drawn, in order
 * @param note   what the reader should know
 */
public record Portrait(String title, Scale x, Scale y, List<Trail> trails, String note) {

    /**
     * An axis.
     *
     * @param unit may be empty
     * @param log whether it is logarithmic
     */
    public record Scale(String label, String unit, boolean log) {
        static Scale of(String label, String unit) {
            return new Scale(label, unit, false);
        }
    }

    /** What a trail is. */
    public enum Kind {
        /** Single samples as the recording gives them. */
        SAMPLES,
        /** What the recording says on average, with its standard error. */
        MEAN,
        /** A measured curve over rising x. */
        MEASURED,
        /** What the law that was found says. */
        LAW,
        /** The same, as the sensors' band would show it. */
        LAW_IN_BAND,
        /** Something known to compare with. */
        REFERENCE
    }

    /**
     * Points or a curve. Arrays are not copied.
     *
     * @param x         by point, in the unit of its scale, rising for {@link Kind#MEASURED}
     * @param y         as many, in the unit of its scale; NaN is a gap
     * @param deviation standard error of each y, as many, in its unit; empty if not known
     */
    public record Trail(String name, Kind kind, double[] x, double[] y, double[] deviation) {
        public Trail {
            if (x.length != y.length || deviation.length != 0 && deviation.length != x.length) {
                throw new IllegalArgumentException(name + " needs as many y and deviations as x: " + x.length + ", " + y.length
                        + ", "
                        + deviation.length);
            }
        }

        static Trail samples(String name, double[] x, double[] y) {
            return new Trail(name, Kind.SAMPLES, x, y, new double[0]);
        }

        static Trail measured(String name, double[] x, double[] y, double[] deviation) {
            return new Trail(name, Kind.MEASURED, x, y, deviation);
        }

        static Trail law(String name, double[] x, double[] y) {
            return new Trail(name, Kind.LAW, x, y, new double[0]);
        }
    }

    public Portrait {
        trails = List.copyOf(trails);
    }
}
