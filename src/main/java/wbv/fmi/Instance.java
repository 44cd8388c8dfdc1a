package wbv.fmi;

import com.sun.jna.Memory;
import java.io.Closeable;

/**
 * One run of a unit: the calls of the standard that wbv makes, the same for FMI 2.0 and 3.0. Every one throws a fault of the data where it
 * fails.
 */
interface Instance extends Closeable {

    /** Ways of a unit to be run. */
    enum Way { CO_SIMULATION, MODEL_EXCHANGE }

    /**
     * Sets what differs from the start values, and initialises.
     *
     * @param stop   last time [s] of an experiment that begins at 0
     * @param chosen parameters with their values
     * @param inputs with their values at the start
     */
    void begin(double stop, VariableBlock chosen, VariableBlock inputs);

    void set(VariableBlock variables);

    void get(VariableBlock variables);

    /**
     * Steps itself.
     *
     * @param time [s]
     * @param step [s]
     */
    void step(double time, double step);

    /** One whose inputs may change along straight lines over a step: FMI 2.0 offers that, 3.0 no longer does. */
    interface Interpolating {

        /** How fast inputs change [unit/s] until the next step. */
        void slopes(VariableBlock inputs);
    }

    /** What came of an event. */
    final class Event {
        boolean again;
        boolean stop;
        boolean statesChanged;
        /** [s]; infinite where none is known. */
        double next = Double.POSITIVE_INFINITY;
    }

    /**
     * Number of continuous states, as the unit itself counts.
     *
     * @param declared in the description
     */
    int states(int declared);

    int indicators(int declared);

    void enterEvent();

    void discrete(Event event);

    void enterContinuous();

    void time(double time);

    void setStates(Memory states, int count);

    void getStates(Memory states, int count);

    void getDerivatives(Memory derivatives, int count);

    void getIndicators(Memory indicators, int count);

    /** Ends an integrator step. Whether an event is asked for. */
    boolean completed();

    /**
     * Directional derivative: what a change of some variables does to others.
     *
     * @param unknown whose change is asked for, their values get it
     * @param known that change, their values say by how much
     * @return false where the unit does not give it
     */
    boolean directional(VariableBlock unknown, VariableBlock known);

    /** Terminates where it was begun and has not failed, and frees it. */
    @Override
    void close();
}
