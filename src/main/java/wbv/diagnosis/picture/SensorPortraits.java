package wbv.diagnosis.picture;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.SensorFault;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.signal.FrequencyResponse;
import wbv.signal.LostSamples;

/** What a sensor makes of the motion that it should read, which the other sensors and the model tell. */
final class SensorPortraits {

    private final Evidence evidence;
    private final int output;
    private final String channel;
    private final double rate;
    private final double[] right;
    private final double[] found;
    private final double[] measured;
    private final Clouds clouds;

    SensorPortraits(Evidence evidence, Fitter.State base, Fitter.State chosen, int output) {
        this.evidence = evidence;
        this.output = output;
        this.channel = evidence.outputs().get(output).toString();
        this.rate = evidence.recording().clock().rate();
        Assembly full = chosen.candidate().at(chosen.x());
        this.found = simulated(full);
        List<Assembly.Output> outputs = new ArrayList<>(full.outputs());
        Assembly.Output own = outputs.get(output);
        int users = base.candidate().template().outputs().get(output).faults().size();
        outputs.set(output, own.with(own.faults().subList(0, users)));
        this.right = simulated(new Assembly(full.structure(), full.laws(), full.drives(), outputs));
        this.measured = evidence.measured(output);
        this.clouds = new Clouds(evidence, i -> evidence.valid(output)[i] && i >= 2 * rate && i < measured.length - rate);
    }

    private double[] simulated(Assembly assembly) {
        return evidence.whole().series(new Simulator(evidence.whole()).run(assembly, false).outputs()[output]);
    }

    List<Portrait> of(SensorFault fault) {
        if (fault instanceof SensorFault.MountResonance || fault instanceof SensorFault.StiffeningMount
                || fault instanceof SensorFault.AcCoupling || fault instanceof SensorFault.Late) {
            return response(true);
        }
        if (fault instanceof SensorFault.Misalignment tilt) {
            return List.of(error("acceleration of " + tilt.across(), evidence.series(tilt.across())),
                    error("acceleration of " + tilt.beside(), evidence.series(tilt.beside())));
        }
        if (fault instanceof SensorFault.Turned turned) {
            return List.of(error("acceleration of " + turned.across(), evidence.series(turned.across())));
        }
        if (fault instanceof SensorFault.LeverArm arm) {
            return List.of(error("angular acceleration of " + arm.rate(), slope(evidence.series(arm.rate()))));
        }
        return List.of(reading(true));
    }

    List<Portrait> unnamed() {
        List<Portrait> out = new ArrayList<>(response(false));
        out.add(reading(false));
        return out;
    }

    private String unit() {
        return evidence.outputs().get(output).quantity().unit();
    }

    /** Gain and phase from what it should read to what it reads. */
    private List<Portrait> response(boolean named) {
        double[] counted = LostSamples.marked(measured, evidence.valid(output));
        return OutputCharts.response(right, new double[][] {counted, found}, rate).map(h -> {
            int[] shown = OutputCharts.usable(evidence, h.get(0), 0.5);
            double[] f = OutputCharts.pick(h.get(0).frequency(), shown);
            double[] gain = OutputCharts.pick(h.get(0).h1().magnitudes(), shown);
            double[] error = OutputCharts.pick(h.get(0).error(), shown);
            List<Portrait.Trail> gains = new ArrayList<>(List.of(Portrait.Trail.measured("as measured", f, gain,
                    IntStream.range(0, f.length).mapToDouble(i -> gain[i] * error[i]).toArray())));
            List<Portrait.Trail> phases = new ArrayList<>(List.of(Portrait.Trail.measured("as measured", f,
                    degrees(h.get(0), shown),
                    Arrays.stream(error).map(Math::toDegrees).toArray())));
            if (named) {
                gains.add(Portrait.Trail.law("fault found", f, OutputCharts.pick(h.get(1).h1().magnitudes(), shown)));
                phases.add(Portrait.Trail.law("fault found", f, degrees(h.get(1), shown)));
            }
            Portrait.Scale hertz = new Portrait.Scale("Frequency", "Hz", true);
            return List.of(new Portrait("Gain of " + channel, hertz, Portrait.Scale.of("Reading over motion", "1"), gains,
                    "A sound sensor has gain 1 and phase 0 everywhere. The motion under it is the model's, fitted to all sensors."),
                    new Portrait("Phase of " + channel, hertz, Portrait.Scale.of("Phase", "°"), phases, ""));
        }).orElse(List.of());
    }

    private static double[] degrees(FrequencyResponse h, int[] shown) {
        return Arrays.stream(OutputCharts.pick(h.h1().phases(), shown)).map(Math::toDegrees).toArray();
    }

    private Portrait reading(boolean named) {
        List<Portrait.Trail> trails = new ArrayList<>(clouds.samples(right, 1, measured, 1));
        if (named) {
            trails.add(clouds.mean("fault found", Portrait.Kind.LAW, right, 1, found, 1));
        }
        return new Portrait("Reading of " + channel + " over the motion under it",
                Portrait.Scale.of("Motion as the model has it", unit()),
                Portrait.Scale.of("Reading", unit()), trails, "A sound sensor stays on the diagonal. The mean is removed.");
    }

    private Portrait error(String what, double[] cause) {
        List<Portrait.Trail> trails = new ArrayList<>(clouds.samples(cause, 1, difference(measured), 1));
        trails.add(clouds.mean("fault found", Portrait.Kind.LAW, cause, 1, difference(found), 1));
        Portrait.Scale x = Portrait.Scale.of(what.substring(0, 1).toUpperCase(Locale.ROOT) + what.substring(1),
                what.startsWith("angular") ? "rad/s²" : "m/s²");
        return new Portrait("Error of " + channel + " over " + what, x, Portrait.Scale.of("Error", unit()), trails,
                "A sound sensor's error does not depend on other motion.");
    }

    private double[] difference(double[] reading) {
        return IntStream.range(0, reading.length).mapToDouble(i -> reading[i] - right[i]).toArray();
    }

    private double[] slope(double[] x) {
        return IntStream.range(0, x.length).mapToDouble(i -> i == 0 || i == x.length - 1 ? 0 : (x[i + 1] - x[i - 1]) * rate / 2)
                .toArray();
    }
}
