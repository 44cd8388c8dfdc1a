package wbv.rig.platform;

import java.util.Locale;

/** What is being done to the sitter at a moment, as the program has it. */
public enum Episode {
    /** The platform is told nothing. */
    IDLE,
    /** Ordinary vibration. */
    RIDING,
    /** Slow swaying about one axis, with some vibration. */
    ROCKING;

    /** The word of this episode, such as {@code idle}. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
