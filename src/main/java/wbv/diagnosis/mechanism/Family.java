package wbv.diagnosis.mechanism;

import java.util.Optional;

/** Kinds of mechanism, by what tells them apart from others. */
public enum Family {
    /** The model's own numbers. */
    NUMBERS(Family.LEVELS),
    /** Another force over deflection. */
    SPRING(Family.LEVELS),
    /** Another loss. */
    LOSS(Family.LEVELS),
    /** Ends that meet or part. */
    CONTACT("Repeat the ride with a weight added: it shifts a stop, a gap or a preload, and leaves "
            + "a spring's law as it is. Three levels, 1 : 4 apart, tell the rest."),
    /** Linear, by frequency: over a narrow band a spring and a dashpot of other numbers do nearly the same. */
    DYNAMIC("Record the same sitter relaxed and tensed, or a dummy: a muscle changes, a material does not."),
    /** What changes over time. */
    DRIFT("Repeat the first level at the end (A-B-A): what depends on the level comes back, a change stays."),
    /** Motion of other axes. */
    COUPLING("Shake one axis at a time: pure pitch (a nod for the head), then pure fore-aft, with the gyroscope on."),
    /** A force that does not come from the motion. */
    FORCE("Record a quiet trial: a force of its own stays, what answers the ride goes."),
    /** What a sensor makes of the motion. */
    SENSOR(Family.LEVELS),
    /** What is in no library. */
    UNLISTED(Family.LEVELS);

    /** What tells most things from most others. */
    public static final String LEVELS = "Repeat the ride at three or more levels, at least 1 : 4 apart: the effects grow "
            + "differently with amplitude.";
    private static final String BLOCKS = "Record longer at one level and look at blocks of ten seconds: a step has a moment, a drift has "
            + "none.";

    private final String experiment;

    Family(String experiment) {
        this.experiment = experiment;
    }

    /** What most of them call for by themselves. */
    public String experiment() {
        return experiment;
    }

    /** What settles two mechanisms of these families, neither of which knows better; empty where the families do not tell. */
    public static Optional<String> between(Family one, Family other) {
        if (one == DRIFT && other == DRIFT) {
            return Optional.of(BLOCKS);
        }
        if (one == COUPLING && other == COUPLING || one == DRIFT && other.isOfLink() || other == DRIFT && one.isOfLink()) {
            return Optional.of(one == COUPLING ? one.experiment : DRIFT.experiment);
        }
        if (!one.isOfLink() || !other.isOfLink() || one == DYNAMIC && other == DYNAMIC) {
            return Optional.empty();
        }
        boolean contact = one == CONTACT && (other == CONTACT || other == SPRING) || other == CONTACT && one == SPRING;
        return Optional.of(contact ? CONTACT.experiment : LEVELS);
    }

    private boolean isOfLink() {
        return this == SPRING || this == LOSS || this == CONTACT || this == DYNAMIC;
    }
}
