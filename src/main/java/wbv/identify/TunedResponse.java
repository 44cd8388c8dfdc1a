package wbv.identify;

import java.io.Serializable;

/**
 * A {@link ScaledResponse} whose pulsation a measured pole tells: {@code ω = ω_r (ω_m/ω_r)^e}. The pole that a model of few
 * modes and a bounded band finds in a body of many does not move quite as fast as the body does, so that e is learned, not 1.
 *
 * @param response  with ω for its pulsation
 * @param reference ω_r [rad/s], &gt; 0
 * @param exponent  e, &gt; 0
 */
public record TunedResponse(ScaledResponse response, double reference, double exponent) implements Serializable {

    public TunedResponse {
        if (!(reference > 0) || !(exponent > 0) || Double.isInfinite(reference) || Double.isInfinite(exponent)) {
            throw new IllegalArgumentException("reference must be > 0 rad/s and exponent > 0: " + reference + ", " + exponent);
        }
    }

    /**
     * ω [rad/s] of the body whose measured pole has this pulsation.
     *
     * @param measured ω_m [rad/s], &gt; 0
     */
    public double pulsation(double measured) {
        return reference * Math.pow(measured / reference, exponent);
    }

    /**
     * The response of that body.
     *
     * @param measured ω_m [rad/s]
     */
    public TransferModel at(double measured) {
        return response.at(pulsation(measured));
    }
}
