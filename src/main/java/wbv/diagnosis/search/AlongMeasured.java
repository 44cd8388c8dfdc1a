package wbv.diagnosis.search;

import java.util.Arrays;
import java.util.stream.IntStream;
import wbv.body.Spectra;
import wbv.body.Structure;
import wbv.diagnosis.algebra.DampedEquations;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Projection;
import wbv.signal.ScalarProduct;

/**
 * What forces along the motion as it was measured leave of a residual, where the model's numbers and the sensors' errors follow: both make
 * up for what they can of a law that a model lacks.
 */
final class AlongMeasured {

    private final Directions directions;
    private final Fitter.State base;
    private final Structure structure;
    private final Projection errors;
    /** What each of the model's numbers does along the motion by all that it is, by coordinate; to first order what is no factor. */
    private final Followed[] carried;
    /** Their products. */
    private final double[][] products;
    /** What is left along the motion. */
    private final Followed left;

    /** @param directions at that fit */
    AlongMeasured(Directions directions, Fitter.State base, Motion motion) {
        this.directions = directions;
        this.base = base;
        this.structure = base.candidate().at(base.x()).structure();
        this.errors = Projection.ofAll(base);
        this.carried = IntStream.range(0, base.x().length).mapToObj(i -> followed(carried(i, motion))).toArray(Followed[]::new);
        this.products = Arrays.stream(carried).map(one -> Arrays.stream(carried).mapToDouble(one::product).toArray())
                .toArray(double[][]::new);
        this.left = followed(directions.along());
    }

    private double[] carried(int i, Motion motion) {
        Knob knob = base.candidate().knobs().get(i);
        int at = knob.slot().at();
        return knob.unit() != 0 || !knob.tied().isEmpty() ? base.slopes()[i] : switch (knob.slot().kind()) {
            case STIFFNESS -> directions.of(at, times(structure.stiffness()[at], motion.displacement(at)));
            case DAMPING -> directions.of(at, times(structure.damping()[at], motion.velocity(at)));
            case MASS -> Arrays.stream(structure.sharing(at))
                    .mapToObj(body -> directions.onBody(body, times(-structure.mass()[at], motion.accelerations()[body])))
                    .reduce(new double[base.slopes()[i].length], AlongMeasured::sum);
            default -> base.slopes()[i];
        };
    }

    private static double[] times(double factor, double[] x) {
        return Arrays.stream(x).map(value -> factor * value).toArray();
    }

    /** A new array. */
    static double[] sum(double[] x, double[] y) {
        double[] out = x.clone();
        Spectra.add(out, y, 1);
        return out;
    }

    /**
     * A change of the residual that the sensors' errors follow.
     *
     * @param vector whitened, as long as the residual
     * @param own    its products with the errors [1]
     * @param follow how the errors follow it [1]
     */
    record Followed(double[] vector, double[] own, double[] follow) {

        double product(Followed other) {
            return ScalarProduct.of(vector, other.vector) - ScalarProduct.of(own, other.follow);
        }
    }

    /** @param vector whitened, as long as the residual. Not copied, not modified. */
    Followed followed(double[] vector) {
        double[] own = errors.products(vector);
        return new Followed(vector, own, errors.errors(own));
    }

    /** What is left along the motion. */
    Followed left() {
        return left;
    }

    /** What each of the model's numbers does. A new array. */
    Followed[] carried() {
        return carried.clone();
    }

    /** How strong some directions are that leave least, those of the model's numbers first, of which something is known [1]. */
    double[] strengths(Followed[] directions, Followed residual) {
        double[][] gram = new double[directions.length][directions.length];
        double[] gradient = Arrays.stream(directions).mapToDouble(residual::product).toArray();
        for (int i = 0; i < directions.length; i++) {
            for (int j = 0; j <= i; j++) {
                boolean known = i < carried.length && directions[i] == carried[i] && directions[j] == carried[j];
                gram[i][j] = known ? products[i][j] : directions[i].product(directions[j]);
                gram[j][i] = gram[i][j];
            }
        }
        for (int i = 0; i < carried.length; i++) {
            double deviation = base.candidate().knobs().get(i).deviation();
            gram[i][i] += 1 / (deviation * deviation);
            gradient[i] += base.x()[i] / (deviation * deviation);
        }
        return Arrays.stream(DampedEquations.solve(gram, gradient)).map(s -> -s).toArray();
    }
}
