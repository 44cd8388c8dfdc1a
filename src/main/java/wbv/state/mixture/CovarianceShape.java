package wbv.state.mixture;

import java.util.Locale;

/** What a covariance may be. */
public enum CovarianceShape {
    /** Any positive definite matrix. */
    FULL,
    /** Features independent within a component. */
    DIAGONAL;

    /** The word of this shape, such as {@code full}. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
