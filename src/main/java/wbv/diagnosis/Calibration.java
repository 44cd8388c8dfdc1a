package wbv.diagnosis;

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
 * @param answers  to how many recordings it rests on @param score mean logarithm of the probability of what was right about them [nat]
 * @param made     by which command @param commit of which program
 */
public record Calibration(double forms, double chance, double lapse, int answers, double score, String made, String commit) {

    private static final String RESOURCE = "/wbv/diagnosis/calibration.json";

    /** Read once: what ships does not change while it runs. */
    private static final Calibration STANDARD = read();

    public Calibration {
        if (!(forms > 0 && chance > 0 && lapse > 0 && lapse < 1)) {
            throw new IllegalArgumentException("forms and chance must be > 0, and the lapse between 0 and 1: " + forms + ", " + chance + ", " + lapse);
        }
    }

    /** The one that ships. */
    public static Calibration standard() {
        return STANDARD;
    }

    /** Excess that stands for whatever is in no library. @param without excess of the model alone */
    public static double unlisted(double without) {
        return Priors.USUAL.unlisted() * without;
    }

    private static Calibration read() {
        try (InputStream in = Calibration.class.getResourceAsStream(RESOURCE)) {
            return new ObjectMapper().readValue(in, Calibration.class);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Logarithm of the evidence of what leaves an excess [nat], but for what is the same for all. @param excess mean square of the whitened residual, less 1 */
    public double evidence(double excess) {
        return -forms / 2 * Math.log(Math.max(excess, chance));
    }
}
