package wbv.diagnosis.mechanism;

/** What is open of a number beside what a fit knows of it. */
public enum Doubt {
    /** A part of itself: what a law's formula leaves undone, and what is a factor of every reading. */
    SHARE,
    /** A clock's accuracy only. */
    NONE,
    /** As sharp as what happened at it. */
    MOMENT,
    /** What is a matter of a muscle's twitch as well: an answer to speed leads as a slower twitch lags. */
    LEAD,
    /** The small gain error that every sensor has, on top of which this one comes; likewise the others. */
    GAIN,
    DELAY,
    TILT,
    ARM
}
