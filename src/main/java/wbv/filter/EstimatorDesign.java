package wbv.filter;

import java.io.Serializable;
import java.util.function.Supplier;
import wbv.filter.drift.Alarm;
import wbv.filter.model.BodyModel;
import wbv.filter.model.Bounds;
import wbv.filter.model.OneDegree;
import wbv.filter.model.SkyhookDegree;
import wbv.filter.model.Spec;
import wbv.filter.model.TwoDegrees;

/**
 * Which estimator, beside what {@link Spec} says of sensors and start.
 *
 * @param method     how it works
 * @param degrees    degrees of freedom of the body, 1 or 2
 * @param particles  of a particle filter, {@value #LEAST_PARTICLES} to {@value #MOST_PARTICLES}
 * @param seed       of a particle filter's random numbers
 * @param constraint what is known of the body from elsewhere; taken by {@link Method#CONSTRAINED} alone
 * @param skyhook    whether part of the damping may act against rest; one degree of freedom and {@link Method#CONSTRAINED} alone
 */
public record EstimatorDesign(Method method, int degrees, int particles, long seed, Constraint constraint, boolean skyhook)
        implements Serializable {

    /** Fewest particles of a filter. */
    public static final int LEAST_PARTICLES = 50;
    /** Most particles of a filter. */
    public static final int MOST_PARTICLES = 1_000_000;
    /** Particles where nobody says how many. */
    public static final int USUAL_PARTICLES = 1000;

    public EstimatorDesign {
        if (degrees < 1 || degrees > Bounds.MODES) {
            throw new IllegalArgumentException("degrees of freedom must be 1 or 2: " + degrees);
        }
        if (particles < LEAST_PARTICLES || particles > MOST_PARTICLES) {
            throw new IllegalArgumentException("particles must be " + LEAST_PARTICLES + " to " + MOST_PARTICLES + ": "
                    + particles);
        }
        if (skyhook && (degrees != 1 || method != Method.CONSTRAINED)) {
            throw new IllegalArgumentException("a skyhook damper is for the estimator '" + Method.CONSTRAINED.word()
                    + "' of one degree of freedom");
        }
        if (constraint != Constraint.NONE && method != Method.CONSTRAINED) {
            throw new IllegalArgumentException("bounds are for the estimator '" + Method.CONSTRAINED.word() + "', not for '"
                    + method.word() + "'");
        }
    }

    /** All damping acts against the base. */
    public EstimatorDesign(Method method, int degrees, int particles, long seed, Constraint constraint) {
        this(method, degrees, particles, seed, constraint, false);
    }

    /** One degree of freedom, no constraint. */
    public static EstimatorDesign of(Method method) {
        return new EstimatorDesign(method, 1, USUAL_PARTICLES, 1, Constraint.NONE);
    }

    /** Part of the damping may act against rest; how much is estimated, or bounded by {@link Bounds.Attribute#BASE_SHARE}. */
    public EstimatorDesign withSkyhook() {
        return new EstimatorDesign(method, degrees, particles, seed, constraint, true);
    }

    /** The same for a body of 1 or 2 degrees of freedom. */
    public EstimatorDesign withDegrees(int number) {
        return new EstimatorDesign(method, number, particles, seed, constraint, skyhook);
    }

    /** The same with other particles, {@value #LEAST_PARTICLES} to {@value #MOST_PARTICLES}. */
    public EstimatorDesign withParticles(int number) {
        return new EstimatorDesign(method, degrees, number, seed, constraint, skyhook);
    }

    /** The same with other random numbers. */
    public EstimatorDesign withSeed(long number) {
        return new EstimatorDesign(method, degrees, particles, number, constraint, skyhook);
    }

    /**
     * The same within bounds.
     *
     * @throws IllegalArgumentException unless it is {@link Method#CONSTRAINED}
     */
    public EstimatorDesign within(Constraint bounds) {
        return new EstimatorDesign(method, degrees, particles, seed, bounds, skyhook);
    }

    /** The same design for another method, without the constraint. */
    EstimatorDesign by(Method other) {
        return new EstimatorDesign(other, degrees, particles, seed, Constraint.NONE);
    }

    /**
     * The estimator.
     *
     * @param alarms makes an alarm for each filter in it
     */
    public Estimator estimator(Spec spec, Supplier<? extends Alarm> alarms) {
        return method == Method.FUSED ? new FusedEstimator(spec, this, alarms) : new BodyEstimator(spec, alarms.get(), this);
    }

    /** A filter and what keeps it within bounds; one that may leave those of a body begins anew when it does. */
    record Confined(BodyFilter filter, Confinement confinement) {

        private static Confined free(BodyFilter filter) {
            return new Confined(filter, new Confinement.Free());
        }

        private static Confined within(Constraint constraint, BodyFilter filter) {
            return new Confined(filter, new Confinement.Within(filter, constraint));
        }
    }

    Confined filter(Spec spec, double offsetDecay) {
        return switch (method) {
            case PARTICLE -> Confined.free(new ParticleFilter(spec, model(spec, true), model(spec, false), offsetDecay, particles,
                    seed));
            case EKF -> Confined.free(new TextbookFilter(spec, model(spec, true), offsetDecay));
            case EKF_ADWIN -> Confined.free(bank(spec, offsetDecay));
            case CONSTRAINED -> Confined.within(constraint, bank(spec, offsetDecay));
            case UNSCENTED -> Confined.within(constraint, new JointFilter(spec, model(spec, true),
                    new Unscented(model(spec, false), offsetDecay), offsetDecay));
            case FUSED -> throw new IllegalArgumentException("a fusion is not one filter");
        };
    }

    private Bank bank(Spec spec, double offsetDecay) {
        return new Bank(spec, model(spec, false), offsetDecay, drift -> extended(spec, offsetDecay, drift));
    }

    private JointFilter extended(Spec spec, double offsetDecay, double wanders) {
        BodyModel model = model(spec, true);
        return new JointFilter(spec, model, Linearised.of(model, offsetDecay), offsetDecay, wanders);
    }

    private BodyModel model(Spec spec, boolean slopes) {
        return skyhook ? new SkyhookDegree(spec, slopes) : degrees == 1 ? new OneDegree(spec, slopes) : new TwoDegrees(spec, slopes);
    }
}
