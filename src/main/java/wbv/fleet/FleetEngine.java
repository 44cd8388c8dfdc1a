package wbv.fleet;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.function.Consumer;

/**
 * Follows a fleet on several machines, to the same bytes as {@link FleetRun}. It comes with the profile 'fleet' of the build, and is
 * found where its jar is on the class path.
 */
public interface FleetEngine {

    /**
     * Starts machines of its own on this computer, follows the fleet on them and ends them, whatever happened. A run of the same order
     * that was stopped in this folder is gone on with, by whatever number of machines.
     *
     * @param machines &gt;= 1
     * @param between  time between two times that the seats' states are kept [s], &gt; 0
     * @param out      folder for what {@link FleetRun} writes; for the state alone where packets come from a topic
     * @param tell     told in lines what is going on
     * @throws IOException if the machines do not start or the run fails, in one line
     */
    void local(FleetOrder order, int machines, double between, Path out, Consumer<String> tell) throws IOException;

    /**
     * Follows the fleet on machines that are there.
     *
     * @param between as {@link #local} [s]
     * @param address HOST:PORT of the one that takes orders
     * @param out     as {@link #local}; a folder that all machines see under this name
     */
    void cluster(FleetOrder order, String address, double between, Path out, Consumer<String> tell) throws IOException;

    /** The engine, where this program was built with one. */
    static Optional<FleetEngine> find() {
        return ServiceLoader.load(FleetEngine.class).findFirst();
    }
}
