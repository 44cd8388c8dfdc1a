package wbv.fmi;

import com.sun.jna.Memory;
import java.util.List;

/**
 * A run of a unit that gives derivatives only: integrated by the classical method of Runge and Kutta of fourth order, its inputs as
 * recorded at every stage. A step in which an event indicator changes its sign is halved until that moment is found to 1e-9 of a step;
 * steps end at the time events that the unit announces.
 *
 * <p>Hairer, Norsett, Wanner 1993, Solving ordinary differential equations I, II.1 and II.6.
 */
final class ModelExchangeRun extends Run {

    private static final double FOUND = 1e-9;
    /** Events within a step beyond which it does not come to an end. */
    private static final int MOST_EVENTS = 1000;
    private static final int MOST_ROUNDS = 100;

    private final int states;
    private final int indicators;
    private final Binary binary;
    private final Memory buffer;
    private final Memory signs;
    private final Instance.Event event = new Instance.Event();
    private final double[] x;
    private final double[] from;
    private final double[][] k;
    private double[] before;
    private double[] after;

    ModelExchangeRun(Instance instance, Binary binary, Description unit, double rate, List<Variable> wired, List<InputSignal> signals,
            List<Variable> read) {
        super(instance, rate, wired, signals, read);
        this.binary = binary;
        states = instance.states(unit.states());
        indicators = instance.indicators(unit.eventIndicators());
        buffer = VariableBlock.doubles(states);
        signs = VariableBlock.doubles(indicators);
        x = new double[states];
        from = new double[states];
        k = new double[4][states];
        before = new double[indicators];
        after = new double[indicators];
    }

    @Override
    double[][] outputs(int samples, Fineness fineness) {
        double step = fineness.step();
        double[][] out = new double[outputs.size][samples];
        discrete();
        for (int s = 0; s < samples; s++) {
            double time = s / rate;
            place(time, x);
            if (!read(out, s) || !finite(x)) {
                return CoSimulationRun.cut(out, s);
            }
            for (int part = 0; part < fineness.parts() && s < samples - 1; part++) {
                advance(time + part * step, step);
            }
        }
        return out;
    }

    private static boolean finite(double[] values) {
        for (double value : values) {
            if (!Double.isFinite(value)) {
                return false;
            }
        }
        return true;
    }

    /** One step, in as many pieces as there are events in it. */
    private void advance(double start, double step) {
        double end = start + step;
        double time = start;
        for (int events = 0; time < end; events++) {
            if (events > MOST_EVENTS) {
                throw binary.failure("it has events without end at " + (float) time + " s");
            }
            boolean announced = event.next < end;
            double target = announced ? Math.max(time, event.next) : end;
            double reached = signed(time, target);
            boolean crossed = changed();
            boolean asked = instance.completed();
            time = reached;
            if (crossed || asked || announced && reached >= target) {
                instance.enterEvent();
                discrete();
            } else {
                swap();
            }
            if (!finite(x)) {
                return;
            }
        }
    }

    /**
     * Integrates to a time, or to just behind the first change of an event indicator's sign, and leaves the unit there.
     *
     * @return the time reached
     */
    private double signed(double time, double target) {
        System.arraycopy(x, 0, from, 0, states);
        integrate(time, target - time);
        place(target, x);
        readSigns();
        if (!changed() || !finite(x)) {
            return target;
        }
        double low = 0;
        double high = target - time;
        double whole = high;
        while (high - low > FOUND * whole) {
            double middle = (low + high) / 2;
            again(time, middle);
            if (changed()) {
                high = middle;
            } else {
                low = middle;
            }
        }
        again(time, high);
        return time + high;
    }

    private void again(double time, double step) {
        System.arraycopy(from, 0, x, 0, states);
        integrate(time, step);
        place(time + step, x);
        readSigns();
    }

    private void integrate(double time, double step) {
        if (states == 0 || step <= 0) {
            return;
        }
        double[] base = from;
        derivatives(time, base, k[0]);
        combine(step / 2, k[0]);
        derivatives(time + step / 2, x, k[1]);
        combine(step / 2, k[1]);
        derivatives(time + step / 2, x, k[2]);
        combine(step, k[2]);
        derivatives(time + step, x, k[3]);
        for (int i = 0; i < states; i++) {
            x[i] = base[i] + step / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
        }
    }

    private void combine(double step, double[] slope) {
        for (int i = 0; i < states; i++) {
            x[i] = from[i] + step * slope[i];
        }
    }

    private void derivatives(double time, double[] state, double[] into) {
        place(time, state);
        instance.getDerivatives(buffer, states);
        buffer.read(0, into, 0, states);
    }

    /** Puts the unit at a time and a state, with the inputs of that time. */
    private void place(double time, double[] state) {
        instance.time(time);
        if (states > 0) {
            buffer.write(0, state, 0, states);
            instance.setStates(buffer, states);
        }
        set(signal -> signal.at(time));
    }

    private void readSigns() {
        if (indicators > 0) {
            instance.getIndicators(signs, indicators);
            signs.read(0, after, 0, indicators);
        }
    }

    private boolean changed() {
        for (int i = 0; i < indicators; i++) {
            if (after[i] > 0 != before[i] > 0) {
                return true;
            }
        }
        return false;
    }

    private void swap() {
        double[] old = before;
        before = after;
        after = old;
    }

    /** From event mode, back to continuous time, with states and signs as they are then. */
    private void discrete() {
        int rounds = 0;
        do {
            instance.discrete(event);
            if (event.stop) {
                throw binary.failure("it ends the simulation by itself");
            }
            if (++rounds > MOST_ROUNDS) {
                throw binary.failure("its discrete states do not settle");
            }
        } while (event.again);
        event.statesChanged = false;
        instance.enterContinuous();
        if (states > 0) {
            instance.getStates(buffer, states);
            buffer.read(0, x, 0, states);
        }
        readSigns();
        swap();
    }
}
