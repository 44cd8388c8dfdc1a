package wbv.diagnosis.mechanism;

import java.util.Arrays;
import java.util.List;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.Model;
import wbv.body.SensorFault;
import wbv.body.law.EngagingFriction;
import wbv.body.law.Law;
import wbv.body.law.Learned;
import wbv.body.law.Settling;
import wbv.body.law.SlowDrift;
import wbv.body.law.StepChange;

/** What a hypothesis adds. */
public sealed interface Addition {

    /** Whether naming it needs a free run. */
    default boolean runsFree() {
        return false;
    }

    /** Whether it answers some time after what it answers to. */
    default boolean isLate() {
        return false;
    }

    /** Whether it turns the model over, so that no first-order look can see what it does. */
    default boolean overturns() {
        return false;
    }

    /** Whether its numbers mean something by the clock alone. */
    default boolean byTheClock() {
        return false;
    }

    /** Whether the numbers of what a model has already mean something by the clock alone. */
    static boolean byTheClock(Assembly assembly) {
        return assembly.laws().stream().anyMatch(at -> byTheClock(at.law()))
                || assembly.drives().stream().anyMatch(at -> at.drive() instanceof Drive.Tone)
                || assembly.outputs().stream().flatMap(output -> output.faults().stream()).anyMatch(Addition::byTheClock);
    }

    private static boolean byTheClock(Law law) {
        return law instanceof Learned learned && learned.byTheClock() || law instanceof StepChange || law instanceof StepChange.Gradual
                || law instanceof SlowDrift || law instanceof Settling;
    }

    private static boolean byTheClock(SensorFault fault) {
        return fault instanceof SensorFault.WanderingDelay || fault instanceof SensorFault.Delay delay && delay.drift() != 0;
    }

    /** A fault of an output's sensor. */
    sealed interface OfSensor extends Addition {
        /** Index of the output. */
        int output();

        /** What its sensor does. */
        SensorFault fault();
    }

    /** A law in a link. */
    sealed interface OfLink extends Addition {
        /** Index of the link. */
        int link();

        /** The law, whose numbers mean nothing yet. */
        Law law();
    }

    /** A law in a link, with numbers of its own. */
    record InLink(int link, Law law) implements OfLink {

        @Override
        public boolean runsFree() {
            return !law.isLinear();
        }

        @Override
        public boolean isLate() {
            return law.lateness() > 0;
        }

        @Override
        public boolean overturns() {
            return law instanceof EngagingFriction;
        }

        @Override
        public boolean byTheClock() {
            return Addition.byTheClock(law);
        }
    }

    /** Another law in a link with the same numbers as the one before it, times factors. */
    record AlikeInLink(int link, Law law, List<Double> factors) implements OfLink {
        public AlikeInLink {
            factors = List.copyOf(factors);
        }

        /**
         * Its law's numbers, each in its unit.
         *
         * @param first numbers of the law before it, as many. Not modified.
         */
        double[] numbers(double[] first) {
            double[] out = first.clone();
            Arrays.setAll(out, i -> factors.get(i) * first[i]);
            return out;
        }
    }

    /** A drive in a link, or on a body where {@link Drive#actsOnBody}. */
    record Driven(int place, Drive drive) implements Addition {

        @Override
        public boolean byTheClock() {
            return drive instanceof Drive.Tone;
        }
    }

    /** A fault of one channel's sensor, with numbers of its own. */
    record AtSensor(int output, SensorFault fault) implements OfSensor {

        @Override
        public boolean overturns() {
            return fault instanceof SensorFault.Rectifying;
        }

        @Override
        public boolean byTheClock() {
            return Addition.byTheClock(fault);
        }
    }

    /**
     * The same fault of another channel of a device: it has no numbers of its own, but those of the sensor before it, times factors.
     *
     * @param device first output of the device, which need not have the fault
     */
    record Alike(int device, int output, SensorFault fault, List<Double> factors) implements OfSensor {
        public Alike {
            factors = List.copyOf(factors);
        }
    }

    /** A hidden mass on a body; its numbers are mass, stiffness and damping, and of a spring that stiffens the cubic term. */
    record Hidden(int body, Model.HiddenMode mode) implements Addition {

        @Override
        public boolean runsFree() {
            return mode.stiffening().isPresent();
        }
    }
}
