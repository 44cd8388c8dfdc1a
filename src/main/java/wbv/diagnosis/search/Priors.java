package wbv.diagnosis.search;

import java.util.Map;

/**
 * What is believed before a recording is seen, and from when on something is said, as numbers with units and sources. How sharply fits tell
 * is not believed but measured: {@link Calibration}.
 *
 * @param held     probability from which on one name is the answer, and that the names of a set hold together [1]
 * @param unlisted part of a mismatch that the best of the library is supposed to leave where the right law is none of it [1]: more than any
 *                 of 101 right names left, of which 95 left a tenth at most, and the worst 0.24
 * @param form     part of its own force to which a formula that is right may be wrong [1]: right families of other formulas left a tenth at
 *                 most
 * @param carried  part of what is missing that has to go with a law on data that were not used, for the law to be claimed [1]: more than
 *                 what stays
 * @param chance   probability with which chance may seem to be an improvement [1]
 * @param number   by how much the logarithm of a stiffness or damping that a user gives is off, half of them by more [1]: assumed; the
 *                 answers to 172 concealed recordings are as likely with 0.2 and 0.4
 */
public record Priors(double held, double unlisted, double form, double carried, double chance, double number) {

    /** Sources in the description of each. */
    public static final Priors USUAL = new Priors(0.9, 0.28, 0.1, 0.5, 0.001, 0.3);

    public Priors {
        Map.of("held", held, "unlisted", unlisted, "form", form, "carried", carried, "chance", chance, "number", number)
                .forEach((name, value) -> {
                    if (!(value > 0 && value < 1)) {
                        throw new IllegalArgumentException(name + " must be between 0 and 1: " + value);
                    }
                });
        if (!(held > 0.5)) {
            throw new IllegalArgumentException("held must be > 0.5: " + held);
        }
    }

    /** Odds [1] of the other of two names where one holds just enough. */
    public double odds() {
        return (1 - held) / held;
    }
}
