package wbv.fmi;

import com.sun.jna.CallbackReference;
import com.sun.jna.Memory;
import com.sun.jna.Native;
import com.sun.jna.Pointer;
import java.net.URI;

/** A run by FMI 2.0. */
final class Fmi2Instance implements Instance, Instance.Interpolating {

    private static final int CO_SIMULATION = 1;
    private static final int MODEL_EXCHANGE = 0;
    private static final int TRUE = 1;
    private static final int FALSE = 0;
    /** Of fmi2EventInfo: five booleans, and after a gap the time of the next event. */
    private static final int NEXT_TIME = 24;
    private static final int LAST_FLAG = 16;
    private static final int EVENT_BYTES = 32;

    private final Binary binary;
    private final Binary.Logger2 logger;
    private final Memory callbacks;
    private final Pointer handle;
    private final Memory event = new Memory(EVENT_BYTES);
    private final Memory flags = new Memory(2L * Integer.BYTES);
    private final Memory first;
    private final boolean silent;
    private boolean begun;

    Fmi2Instance(Binary binary, Description description, Way way, URI resources, int inputs) {
        this.binary = binary;
        logger = (environment, instance, status, category, message, first) -> binary.hear(status, Binary.filled(message, first));
        callbacks = new Memory(5L * Native.POINTER_SIZE);
        callbacks.clear();
        callbacks.setPointer(0, CallbackReference.getFunctionPointer(logger));
        callbacks.setPointer(Native.POINTER_SIZE, Binary.ofC("calloc"));
        callbacks.setPointer(2L * Native.POINTER_SIZE, Binary.ofC("free"));
        boolean own = way == Way.CO_SIMULATION;
        silent = (own ? description.coSimulation() : description.modelExchange()).orElseThrow().silentSteps();
        handle = binary.make("its instantiation", "fmi2Instantiate", description.model(), own ? CO_SIMULATION : MODEL_EXCHANGE,
                description.token(), resources.toString(), callbacks, FALSE, FALSE);
        String[] errors = description.errorCategories();
        if (errors.length > 0) {
            // What it answers does not matter: it is only about its words.
            binary.tell("fmi2SetDebugLogging", handle, TRUE, Binary.size(errors.length), errors);
        }
        first = new Memory(Math.max(1, inputs) * (long) Integer.BYTES);
        for (int i = 0; i < inputs; i++) {
            first.setInt((long) i * Integer.BYTES, 1);
        }
    }

    @Override
    public void begin(double stop, VariableBlock chosen, VariableBlock inputs) {
        binary.call("its set-up", "fmi2SetupExperiment", handle, FALSE, 0.0, 0.0, TRUE, stop);
        set(chosen);
        binary.call("its initialisation", "fmi2EnterInitializationMode", handle);
        begun = true;
        set(inputs);
        binary.call("its initialisation", "fmi2ExitInitializationMode", handle);
    }

    @Override
    public void set(VariableBlock variables) {
        if (variables.size > 0) {
            call("setting its variables", "fmi2SetReal", handle, variables.references, Binary.size(variables.size), variables.values);
        }
    }

    @Override
    public void get(VariableBlock variables) {
        call("reading its variables", "fmi2GetReal", handle, variables.references, Binary.size(variables.size), variables.values);
    }

    @Override
    public void slopes(VariableBlock inputs) {
        call("setting the slopes of its inputs", "fmi2SetRealInputDerivatives", handle, inputs.references, Binary.size(inputs.size), first,
                inputs.values);
    }

    @Override
    public void step(double time, double step) {
        call("its step", "fmi2DoStep", handle, time, step, TRUE);
    }

    @Override
    public int states(int declared) {
        return declared;
    }

    @Override
    public int indicators(int declared) {
        return declared;
    }

    @Override
    public void enterEvent() {
        call("its event", "fmi2EnterEventMode", handle);
    }

    @Override
    public void discrete(Event out) {
        event.clear();
        call("its event", "fmi2NewDiscreteStates", handle, event);
        out.again = event.getInt(0) != 0;
        out.stop = event.getInt(Integer.BYTES) != 0;
        out.statesChanged |= event.getInt(3L * Integer.BYTES) != 0;
        out.next = event.getInt(LAST_FLAG) != 0 ? event.getDouble(NEXT_TIME) : Double.POSITIVE_INFINITY;
    }

    @Override
    public void enterContinuous() {
        call("its event", "fmi2EnterContinuousTimeMode", handle);
    }

    @Override
    public void time(double time) {
        call("setting its time", "fmi2SetTime", handle, time);
    }

    @Override
    public void setStates(Memory states, int count) {
        call("setting its states", "fmi2SetContinuousStates", handle, states, Binary.size(count));
    }

    @Override
    public void getStates(Memory states, int count) {
        call("reading its states", "fmi2GetContinuousStates", handle, states, Binary.size(count));
    }

    @Override
    public void getDerivatives(Memory derivatives, int count) {
        call("its derivatives", "fmi2GetDerivatives", handle, derivatives, Binary.size(count));
    }

    @Override
    public void getIndicators(Memory indicators, int count) {
        call("its event indicators", "fmi2GetEventIndicators", handle, indicators, Binary.size(count));
    }

    @Override
    public boolean completed() {
        if (silent) {
            return false;
        }
        call("its step", "fmi2CompletedIntegratorStep", handle, TRUE, flags, flags.share(Integer.BYTES));
        return flags.getInt(0) != 0;
    }

    @Override
    public boolean directional(VariableBlock unknown, VariableBlock known) {
        return binary.gives("fmi2GetDirectionalDerivative", handle, unknown.references, Binary.size(unknown.size), known.references,
                Binary.size(known.size), known.values, unknown.values);
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
            binary.tell("fmi2Terminate", handle);
        }
        binary.tell("fmi2FreeInstance", handle);
        java.lang.ref.Reference.reachabilityFence(logger);
    }
}
