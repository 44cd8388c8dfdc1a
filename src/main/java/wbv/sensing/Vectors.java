package wbv.sensing;

/** Arithmetic of three-vectors. */
final class Vectors {

    private Vectors() {}

    static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    static double length(double[] a) {
        return Math.sqrt(dot(a, a));
    }

    /** a × b, a new vector. */
    static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    /**
     * The direction of a vector, a new one.
     *
     * @throws IllegalArgumentException if it has none
     */
    static double[] unit(double[] a) {
        double length = length(a);
        if (a.length != 3 || !(length > 0) || Double.isInfinite(length)) {
            throw new IllegalArgumentException("a direction needs three numbers that are not all 0: "
                    + java.util.Arrays.toString(a));
        }
        return new double[] {a[0] / length, a[1] / length, a[2] / length};
    }

    static boolean known(double[] a) {
        return !Double.isNaN(a[0] + a[1] + a[2]);
    }
}
