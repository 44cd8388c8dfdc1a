package wbv.fmi;

import com.sun.jna.Memory;
import com.sun.jna.Pointer;
import java.io.File;
import java.nio.file.Path;

/** A run by FMI 3.0. Its booleans are bytes. */
final class Fmi3Instance implements Instance {

    private static final byte TRUE = 1;
    private static final byte FALSE = 0;
    private static final int FLAGS = 5;

    private final Binary binary;
    private final Binary.Logger3 logger;
    private final Pointer handle;
    private final Memory flags = new Memory(FLAGS);
    private final Memory time = VariableBlock.doubles(1);
    private final boolean silent;
    private boolean begun;

    Fmi3Instance(Binary binary, Description description, Way way, Path resources) {
        this.binary = binary;
        logger = (environment, status, category, message) -> binary.hear(status, message);
        boolean own = way == Way.CO_SIMULATION;
        silent = (own ? description.coSimulation() : description.modelExchange()).orElseThrow().silentSteps();
        String folder = resources.toAbsolutePath() + File.separator;
        handle = own
                ? binary.make("its instantiation", "fmi3InstantiateCoSimulation", description.model(), description.token(), folder, FALSE,
                        FALSE, FALSE, FALSE, Pointer.NULL, Binary.size(0), Pointer.NULL, logger, Pointer.NULL)
                : binary.make("its instantiation", "fmi3InstantiateModelExchange", description.model(), description.token(), folder, FALSE,
                        FALSE, Pointer.NULL, logger);
        String[] errors = description.errorCategories();
        if (errors.length > 0) {
            // What it answers does not matter: it is only about its words.
            binary.tell("fmi3SetDebugLogging", handle, TRUE, Binary.size(errors.length), errors);
        }
    }

    @Override
    public void begin(double stop, VariableBlock chosen, VariableBlock inputs) {
        set(chosen);
        binary.call("its initialisation", "fmi3EnterInitializationMode", handle, FALSE, 0.0, 0.0, TRUE, stop);
        begun = true;
        set(inputs);
        binary.call("its initialisation", "fmi3ExitInitializationMode", handle);
    }

    @Override
    public void set(VariableBlock variables) {
        if (variables.size > 0) {
            call("setting its variables", "fmi3SetFloat64", handle, variables.references, Binary.size(variables.size), variables.values,
                    Binary.size(variables.size));
        }
    }

    @Override
    public void get(VariableBlock variables) {
        call("reading its variables", "fmi3GetFloat64", handle, variables.references, Binary.size(variables.size), variables.values,
                Binary.size(variables.size));
    }

    @Override
    public void step(double at, double step) {
        flags.clear();
        call("its step", "fmi3DoStep", handle, at, step, TRUE, flags, flags.share(1), flags.share(2), this.time);
        if (flags.getByte(1) != 0) {
            throw binary.failure("it ends the simulation by itself");
        }
    }

    @Override
    public int states(int declared) {
        return counted("fmi3GetNumberOfContinuousStates");
    }

    @Override
    public int indicators(int declared) {
        return counted("fmi3GetNumberOfEventIndicators");
    }

    private int counted(String function) {
        time.clear();
        call("counting its states", function, handle, time);
        return time.getInt(0);
    }

    @Override
    public void enterEvent() {
        call("its event", "fmi3EnterEventMode", handle);
    }

    @Override
    public void discrete(Event out) {
        flags.clear();
        call("its event", "fmi3UpdateDiscreteStates", handle, flags, flags.share(1), flags.share(2), flags.share(3), flags.share(4), time);
        out.again = flags.getByte(0) != 0;
        out.stop = flags.getByte(1) != 0;
        out.statesChanged |= flags.getByte(3) != 0;
        out.next = flags.getByte(4) != 0 ? time.getDouble(0) : Double.POSITIVE_INFINITY;
    }

    @Override
    public void enterContinuous() {
        call("its event", "fmi3EnterContinuousTimeMode", handle);
    }

    @Override
    public void time(double at) {
        call("setting its time", "fmi3SetTime", handle, at);
    }

    @Override
    public void setStates(Memory states, int count) {
        call("setting its states", "fmi3SetContinuousStates", handle, states, Binary.size(count));
    }

    @Override
    public void getStates(Memory states, int count) {
        call("reading its states", "fmi3GetContinuousStates", handle, states, Binary.size(count));
    }

    @Override
    public void getDerivatives(Memory derivatives, int count) {
        call("its derivatives", "fmi3GetContinuousStateDerivatives", handle, derivatives, Binary.size(count));
    }

    @Override
    public void getIndicators(Memory indicators, int count) {
        call("its event indicators", "fmi3GetEventIndicators", handle, indicators, Binary.size(count));
    }

    @Override
    public boolean completed() {
        if (silent) {
            return false;
        }
        call("its step", "fmi3CompletedIntegratorStep", handle, TRUE, flags, flags.share(1));
        return flags.getByte(0) != 0;
    }

    @Override
    public boolean directional(VariableBlock unknown, VariableBlock known) {
        return binary.gives("fmi3GetDirectionalDerivative", handle, unknown.references, Binary.size(unknown.size), known.references,
                Binary.size(known.size), known.values, Binary.size(known.size), unknown.values, Binary.size(unknown.size));
    }

    private void call(String doing, String function, Object... arguments) {
        try {
            binary.call(doing, function, arguments);
        } catch (RuntimeException failed) {
            begun = false;
            throw failed;
        }
    }

    @Override
    public void close() {
        if (begun) {
            binary.tell("fmi3Terminate", handle);
        }
        binary.tell("fmi3FreeInstance", handle);
        java.lang.ref.Reference.reachabilityFence(logger);
    }
}
