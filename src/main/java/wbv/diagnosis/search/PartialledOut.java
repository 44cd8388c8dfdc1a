package wbv.diagnosis.search;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import wbv.diagnosis.algebra.Columns;
import wbv.diagnosis.algebra.JointStrengths;
import wbv.diagnosis.algebra.SymmetricFactor;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Normal;
import wbv.diagnosis.fit.Projection;
import wbv.signal.ScalarProduct;

/**
 * Directions in the whitened residual with all that may follow partialled out of them, the model's numbers and the sensors' errors (Frisch
 * and Waugh 1933, Lovell 1963): what is left of a direction is what nothing that is known already makes.
 */
public final class PartialledOut {

    private final Projection projection;
    private final Columns slopes;
    private final double[][] products;
    private final SymmetricFactor factor;
    private final double[] gradient;
    private final double[] residual;

    /** @param state a fit with slopes */
    PartialledOut(Fitter.State state) {
        Normal normal = new Normal(state);
        this.gradient = normal.gradient();
        this.residual = state.residual();
        this.slopes = new Columns(state.slopes());
        this.projection = normal.projection();
        this.products = normal.products();
        int n = gradient.length;
        DMatrixRMaj curvature = new DMatrixRMaj(n, n);
        double largest = IntStream.range(0, n).mapToDouble(i -> normal.curvature()[i][i]).max().orElse(0);
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                curvature.set(i, j, normal.curvature()[i][j] * (i == j ? 1 + 1e-9 : 1) + (i == j ? 1e-14 * largest : 0));
            }
        }
        // Where parameters can hardly be told apart a ridge decides between them; what they span together stays the same.
        Optional<SymmetricFactor> found = SymmetricFactor.of(curvature);
        for (double ridge = 1e-8; found.isEmpty(); ridge *= 10) {
            for (int i = 0; i < n; i++) {
                curvature.add(i, i, ridge * Math.max(curvature.get(i, i), 1e-300));
            }
            found = SymmetricFactor.of(curvature);
        }
        factor = found.get();
    }

    /**
     * What the model and the sensors' errors, which may all follow, leave of products of directions with each other and with the residual.
     *
     * @param directions whitened, as long as the residual each, to be asked for together: the errors' columns are long. Not copied, not
     *                   modified
     */
    public List<Rest> of(List<double[]> directions) {
        Columns all = new Columns(directions.toArray(double[][]::new));
        double[][] own = projection.products(all);
        double[][] cross = slopes.products(all);
        return IntStream.range(0, all.count()).mapToObj(i -> rest(all.get(i), own[i], cross[i])).toList();
    }

    /** @param cross products with the slopes, as if no error followed. Modified. */
    private Rest rest(double[] direction, double[] own, double[] cross) {
        double[] follow = projection.errors(own);
        for (int p = 0; p < cross.length; p++) {
            cross[p] -= ScalarProduct.of(follow, products[p]);
        }
        double[] held = factor.solve(cross);
        return new Rest(direction, own, follow, cross, held, ScalarProduct.of(direction, residual) - ScalarProduct.of(held, gradient));
    }

    /**
     * A direction with its products with all that may follow.
     *
     * @param direction whitened, as long as the residual
     * @param own       its products with the sensors' errors [1], one an error
     * @param follow    how the errors follow it [1], one an error
     * @param cross     its products with the slopes, the errors following [1], one a knob
     * @param held      how the knobs follow it [1], one a knob
     * @param gradient  its product with what is left of the residual [1]
     */
    public record Rest(double[] direction, double[] own, double[] follow, double[] cross, double[] held, double gradient) {

        double product(Rest other) {
            return ScalarProduct.of(direction, other.direction) - ScalarProduct.of(follow, other.own) - ScalarProduct.of(cross, other.held);
        }

        double square() {
            return product(this);
        }

        /** Whether the model can nearly make it itself. */
        public boolean isOld() {
            return !(square() > JointStrengths.LEAST_NEW * ScalarProduct.of(direction, direction));
        }
    }
}
