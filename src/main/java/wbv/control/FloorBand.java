package wbv.control;

/**
 * What a controller supposes of the floor: white noise through one resonance. A machine's maker knows where it shakes.
 *
 * @param frequency of the band's middle [Hz], &gt; 0
 * @param damping half the band's width over its middle [1], &gt; 0
 * @param rms [m/s²], &gt; 0
 */
public record FloorBand(double frequency, double damping, double rms) {

    public FloorBand {
        if (!(frequency > 0 && damping > 0 && rms > 0)) {
            throw new IllegalArgumentException("frequency, damping and r.m.s. of a floor must be > 0: " + frequency + " Hz, "
                    + damping + ", " + rms + " m/s²");
        }
    }
}
