package wbv.identify;

import java.io.Serializable;

/**
 * Responses of one kind of body that differ in how fast they are: {@code y = Σ B_i(s/ω)/A(s/ω) u_i}, one set of coefficients for
 * all, and a pulsation ω for each. A body whose springs change together keeps its damping ratios and answers with ω alone.
 * Arrays are not copied: treat them as read-only.
 *
 * @param a     {@code A(σ) = σ^n + a_(n-1) σ^(n-1) + … + a_0}, ascending: a_0 … a_(n-1) [1], n long
 * @param b     numerators by input, ascending, in the output's unit over that of what acts
 * @param rates whether an input is an angular rate, of which the derivative acts
 */
public record ScaledResponse(double[] a, double[][] b, boolean[] rates) implements Serializable {

    public ScaledResponse {
        if (b.length == 0 || b.length != rates.length) {
            throw new IllegalArgumentException("a response needs inputs, and of each whether it is a rate: " + b.length
                    + ", " + rates.length);
        }
        for (int i = 0; i < b.length; i++) {
            int most = a.length + (rates[i] ? 0 : 1);
            if (b[i].length == 0 || b[i].length > most) {
                throw new IllegalArgumentException("numerator " + (i + 1) + " needs 1 to " + most
                        + " coefficients: " + b[i].length);
            }
        }
    }

    /**
     * The response of the body with this pulsation.
     *
     * @param omega [rad/s], &gt; 0
     */
    public TransferModel at(double omega) {
        int n = a.length;
        double[] down = new double[n];
        for (int k = 0; k < n; k++) {
            down[n - 1 - k] = a[k] * Math.pow(omega, n - k);
        }
        double[][] up = new double[b.length][];
        for (int i = 0; i < b.length; i++) {
            int more = rates[i] ? 1 : 0;
            up[i] = new double[b[i].length + more];
            for (int k = 0; k < b[i].length; k++) {
                up[i][b[i].length - 1 - k] = b[i][k] * Math.pow(omega, n - k);
            }
        }
        return new TransferModel(down, up);
    }
}
