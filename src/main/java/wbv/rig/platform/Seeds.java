package wbv.rig.platform;

import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;

/**
 * One seed split by name into independent random sources, so that switching one sensor off leaves the noise of all others
 * as it was.
 *
 * @param seed any number; other numbers give other experiments
 */
public record Seeds(long seed) {

    /** A fresh source for a thing of this name, always the same for the same seed and name. */
    public RandomGenerator source(String name) {
        long mixed = scramble(seed);
        for (int i = 0; i < name.length(); i++) {
            mixed = scramble(mixed ^ name.charAt(i));
        }
        return new Well19937c(mixed);
    }

    /** Seeds for the parts of a thing of this name. */
    public Seeds of(String name) {
        return new Seeds(source(name).nextLong());
    }

    /** The output function of SplitMix64 (Steele, Lea, Flood 2014): every input bit reaches every output bit. */
    private static long scramble(long z) {
        z += 0x9E3779B97F4A7C15L;
        z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
        z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
        return z ^ (z >>> 31);
    }
}
