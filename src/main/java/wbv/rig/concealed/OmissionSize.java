package wbv.rig.concealed;

import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleFunction;
import java.util.function.ToDoubleFunction;

/**
 * Sizes an omission so that the best linear chain misses a wanted part of an output's variance.
 *
 * @param omission as sized
 * @param share missed in the worst output
 * @param left missed variance by output [(m/s²)²]
 */
record OmissionSize(Omission omission, double share, double[] left) {

    private static final int ATTEMPTS = 6;
    private static final double NEAR = 1.25;
    /** An output more than this many times as lively as the linear one is no sitter. */
    private static final double WILD = 9;

    static OmissionSize of(OmissionRecipe recipe, RideScene scene, Imus imus, double wanted) {
        return sized(recipe.least(), recipe.most(), wanted, size -> look(recipe.of().apply(size), scene, imus), OmissionSize::share);
    }

    /**
     * What of a size between two shows as much as is wanted, or as near to it as a few attempts come.
     *
     * @param look what comes of a size
     * @param share how much that shows; more for a larger size
     */
    static <T> T sized(double least, double most, double wanted, DoubleFunction<T> look, ToDoubleFunction<T> share) {
        double low = Math.log(least);
        double high = Math.log(most);
        double size = 0.5 * (low + high);
        T best = look.apply(Math.exp(size));
        T tried = best;
        for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
            if (attempt > 0) {
                tried = look.apply(Math.exp(size));
            }
            double shown = share.applyAsDouble(tried);
            if (Math.abs(Math.log(shown / wanted)) < Math.abs(Math.log(share.applyAsDouble(best) / wanted))) {
                best = tried;
            }
            if (shown < wanted * NEAR && shown > wanted / NEAR) {
                break;
            }
            if (shown > wanted) {
                high = size;
            } else {
                low = size;
            }
            // The share goes roughly as the square of the size; never leave the bracket, never creep along its edge.
            double guess = size + 0.5 * Math.log(wanted / Math.min(1, shown));
            double margin = 0.1 * (high - low);
            size = Math.max(low + margin, Math.min(high - margin, guess));
        }
        return best;
    }

    static OmissionSize look(Omission omission, RideScene scene, Imus imus) {
        Setup setup = new Setup(scene.chain());
        omission.change().accept(setup);
        ChainPlant.Trace trace = scene.sketch(setup);
        List<String> places = scene.outputs();
        double[][] outputs = places.stream().map(place -> imus.vertical(setup, trace, place)).toArray(double[][]::new);
        double[] platform = imus.vertical(setup, trace, Chain.PLATFORM);
        double[] left = new double[outputs.length];
        double worst = 0;
        boolean sane = true;
        for (int o = 0; o < outputs.length; o++) {
            double calm = UniformSeries.rms(scene.calm().acceleration()[scene.chain().rider(places.get(o))]);
            double lively = UniformSeries.rms(outputs[o]) / calm;
            sane &= lively * lively < WILD;
        }
        if (!sane) {
            Arrays.fill(left, Double.POSITIVE_INFINITY);
            return new OmissionSize(omission, Double.MAX_VALUE, left);
        }
        int[] body = places.stream().mapToInt(place -> scene.chain().rider(place)).toArray();
        double[] share = new LinearFit(body, platform, outputs).left(scene.chain());
        for (int o = 0; o < outputs.length; o++) {
            double mean = UniformSeries.mean(outputs[o]);
            double square = Math.pow(UniformSeries.rms(outputs[o]), 2);
            left[o] = share[o] * square + mean * mean;
            worst = Math.max(worst, left[o] / square);
        }
        return new OmissionSize(omission, worst, left);
    }
}
