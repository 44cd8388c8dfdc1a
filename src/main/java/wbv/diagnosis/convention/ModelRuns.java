package wbv.diagnosis.convention;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.Assembly;
import wbv.body.Model;
import wbv.body.Structure;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.search.Priors;
import wbv.signal.ScalarProduct;

/** A model run on an input with its stiffnesses, dampings and masses as they may be: each some factor of what was given. */
final class ModelRuns {

    /** Starts beside the given numbers on a rig, whose resonance may be missed by its width: as for fits of physics. */
    private static final double[][] SHIFTS = {{0, 1.6}, {0.8, 0}, {-0.8, 0}};

    private final Assembly assembly;
    private final Excitation excitation;
    private final Stretch stretch;
    /** Of the structure's values, those that are free. */
    private final int[] free;
    private final double[] deviation;
    private final List<double[]> starts;
    /** Where fits begin, by coordinates: several fits begin at each. */
    private final Map<List<Double>, Optional<Run>> begun = new ConcurrentHashMap<>();

    ModelRuns(Model model, Excitation excitation, Stretch stretch) {
        this.assembly = model.assembly();
        this.excitation = excitation;
        this.stretch = stretch;
        Structure structure = assembly.structure();
        double[] values = structure.values();
        int masses = 2 * structure.links();
        free = IntStream.range(0, values.length).filter(i -> values[i] > 0 && (i < masses || structure.sharing(i - masses).length > 0))
                .filter(i -> i < masses || !structure.held()).toArray();
        // Masses of a bench are known as its stiffnesses are.
        deviation = Arrays.stream(free).mapToDouble(i -> i < masses || model.isRig() ? Priors.NUMBER_DEVIATION : Baseline.MASS).toArray();
        starts = Stream.concat(Stream.of(shifted(0, 0)), Arrays.stream(model.isRig() && !model.driven() ? SHIFTS : new double[0][])
                .map(shift -> shifted(shift[0], shift[1]))).toList();
    }

    /**
     * What the model does.
     *
     * @param outputs spectra by output
     * @param slopes  derivatives to the logarithm of each number that is free, spectra by output
     * @param curvature products of these, by output and two numbers
     */
    record Run(double[][] outputs, double[][][] slopes, double[][][] curvature) {}

    /** Standard deviations of the logarithms of the numbers that are free [1]. Not a copy. */
    double[] deviation() {
        return deviation;
    }

    /** Where fits begin: at what was given, and beside it. Not a copy. */
    List<double[]> starts() {
        return starts;
    }

    /** Which of the numbers are dampings, and which stiffnesses: coordinates of a start with more or less of them. */
    private double[] shifted(double stiffness, double damping) {
        int links = assembly.structure().links();
        return Arrays.stream(free).mapToDouble(i -> i < links ? stiffness : i < 2 * links ? damping : 0).toArray();
    }

    /** As it was given. */
    Optional<Run> given() {
        return begun(new double[free.length]);
    }

    /**
     * With other numbers, remembered; empty where it leaves all bounds then.
     *
     * @param x as for {@link #at}. Not modified.
     */
    Optional<Run> begun(double[] x) {
        return begun.computeIfAbsent(Arrays.stream(x).boxed().toList(), any -> at(x));
    }

    /**
     * With other numbers; empty where it leaves all bounds then.
     *
     * @param x logarithm of each number over what was given. Not modified.
     */
    Optional<Run> at(double[] x) {
        double[] values = assembly.values();
        for (int i = 0; i < free.length; i++) {
            values[free[i]] *= Math.exp(x[i]);
        }
        Simulator.Response response = new Simulator(excitation).run(assembly.with(values), true);
        if (response.diverged()) {
            return Optional.empty();
        }
        double[][] outputs = Arrays.stream(response.outputs()).map(this::seen).toArray(double[][]::new);
        double[][][] slopes = new double[free.length][][];
        Parallel.each(free.length, i -> slopes[i] = Arrays.stream(response.slopes()[free[i]]).map(slope -> scaled(slope, values[free[i]]))
                .toArray(double[][]::new));
        double[][][] curvature = new double[outputs.length][free.length][free.length];
        Parallel.each(free.length, i -> {
            for (int o = 0; o < outputs.length; o++) {
                for (int j = 0; j < free.length; j++) {
                    curvature[o][i][j] = ScalarProduct.of(slopes[i][o], slopes[j][o]);
                }
            }
        });
        return Optional.of(new Run(outputs, slopes, curvature));
    }

    private double[] scaled(double[] slope, double value) {
        return slope.length == 0 ? new double[2 * stretch.lines()] : Arrays.stream(seen(slope)).map(x -> x * value).toArray();
    }

    private double[] seen(double[] spectrum) {
        return stretch.spectrum(excitation.series(spectrum));
    }
}
