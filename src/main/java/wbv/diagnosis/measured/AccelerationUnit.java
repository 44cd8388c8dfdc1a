package wbv.diagnosis.measured;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import wbv.body.simulate.Simulator;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.signal.ScalarProduct;

/** Refuses rides whose accelerations look to be in another unit than m/s², as the model, the sitter and the sensors tell. */
public final class AccelerationUnit {

    /** Standard gravity [m/s²]. */
    public static final double GRAVITY = 9.80665;
    /** By how much one unit of acceleration is another. */
    private static final Map<Double, String> UNITS = Map.of(GRAVITY, "g", 1000 / GRAVITY, "mg", 1000.0,
            "mg where the other is in g");
    private static final double NEARLY = 1.25;
    /** Correlation from which on what differs by a factor is the same otherwise. */
    private static final double ALIKE = 0.7;
    /** No person sits through more [m/s²]. */
    private static final double UNBEARABLE = 20;
    /** So little that it is g rather than m/s² [m/s²] where the sensor's noise is as far below that of others. */
    private static final double FAINT = 0.15;
    private static final double TOO_QUIET = 0.003;
    /** Noise so far below a signal is no sensor's: what was computed has no unit to be told by. */
    private static final double COMPUTED = 1e-3;

    private AccelerationUnit() {}

    /**
     * Refuses accelerations that look to be in g or mg: an output that is what the model gives but for that factor, a ride
     * that no person would sit through, or one that no sensor would measure so quietly.
     */
    public static void check(Measured measured) {
        List<Channel> inputs = measured.model().excitations();
        if (measured.onRig() || inputs.get(0).quantity() != Quantity.ACCELERATION) {
            return;
        }
        double[][] simulated = new Simulator(measured.input()).outputs(measured.model().assembly());
        for (int o = 0; o < simulated.length; o++) {
            Channel output = measured.outputs().get(o);
            if (output.quantity() == Quantity.ACCELERATION) {
                factor(simulated[o], measured.series(o)).ifPresent(by -> {
                    throw fault("%s reads %.4g times what the model makes of %s: one of the two looks to be in %s; "
                            + "say the unit in a column map (--map)", output, by, inputs.get(0), unit(by).orElse(""));
                });
            }
        }
        double level = rms(measured.input().series(measured.input().baseSpectrum()));
        if (level > UNBEARABLE) {
            throw fault("%s moves by %.3g m/s² rms, more than a person sits through: it looks to be in mg; "
                    + "say the unit in a column map (--map)", inputs.get(0), level);
        }
        double noise = measured.inputNoise();
        if (level < FAINT && noise < TOO_QUIET && noise > COMPUTED * level) {
            throw fault("%s moves by %.3g m/s² rms with %.2g m/s² of noise, both faint: it looks to be in g; "
                    + "say the unit, be it m/s2, in a column map (--map)", inputs.get(0), level, noise);
        }
    }

    /** By how much a series is another one, if that is what one unit is of another and the two are much alike otherwise. */
    private static Optional<Double> factor(double[] reference, double[] series) {
        double factor = ScalarProduct.of(reference, series) / ScalarProduct.of(reference, reference);
        double likeness = factor * rms(reference) / rms(series);
        return likeness > ALIKE && unit(factor).isPresent() ? Optional.of(factor) : Optional.empty();
    }

    private static Optional<String> unit(double factor) {
        double size = Math.abs(Math.log(factor));
        return UNITS.entrySet().stream().filter(unit -> Math.abs(size - Math.log(unit.getKey())) < Math.log(NEARLY))
                .map(Map.Entry::getValue).findAny();
    }

    private static DataFault fault(String format, Object... values) {
        return new DataFault(String.format(Locale.ROOT, format, values));
    }

    private static double rms(double[] x) {
        return Math.sqrt(ScalarProduct.of(x, x) / x.length);
    }
}
