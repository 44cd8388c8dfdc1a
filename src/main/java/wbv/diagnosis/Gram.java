package wbv.diagnosis;

/** Products of all pairs of long vectors: what least squares spend much of their time on. */
final class Gram {

    /** Numbers of each vector that are multiplied before the next ones are fetched: so many of all vectors stay near the processor. */
    private static final int BLOCK = 512;

    private Gram() { }

    /** @param vectors of the same length each. Not modified. @return symmetric */
    static double[][] of(double[][] vectors) {
        int n = vectors.length;
        int length = n == 0 ? 0 : vectors[0].length;
        double[][] out = new double[n][n];
        for (int from = 0; from < length; from += BLOCK) {
            int to = Math.min(length, from + BLOCK);
            for (int i = 0; i < n; i++) {
                int j = 0;
                for (; j + 3 <= i; j += 4) {
                    addFour(vectors, i, j, from, to, out[i]);
                }
                for (; j <= i; j++) {
                    out[i][j] += Fitter.dot(vectors[i], vectors[j], from, to);
                }
            }
        }
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < i; j++) {
                out[j][i] = out[i][j];
            }
        }
        return out;
    }

    /** Four at once, since each number of the one vector then is fetched once for all four. */
    private static void addFour(double[][] vectors, int i, int j, int from, int to, double[] row) {
        double[] a = vectors[i];
        double[] b0 = vectors[j];
        double[] b1 = vectors[j + 1];
        double[] b2 = vectors[j + 2];
        double[] b3 = vectors[j + 3];
        double s0 = 0;
        double s1 = 0;
        double s2 = 0;
        double s3 = 0;
        for (int k = from; k < to; k++) {
            double one = a[k];
            s0 += one * b0[k];
            s1 += one * b1[k];
            s2 += one * b2[k];
            s3 += one * b3[k];
        }
        row[j] += s0;
        row[j + 1] += s1;
        row[j + 2] += s2;
        row[j + 3] += s3;
    }
}
