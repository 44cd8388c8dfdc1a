package wbv.rig;

import java.util.Locale;

/** What the rig can be told to leave out, one by one; what is left out is exactly absent, and nothing else changes. */
public enum Effect {
    /** Tissue and cushion soften with the total magnitude of the platform, with memory. */
    SOFTENING,
    /** Links stand off the line of the masses, so that vertical motion drives fore-and-aft and pitch. */
    CROSS,
    /** Sensors sit off the centre of their segment and feel its rotation. */
    LEVER,
    /** A cushion between seat pan and pelvis. */
    CUSHION,
    /** White noise of every sensor. */
    NOISE,
    /** Constant offset of every sensor. */
    BIAS,
    /** An offset of every sensor that walks slowly. */
    DRIFT,
    /** A small error of attitude of every sensor, through which gravity leaks. */
    TILT,
    /** Values are sent in steps, as a sensor's text export has them: 0.0001 m/s² and 0.00001 rad/s. */
    RESOLUTION,
    /** Wireless packets lost in bursts; off unless asked for. */
    LOSS;

    /** Whether it belongs to the sensors; the others belong to a person on his seat and mean nothing to a linear sitter. */
    boolean ofSensors() {
        return compareTo(NOISE) >= 0;
    }

    /** The word of this effect, such as {@code softening}. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** @throws IllegalArgumentException if no effect has this name */
    static Effect parse(String word) {
        for (Effect effect : values()) {
            if (effect.toString().equals(word)) {
                return effect;
            }
        }
        throw new IllegalArgumentException(
                "an effect is one of softening cross lever cushion noise bias drift tilt resolution loss: '" + word + "'");
    }
}
