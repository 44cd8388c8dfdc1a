package wbv.learn;

import com.github.javacliparser.FloatOption;
import com.github.javacliparser.IntOption;
import com.github.javacliparser.MultiChoiceOption;
import com.yahoo.labs.samoa.instances.Instance;
import java.util.Comparator;
import java.util.Locale;
import moa.classifiers.AbstractClassifier;
import moa.classifiers.Regressor;
import moa.core.Measurement;
import moa.core.StringUtils;
import wbv.identify.Orders;
import wbv.identify.Pole;
import wbv.identify.RecursiveArmax;

/**
 * MOA's face of {@link RecursiveArmax}: the class attribute is the output, all attributes but {@code t} are inputs. Predicts one
 * step ahead, from the outputs before; its poles are measurements. An instance with a missing value is passed over.
 */
public class RecursiveArmaxLearner extends AbstractClassifier implements Regressor {

    private static final long serialVersionUID = 1;
    private static final String TIME = "t";
    private static final double USUAL_RATE = 60;
    /** Where a seated body's main mode is looked for [Hz]. */
    private static final double MAIN = 5;

    public final IntOption polesOption = new IntOption("poles", 'p', "Order of A, of C and of every numerator.", 2, 1, 20);
    public final FloatOption memoryOption = new FloatOption("memory", 'w', "Samples after which a sample weighs 1/e.", 1800, 10, 1e12);
    public final MultiChoiceOption kindOption = new MultiChoiceOption("kind", 'm', "How it is estimated.",
            new String[] {"likelihood", "els"}, new String[] {"recursive maximum likelihood", "extended least squares"}, 0);

    private SampleTiming timing = new SampleTiming(USUAL_RATE);
    private RecursiveArmax model = new RecursiveArmax(RecursiveArmax.Kind.MAXIMUM_LIKELIHOOD, Orders.body(2), 1, USUAL_RATE, 1);
    private int[] inputs = new int[0];
    private double[] u = new double[0];
    private long passed;

    @Override
    public String getPurposeString() {
        return "An ARMAX model from all inputs to the class, sample by sample.";
    }

    @Override
    public void resetLearningImpl() {
        timing = new SampleTiming(USUAL_RATE);
        inputs = new int[0];
        passed = 0;
    }

    private void prepare(Instance instance) {
        if (inputs.length == 0) {
            inputs = java.util.stream.IntStream.range(0, instance.numAttributes())
                    .filter(i -> i != instance.classIndex() && !instance.attribute(i).name().equals(TIME)).toArray();
            if (inputs.length == 0) {
                throw new IllegalArgumentException("there is no attribute besides t and the class; ARMAX needs an input");
            }
            u = new double[inputs.length];
            model = fresh(USUAL_RATE);
        }
        for (int i = 0; i < inputs.length; i++) {
            u[i] = instance.value(inputs[i]);
        }
    }

    private RecursiveArmax fresh(double rate) {
        return new RecursiveArmax(kindOption.getChosenIndex() == 0 ? RecursiveArmax.Kind.MAXIMUM_LIKELIHOOD
                : RecursiveArmax.Kind.EXTENDED_LEAST_SQUARES, Orders.body(polesOption.getValue()), inputs.length, rate,
                1 - 1 / memoryOption.getValue());
    }

    @Override
    public void trainOnInstanceImpl(Instance instance) {
        prepare(instance);
        boolean timed = instance.attribute(0).name().equals(TIME);
        double t = timed ? instance.value(0) : Double.NaN;
        if (timing.learnsRate(t)) {
            model = fresh(timing.rate()); // one sample is lost
        }
        passed += timing.missingBefore(t);
        passed += Double.isNaN(model.step(u, instance.classValue())) ? 1 : 0;
    }

    /** The output as foreseen from this instance's inputs and everything before it; 0 where an input is missing. */
    @Override
    public double[] getVotesForInstance(Instance instance) {
        prepare(instance);
        double said = model.foresee(u);
        return new double[] {Double.isFinite(said) ? said : 0};
    }

    private Pole main() {
        return model.model().poles().modes().stream().min(Comparator.comparingDouble(pole -> Math.abs(Math.log(pole.frequency() / MAIN))))
                .orElse(new Pole(0, 0));
    }

    @Override
    protected Measurement[] getModelMeasurementsImpl() {
        Pole main = main();
        boolean none = main.im() == 0;
        return new Measurement[] {
            new Measurement("natural frequency [Hz]", none ? Double.NaN : main.frequency()),
            new Measurement("damping ratio [1]", none ? Double.NaN : main.damping()),
            new Measurement("one-step error sd", Math.sqrt(model.model().variance())),
            new Measurement("samples passed over", passed),
        };
    }

    @Override
    public void getModelDescription(StringBuilder out, int indent) {
        Pole main = main();
        StringUtils.appendIndented(out, indent, String.format(Locale.ROOT, "%s; %s", model.model(), main.im() == 0 ? "no mode"
                : String.format(Locale.ROOT, "natural frequency %.3f Hz, damping ratio %.3f", main.frequency(), main.damping())));
    }

    @Override
    public boolean isRandomizable() {
        return false;
    }
}
