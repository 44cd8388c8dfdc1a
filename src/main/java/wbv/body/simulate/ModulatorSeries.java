package wbv.body.simulate;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import wbv.body.Assembly;
import wbv.body.number.Modulator;

/**
 * What modulates laws where an assembly moves, at the free run's rate: every series is worked out once, and the assembly runs once, when a
 * modulator first goes by one of its links. Threads may share it.
 */
public final class ModulatorSeries {

    private final Excitation excitation;
    private final Assembly assembly;
    private final Map<Modulator, double[]> known = new ConcurrentHashMap<>();
    private Optional<Simulator.Moved> moved = Optional.empty();

    /** The modulators of an assembly on an excitation; each is worked out when it is first asked for. */
    public ModulatorSeries(Excitation excitation, Assembly assembly) {
        this.excitation = excitation;
        this.assembly = assembly;
    }

    /** A modulator by sample, in the modulator's unit; empty for nothing. Not a copy. */
    public double[] of(Modulator modulator) {
        return known.computeIfAbsent(modulator, asked -> new Modulations(excitation).of(asked, new Modulations.Links() {
            @Override
            public double[] load(int link) {
                return moved().load(link);
            }

            @Override
            public double[] deflection(int link) {
                return moved().deflection(link);
            }
        }));
    }

    private synchronized Simulator.Moved moved() {
        Simulator.Moved there = moved.orElseGet(() -> {
            Simulator.Response response = new Simulator(excitation).run(assembly, false);
            return new Simulator.Moved(assembly, response.stretch(), response.forces(), excitation.omega());
        });
        moved = Optional.of(there);
        return there;
    }
}
