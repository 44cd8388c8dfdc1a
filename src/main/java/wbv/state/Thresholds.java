package wbv.state;

import java.io.Serializable;

/**
 * What counts as jerk, jolt, rocking and rest.
 *
 * @param jerk    vertical jerk beyond which a place jerks while a jolt acts [m/s³], &gt; 0
 * @param surge   change of the seat's mean vertical acceleration from 0.15 s to the next beyond which a jolt acts [m/s²], &gt; 0
 * @param rocking root mean square of roll and pitch rate below about 1.5 Hz from which it is rocking [rad/s], &gt; 0
 * @param rest    root mean square of jerk below which it is rest [m/s³], &gt; 0
 */
public record Thresholds(double jerk, double surge, double rocking, double rest) implements Serializable {

    /**
     * 40 m/s³, 1.8 m/s², 0.05 rad/s, 3 m/s³ (assumed: the strongest of the thesis' regimes surges by 1 m/s² and sways with
     * 0.03 rad/s, the weakest jerks with 4 m/s³, sensors' noise with 0.6).
     */
    public static final Thresholds USUAL = new Thresholds(40, 1.8, 0.05, 3);

    public Thresholds {
        if (!(jerk > 0 && surge > 0 && rocking > 0 && rest > 0) || Double.isInfinite(jerk + surge + rocking + rest)) {
            throw new IllegalArgumentException("thresholds must be > 0: " + jerk + " m/s³, " + surge + " m/s², " + rocking
                    + " rad/s, " + rest + " m/s³");
        }
    }
}
