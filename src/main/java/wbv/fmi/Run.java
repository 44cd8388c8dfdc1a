package wbv.fmi;

import java.util.List;

/** A unit run once over the inputs. Everything is in the unit's own units. */
abstract sealed class Run permits CoSimulationRun, ModelExchangeRun {

    final Instance instance;
    final double rate;
    final List<InputSignal> signals;
    final List<VariableUnit> units;
    final VariableBlock inputs;
    final VariableBlock outputs;
    private final double[] row;
    private final double[] values;

    /**
     * @param rate of the samples [Hz]
     * @param wired inputs, in the order of the signals
     * @param signals in SI units
     */
    Run(Instance instance, double rate, List<Variable> wired, List<InputSignal> signals, List<Variable> read) {
        this.instance = instance;
        this.rate = rate;
        this.signals = signals;
        this.units = wired.stream().map(Variable::unit).toList();
        this.inputs = VariableBlock.of(wired);
        this.outputs = VariableBlock.of(read);
        this.row = new double[wired.size()];
        this.values = new double[read.size()];
    }

    /** How an input is given at a time. */
    interface Reading {
        double of(InputSignal signal);
    }

    final void set(Reading reading) {
        prepare(reading);
        instance.set(inputs);
    }

    final void prepare(Reading reading) {
        for (int i = 0; i < row.length; i++) {
            row[i] = units.get(i).fromSi(reading.of(signals.get(i)));
        }
        inputs.write(row);
    }

    /**
     * Reads the outputs into a column.
     *
     * @return whether all are finite
     */
    final boolean read(double[][] into, int column) {
        instance.get(outputs);
        outputs.read(values);
        boolean finite = true;
        for (int o = 0; o < values.length; o++) {
            into[o][column] = values[o];
            finite &= Double.isFinite(values[o]);
        }
        return finite;
    }

    /** Outputs by output and sample; cut short by NaN where they leave all bounds. The instance has been initialised. */
    abstract double[][] outputs(int samples, Fineness fineness);
}
