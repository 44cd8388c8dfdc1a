package wbv.filter;

import java.io.Serializable;
import java.util.random.RandomGenerator;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** Random numbers that serialise and can begin again: SplitMix64 (Steele, Lea and Flood, OOPSLA 2014). */
final class SplitMix implements RandomGenerator, Serializable, Snapshot {

    private static final long serialVersionUID = 1;
    private static final long GAMMA = 0x9E3779B97F4A7C15L;

    private final long seed;
    private long state;

    SplitMix(long seed) {
        this.seed = seed;
        restart();
    }

    void restart() {
        state = seed;
    }

    @Override
    public long nextLong() {
        state += GAMMA;
        long z = state;
        z = (z ^ z >>> 30) * 0xBF58476D1CE4E5B9L;
        z = (z ^ z >>> 27) * 0x94D049BB133111EBL;
        return z ^ z >>> 31;
    }

    @Override
    public void save(StateWriter out) {
        out.put(state);
    }

    @Override
    public void load(StateReader in) {
        state = in.count();
    }
}
