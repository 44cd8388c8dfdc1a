package wbv.state;

import java.io.Serializable;

/**
 * What counts as jerk, rocking and rest.
 *
 * @param jerk    vertical jerk beyond which a place jerks [m/s³], &gt; 0
 * @param rocking root mean square of roll and pitch rate below about 1.5 Hz from which it is rocking [rad/s], &gt; 0
 * @param rest    root mean square of jerk below which it is rest [m/s³], &gt; 0
 */
public record Thresholds(double jerk, double rocking, double rest) implements Serializable {

    /** 40 m/s³, 0.05 rad/s, 3 m/s³ (assumed: vibration of 0.3 m/s² at 5 to 8 Hz jerks with 12 m/s³, sensors' noise with 0.3). */
    public static final Thresholds USUAL = new Thresholds(40, 0.05, 3);

    public Thresholds {
        if (!(jerk > 0 && rocking > 0 && rest > 0) || Double.isInfinite(jerk + rocking + rest)) {
            throw new IllegalArgumentException("thresholds must be > 0: " + jerk + " m/s³, " + rocking + " rad/s, " + rest + " "
                    + "m/s³");
        }
    }
}
