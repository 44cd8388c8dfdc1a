package wbv.rig;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.ejml.data.Complex_F64;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.EigenDecomposition_F64;

/**
 * The modes of x' = A x: every pair of poles s gives ω² = s1 s2 and ζ = -(s1 + s2) / 2ω.
 *
 * @param list modes in rising order of natural frequency
 */
record Modes(List<Mode> list) {

    /**
     * A mode.
     *
     * @param zeta damping ratio
     * @param omega undamped natural frequency [rad/s]
     */
    record Mode(double zeta, double omega) {}

    /** @param a n by n, n even. Not modified. */
    static Modes of(double[][] a) {
        EigenDecomposition_F64<DMatrixRMaj> decomposition = DecompositionFactory_DDRM.eig(a.length, false);
        if (!decomposition.decompose(new DMatrixRMaj(a))) {
            throw new IllegalStateException("no eigenvalues of a " + a.length + " by " + a.length + " matrix");
        }
        List<Mode> modes = new ArrayList<>();
        List<Double> real = new ArrayList<>();
        for (int i = 0; i < a.length; i++) {
            Complex_F64 pole = decomposition.getEigenvalue(i);
            if (pole.imaginary > 0) {
                double omega = Math.sqrt(pole.real * pole.real + pole.imaginary * pole.imaginary);
                modes.add(new Mode(-pole.real / omega, omega));
            } else if (pole.imaginary == 0) {
                real.add(pole.real);
            }
        }
        real.sort(Comparator.reverseOrder());
        for (int i = 0; i + 1 < real.size(); i += 2) {
            double omega = Math.sqrt(real.get(i) * real.get(i + 1));
            modes.add(new Mode(-(real.get(i) + real.get(i + 1)) / (2 * omega), omega));
        }
        modes.sort(Comparator.comparingDouble(Mode::omega));
        return new Modes(List.copyOf(modes));
    }

    /** ζ and ω of the first modes, one after the other: 2 times count values. */
    double[] pairs(int count) {
        double[] pairs = new double[2 * count];
        for (int i = 0; i < count; i++) {
            pairs[2 * i] = list.get(i).zeta();
            pairs[2 * i + 1] = list.get(i).omega();
        }
        return pairs;
    }
}
