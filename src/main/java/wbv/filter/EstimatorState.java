package wbv.filter;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import wbv.filter.drift.Alarm;
import wbv.filter.model.Adaptation;
import wbv.filter.model.Bounds;
import wbv.filter.model.Spec;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** An estimator's state with what it was made of in front, so that the bytes say all that is needed to go on. */
public final class EstimatorState {

    private EstimatorState() {}

    /**
     * Everything of an estimator, as bytes.
     *
     * @throws IllegalStateException if its alarm cannot be kept, its constraint is none that can be written down, or it does not adapt as
     * usual
     */
    public static byte[] of(Estimator estimator) {
        StateWriter out = new StateWriter();
        save(estimator.design(), out);
        save(estimator.spec(), out);
        out.put(estimator);
        return out.finish();
    }

    /**
     * The estimator of such bytes.
     *
     * @param name   of the bytes, for messages
     * @param bytes of {@link #of}. Not modified.
     * @param alarms makes the alarms, as they were
     * @throws wbv.recording.DataFault if the bytes are no estimator's
     */
    public static Estimator read(String name, byte[] bytes, Supplier<? extends Alarm> alarms) {
        StateReader in = new StateReader(name, bytes);
        try {
            EstimatorDesign design = design(in);
            Estimator estimator = design.estimator(spec(in), alarms);
            in.part(estimator);
            in.end();
            return estimator;
        } catch (IllegalArgumentException wrong) {
            throw in.other(wrong.getMessage());
        }
    }

    private static void save(EstimatorDesign design, StateWriter out) {
        out.put(design.method().word());
        out.put(design.degrees());
        out.put(design.particles());
        out.put(design.seed());
        out.put(design.skyhook());
        if (design.constraint() == Constraint.NONE) {
            out.put(0);
        } else if (design.constraint() instanceof FixedBounds fixed) {
            out.put(fixed.each().size());
            for (FixedBounds.Bound bound : fixed.each()) {
                out.put(bound.mode());
                out.put(bound.attribute().name());
                out.put(bound.low());
                out.put(bound.high());
            }
        } else {
            throw new IllegalStateException("a constraint of " + design.constraint().getClass().getName() + " cannot be written down");
        }
    }

    private static EstimatorDesign design(StateReader in) {
        String word = in.text();
        Method method = Method.named(word).orElseThrow(() -> in.other("there is no estimator '" + word + "'"));
        int degrees = in.integer();
        int particles = in.integer();
        long seed = in.count();
        boolean skyhook = in.flag();
        int bounds = in.integer(0, Bounds.MODES * Bounds.Attribute.values().length, "bounds");
        List<FixedBounds.Bound> each = new ArrayList<>();
        for (int i = 0; i < bounds; i++) {
            each.add(new FixedBounds.Bound(in.integer(), Bounds.Attribute.valueOf(in.text()), in.number(), in.number()));
        }
        return new EstimatorDesign(method, degrees, particles, seed, each.isEmpty() ? Constraint.NONE : new FixedBounds(each), skyhook);
    }

    private static void save(Spec spec, StateWriter out) {
        if (!spec.adaptation().equals(Adaptation.USUAL)) {
            throw new IllegalStateException("an adaptation other than the usual one cannot be written down");
        }
        out.put(spec.rate());
        out.put(spec.frequency());
        out.put(spec.damping());
        out.put(spec.inputNoise());
        out.put(spec.outputNoise());
        out.put(spec.drift());
    }

    private static Spec spec(StateReader in) {
        return new Spec(in.number(), in.number(), in.number(), in.number(), in.number(), in.number());
    }
}
