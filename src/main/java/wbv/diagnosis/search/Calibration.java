package wbv.diagnosis.search;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;

/**
 * How well a formula that is right fits, as answers to concealed recordings tell; made by {@code wbv prove --calibrate}.
 *
 * @param forms    how many independent parts the form of a law has [1]: twice the power of the excess with which evidence falls
 * @param chance   excess that chance and effects of second order leave, in units of the noise [1]
 * @param lapse    probability that an answer is wrong whatever its evidence says [1] (Laplace 1814: one more than was seen)
 * @param nulls    by how much the likeliest law makes data that were not used likelier than the numbers alone do where nothing is missing,
 *                 in the mean [nat]
 * @param answers  to how many recordings it rests on
 * @param score mean logarithm of the probability of what was right about them [nat]
 * @param made     by which command
 * @param commit of which program
 */
public record Calibration(double forms, double chance, double lapse, double nulls, int answers, double score, String made, String commit) {

    private static final String RESOURCE = "/wbv/diagnosis/calibration.json";

    /** Read once: what ships does not change while it runs. */
    private static final Calibration STANDARD = read();

    public Calibration {
        if (!(forms > 0 && chance > 0 && lapse > 0 && lapse < 1 && nulls > 0)) {
            throw new IllegalArgumentException(
                    "forms, chance and nulls must be > 0, and the lapse between 0 and 1: " + forms + ", " + chance + ", " + nulls + ", "
                            + lapse);
        }
    }

    /** The one that ships. */
    public static Calibration standard() {
        return STANDARD;
    }

    /**
     * Excess [1] that stands for whatever is in no library.
     *
     * @param without excess of the model alone [1]
     */
    public static double unlisted(double without) {
        return Priors.UNLISTED * without;
    }

    private static Calibration read() {
        try (InputStream in = Calibration.class.getResourceAsStream(RESOURCE)) {
            return new ObjectMapper().readValue(in, Calibration.class);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * No formula is quite right, and what is left beside the right one is mostly its form: of a size that nobody knows before. Summed over
     * sizes that are equally likely in the logarithm (Jeffreys 1946), the evidence of a hypothesis goes as a power of what it leaves beyond
     * the noise; the noise is the same for all, so that what one leaves more than another is no chance.
     *
     * @param left  mean square of the whitened residual of a hypothesis [1]
     * @param least mean square that any hypothesis about the same data leaves [1]
     * @return logarithm of its evidence but for what is the same for all [nat]
     */
    public double evidence(double left, double least) {
        return -forms / 2 * Math.log(left - least + Math.max(least - 1, chance));
    }

    /**
     * How sharply {@link #evidence} falls as numbers move away from a fit that leaves least, against how half the sum of squares rises: by
     * the ratio of their second derivatives there, 0 to 1 [1]. Where much is left, it is of a form that is not quite right, and numbers are
     * told no better than that.
     *
     * @param left mean square of the whitened residual that the fit leaves [1]
     * @param degrees of freedom of the data [1]
     */
    public double sharpness(double left, double degrees) {
        return Math.min(1, forms / (degrees * Math.max(left - 1, chance)));
    }

    /**
     * Whether a hypothesis is less likely than another by no more than a number more in its formula would cost.
     *
     * @param left mean square of the whitened residual that it leaves [1]
     * @param otherLeft that the other leaves of the same data [1]
     */
    public boolean isAsLikely(double left, double otherLeft) {
        double least = Math.min(left, otherLeft);
        return evidence(left, least) > evidence(otherLeft, least) - price();
    }

    /**
     * What a number more in a formula costs, since it makes up for one of so many parts of its form [nat] (Schwarz 1978): as many as data
     * would have to be if what is left were noise.
     */
    public double price() {
        return Math.log(forms) / 2;
    }
}
