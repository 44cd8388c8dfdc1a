package wbv.filter;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** The ways to estimate a body, by the names that users give. */
public enum Method {

    /** The extended Kalman filter of textbooks: fixed noise, no gates, no alarm. What the others are measured against. */
    EKF("ekf", "extended Kalman filter, fixed noise"),
    /** The same, adapted: {@link BodyEstimator} as it is by itself. */
    EKF_ADWIN("ekf-adwin", "bank of extended Kalman filters that differ in how fast the body may wander"),
    /** Adapted likewise. */
    UNSCENTED("ukf", "unscented Kalman filter adapted by ADWIN"),
    /** Adapted likewise. */
    PARTICLE("particle", "bootstrap particle filter adapted by ADWIN"),
    /** The adapted extended filter within bounds from elsewhere, and within those of a body where there are none. */
    CONSTRAINED("constrained", "the same bank, projected into bounds"),
    /** Several of them. */
    FUSED("fused", "several of these, weighed by evidence");

    private final String word;
    private final String description;

    Method(String word, String description) {
        this.word = word;
        this.description = description;
    }

    /** The name, as users write it. */
    public String word() {
        return word;
    }

    /** What it is, in a few words. */
    public String description() {
        return description;
    }

    /** The method of a name; empty if there is none. */
    public static Optional<Method> named(String word) {
        return Arrays.stream(values()).filter(method -> method.word.equals(word.toLowerCase(Locale.ROOT))).findFirst();
    }

    /** All names. */
    public static List<String> words() {
        return Arrays.stream(values()).map(Method::word).toList();
    }
}
