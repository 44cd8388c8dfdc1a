package wbv.diagnosis.search;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.Spectra;
import wbv.body.Structure;
import wbv.diagnosis.algebra.Columns;
import wbv.diagnosis.algebra.DampedEquations;
import wbv.diagnosis.algebra.DirectionProducts;
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

    private final Fitter.State base;
    private final Projection errors;
    /** What each of the model's numbers does, by coordinate. */
    private final Followed[] carried;
    /** Their products. */
    private final double[][] gramOfCarried;
    /** What is left along the motion. */
    private final Followed left;

    /**
     * The model's numbers do what they do along the motion by all that they are; to first order what is no factor.
     *
     * @param directions at that fit
     * @param errors     of sensors, of which those at a bound are asked beside {@link #directed}: a sensor that is turned by half a radian
     *                   errs by thirty standard deviations, whose squares are next to nothing beside a mismatch
     */
    AlongMeasured(Directions directions, Fitter.State base, Motion motion, Projection errors) {
        this(base, errors, directions.along(), carried(directions, base, motion));
    }

    private AlongMeasured(Fitter.State base, Projection errors, double[] left, Stream<double[]> carried) {
        this.base = base;
        this.errors = errors;
        this.left = followed(left);
        this.carried = carried.map(this::followed).toArray(Followed[]::new);
        this.gramOfCarried = Arrays.stream(this.carried)
                .map(one -> Arrays.stream(this.carried).mapToDouble(one::product).toArray()).toArray(double[][]::new);
    }

    /** The same where other errors of sensors follow. */
    AlongMeasured with(Projection others) {
        return new AlongMeasured(base, others, left.vector(), Arrays.stream(carried).map(Followed::vector));
    }

    /**
     * The same where the model's numbers do to first order what they do as the model moves: sensors that err by a hundredth take them far
     * along a motion that is measured, and a law that is missing far as the model moves.
     */
    AlongMeasured asModelled() {
        return new AlongMeasured(base, errors, left.vector(), Arrays.stream(base.slopes()));
    }

    private static Stream<double[]> carried(Directions directions, Fitter.State base, Motion motion) {
        Structure structure = base.candidate().at(base.x()).structure();
        return IntStream.range(0, base.x().length).mapToObj(i -> {
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
        });
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

    /**
     * How strong some directions are that leave least, those of the model's numbers first, of which something is known [1].
     *
     * @param directions of which those of the model's numbers may be others than {@link #carried}
     */
    double[] strengths(Followed[] directions, Followed residual) {
        double[][] gram = new double[directions.length][directions.length];
        double[] gradient = Arrays.stream(directions).mapToDouble(residual::product).toArray();
        for (int i = 0; i < directions.length; i++) {
            for (int j = 0; j <= i; j++) {
                boolean known = i < carried.length && directions[i] == carried[i] && directions[j] == carried[j];
                gram[i][j] = known ? gramOfCarried[i][j] : directions[i].product(directions[j]);
                gram[j][i] = gram[i][j];
            }
        }
        addKnown(gram, gradient);
        return Arrays.stream(DampedEquations.solve(gram, gradient)).map(s -> -s).toArray();
    }

    /** Adds what is known of the model's numbers. */
    private void addKnown(double[][] gram, double[] gradient) {
        for (int i = 0; i < carried.length; i++) {
            double deviation = base.candidate().knobs().get(i).deviation();
            gram[i][i] += 1 / (deviation * deviation);
            gradient[i] += base.x()[i] / (deviation * deviation);
        }
    }

    /**
     * Moves the model's numbers.
     *
     * @param x coordinates of a candidate on top of the base [1], one a knob. Modified.
     * @param strengths of what each of the model's numbers does [1]. Not modified.
     */
    void move(double[] x, double[] strengths) {
        for (int i = 0; i < carried.length; i++) {
            Knob knob = base.candidate().knobs().get(i);
            double value = knob.unit() == 0 ? knob.value(x[i]) * (1 + strengths[i]) : knob.value(x[i] + strengths[i]);
            x[i] = knob.coordinate(Math.max(knob.value(knob.low()), value));
        }
    }

    /**
     * Products of directions where the model's numbers follow, too.
     *
     * @param directions and after them the errors that stand at a bound
     * @param held       how the numbers follow each [1]
     * @param alone      how they follow what is left [1]
     */
    record Products(DirectionProducts directions, double[][] held, double[] alone) {

        /** How strong what each of the model's numbers does is beside some directions [1]. */
        double[] numbers(DirectionProducts.Together beside) {
            int[] which = beside.which();
            double[] strengths = beside.joint().strengths();
            double[] out = new double[alone.length];
            Arrays.setAll(out, k -> -alone[k] - IntStream.range(0, which.length).mapToDouble(i -> strengths[i] * held[which[i]][k]).sum());
            return out;
        }
    }

    /**
     * Some directions that the sensors' errors follow.
     *
     * @param follow how the errors follow each [1]
     * @param each   products of two [1]
     * @param most   how strong the last of them may be, which are errors that stand at a bound, in standard deviations
     */
    record Directed(Columns columns, double[][] follow, double[][] each, double[] most) {}

    /**
     * Directions, and the errors that stand at a bound after them.
     *
     * @param groups directions that are asked together, whitened, as long as the residual each. Not copied, not modified
     * @param across whether those of two groups are too; else their products are no numbers
     */
    Directed directed(List<List<double[]>> groups, boolean across) {
        Columns columns = new Columns(
                Stream.concat(groups.stream().flatMap(List::stream), errors.atBound().stream()).toArray(double[][]::new));
        double[][] own = errors.products(columns);
        double[][] follow = Arrays.stream(own).map(errors::errors).toArray(double[][]::new);
        double[][] each = across ? columns.gram() : DirectionProducts.within(columns,
                groups.stream().mapToInt(List::size).toArray());
        subtract(own, follow, each);
        for (int i = each.length - errors.bounds().length; i < each.length; i++) {
            each[i][i]++;   // what is known of an error beforehand
        }
        return new Directed(columns, follow, each, errors.bounds());
    }

    /** @param from each product of one with one of the other is taken. Modified. */
    private static void subtract(double[][] one, double[][] other, double[][] from) {
        for (int i = 0; i < from.length; i++) {
            for (int j = 0; j < from.length; j++) {
                from[i][j] -= ScalarProduct.of(one[i], other[j]);
            }
        }
    }

    /** Of some directions, which are not modified. */
    Products products(Directed directed) {
        Columns columns = directed.columns();
        double[][] follow = directed.follow();
        double[][] each = Arrays.stream(directed.each()).map(double[]::clone).toArray(double[][]::new);
        double[][] numbers = Arrays.stream(gramOfCarried).map(double[]::clone).toArray(double[][]::new);
        double[] gradient = Arrays.stream(carried).mapToDouble(left::product).toArray();
        addKnown(numbers, gradient);
        double[][] cross = columns.products(new Columns(Arrays.stream(carried).map(Followed::vector).toArray(double[][]::new)));
        double[] rest = columns.products(left.vector());
        double[][] across = new double[each.length][carried.length];
        double[][] held = new double[each.length][];
        for (int i = 0; i < each.length; i++) {
            for (int k = 0; k < carried.length; k++) {
                across[i][k] = cross[k][i] - ScalarProduct.of(follow[i], carried[k].own());
            }
            held[i] = DampedEquations.solve(numbers, across[i]);
            rest[i] -= ScalarProduct.of(follow[i], left.own()) + ScalarProduct.of(held[i], gradient);
        }
        subtract(across, held, each);
        return new Products(new DirectionProducts(each, rest, directed.most()), held, DampedEquations.solve(numbers, gradient));
    }
}
