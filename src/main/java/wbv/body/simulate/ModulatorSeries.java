package wbv.body.simulate;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import wbv.body.number.Modulator;

/** What modulates laws along a motion that is known, at the free run's rate: every series is worked out once. Threads may share it. */
public final class ModulatorSeries {

    private final Excitation excitation;
    private final Links links;
    private final Map<Modulator, double[]> known = new ConcurrentHashMap<>();

    /** What links do, at the free run's rate. */
    public interface Links {

        /** What a link carries beside its static load, by sample [N], positive in extension. Not a copy. */
        double[] load(int link);

        /** Relative displacement of a link's ends, by sample [m], positive in extension. Not a copy. */
        double[] displacement(int link);

        /** Relative velocity of a link's ends, by sample [m/s], positive where they part. Not a copy. */
        double[] velocity(int link);
    }

    /**
     * The modulators along a motion; each is worked out when it is first asked for.
     *
     * @param links of the motion, asked for by modulators that go by one
     */
    public ModulatorSeries(Excitation excitation, Links links) {
        this.excitation = excitation;
        this.links = links;
    }

    /** A modulator by sample, in the modulator's unit; empty for nothing. Not a copy. */
    public double[] of(Modulator modulator) {
        return known.computeIfAbsent(modulator, asked -> new Modulations(excitation).of(asked, links));
    }
}
