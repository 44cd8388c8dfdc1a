package wbv.identify;

import java.io.Serializable;

/**
 * Orders of an ARMAX model {@code A(q)y = Σ B_i(q)u_i + C(q)e}.
 *
 * @param na    past outputs, &gt;= 0
 * @param nb    coefficients of each input, &gt;= 1
 * @param nc    past errors, &gt;= 0
 * @param delay samples before an input acts, &gt;= 0; 0 where the output answers in the same sample
 */
public record Orders(int na, int nb, int nc, int delay) implements Serializable {

    public Orders {
        if (na < 0 || nb < 1 || nc < 0 || delay < 0) {
            throw new IllegalArgumentException("orders must be na >= 0, nb >= 1, nc >= 0, delay >= 0: " + na + ", " + nb
                    + ", " + nc
                    + ", " + delay);
        }
    }

    /** A body that follows its input within the sample: as many zeros as poles, and as many of the noise. */
    public static Orders body(int poles) {
        return new Orders(poles, poles + 1, poles, 0);
    }

    /** Number of coefficients with this many inputs. */
    public int coefficients(int inputs) {
        return na + inputs * nb + nc;
    }

    /** Length of the state: the longest memory. */
    public int memory() {
        return Math.max(na, Math.max(nb + delay - 1, nc));
    }
}
