package wbv.diagnosis;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import wbv.body.Model;
import wbv.diagnosis.picture.Pictures;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;

/**
 * Benches for tests, stepped in time by code that shares nothing with the models that are judged by them: masses in a row under forces,
 * half a step of drift, a kick at its middle and half a step of drift. Dry friction takes from each kick what it can, and holds a mass that
 * it can stop.
 */
public final class Bench {

    /** Forces on the masses beside dry friction [N]. */
    public interface Forces {
        /** @param t [s] @param x positions [m] @param v velocities [m/s] @param out by mass. Modified. */
        void at(double t, double[] x, double[] v, double[] out);
    }

    private final double rate;
    private final int samples;
    private final int fine;
    private final double[] mass;
    private final double[][] position;
    private final double[][] velocity;
    private final double[][] acceleration;

    /** @param fine steps by sample @param mass [kg] */
    public Bench(double rate, double seconds, int fine, double... mass) {
        this.rate = rate;
        this.samples = (int) Math.round(seconds * rate);
        this.fine = fine;
        this.mass = mass;
        position = new double[mass.length][samples * fine];
        velocity = new double[mass.length][samples * fine];
        acceleration = new double[mass.length][samples * fine];
    }

    /** From rest. */
    public Bench run(Forces forces) {
        return run(forces, new double[mass.length], new double[mass.length], (t, x, v, out) -> {});
    }

    /**
     * @param at positions at the start [m]
     * @param going velocities [m/s]
     * @param friction least force that moves each mass over the ground [N]
     */
    public Bench run(Forces forces, double[] at, double[] going, Forces friction) {
        double h = 1 / rate / fine;
        double[] x = at.clone();
        double[] v = going.clone();
        double[] force = new double[mass.length];
        double[] most = new double[mass.length];
        double[] middle = new double[mass.length];
        for (int j = 0; j < samples * fine; j++) {
            double t = j * h;
            forces.at(t, x, v, force);
            friction.at(t, x, v, most);
            for (int i = 0; i < mass.length; i++) {
                position[i][j] = x[i];
                velocity[i][j] = v[i];
                acceleration[i][j] = (force[i]
                        - Math.copySign(Math.min(most[i], v[i] == 0 ? Math.abs(force[i]) : most[i]), v[i] == 0 ? force[i] : v[i]))
                        / mass[i];
                x[i] += h / 2 * v[i];
                middle[i] = v[i] + h / 2 * force[i] / mass[i];
            }
            forces.at(t + h / 2, x, middle, force);
            friction.at(t + h / 2, x, middle, most);
            for (int i = 0; i < mass.length; i++) {
                v[i] = kicked(v[i], force[i], most[i], mass[i], h);
                x[i] += h / 2 * v[i];
            }
        }
        return this;
    }

    /** The speed after a kick, in which friction turns round at the moment at which the mass does. */
    private static double kicked(double v, double force, double friction, double mass, double h) {
        boolean held = Math.abs(force) <= friction;
        if (v == 0) {
            return held ? 0 : h * (force - Math.copySign(friction, force)) / mass;
        }
        double a = (force - Math.copySign(friction, v)) / mass;
        double next = v + h * a;
        if (next * v >= 0) {
            return next;
        }
        return held ? 0 : (h + v / a) * (force + Math.copySign(friction, v)) / mass;
    }

    public double rate() {
        return rate;
    }

    /** Time of a step [s]. */
    public double step() {
        return 1 / rate / fine;
    }

    /** Position of a mass at every step [m]. */
    public double[] position(int body) {
        return position[body].clone();
    }

    public double[] velocity(int body) {
        return velocity[body].clone();
    }

    public double[] acceleration(int body) {
        return acceleration[body].clone();
    }

    /** Every so many steps, a sample. */
    public double[] sampled(double[] steps) {
        double[] out = new double[samples];
        Arrays.setAll(out, j -> steps[j * fine]);
        return out;
    }

    /** What a function of time is at each sample. */
    public double[] sampled(DoubleUnaryOperator signal) {
        double[] out = new double[samples];
        Arrays.setAll(out, j -> signal.applyAsDouble(j / rate));
        return out;
    }

    /** Channels by name and series in turn. */
    public Recording recording(Object... namesAndSeries) {
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        for (int i = 0; i < namesAndSeries.length; i += 2) {
            Object name = namesAndSeries[i];
            channels.put(name instanceof Channel channel ? channel : Channel.parse((String) name), (double[]) namesAndSeries[i + 1]);
        }
        return new Recording(new Clock(0, rate), channels, Metadata.NONE);
    }

    /** Tones of one size, evenly apart, of random phases, that fade in over a second. @param lowest [Hz] @param apart [Hz] */
    public static DoubleUnaryOperator tones(int count, double lowest, double apart, double amplitude, Random random) {
        double[] phase = random.doubles(count, 0, 2 * Math.PI).toArray();
        return t -> {
            double sum = 0;
            for (int k = 0; k < count; k++) {
                sum += amplitude * Math.sin(2 * Math.PI * (lowest + apart * k) * t + phase[k]);
            }
            return Math.min(1, t) * sum;
        };
    }

    /** With white noise. @param size standard deviation, in the series' unit */
    public static double[] noisy(double[] series, double size, Random random) {
        double[] out = new double[series.length];
        Arrays.setAll(out, i -> series[i] + size * random.nextGaussian());
        return out;
    }

    /** With white noise of a part of its own root mean square. */
    public static double[] noisyBy(double part, double[] series, Random random) {
        return noisy(series, part * rms(series), random);
    }

    public static double rms(double[] series) {
        return Math.sqrt(Arrays.stream(series).map(a -> a * a).average().orElseThrow());
    }

    /** What a capacitor and a resistor pass of a series that runs straight between its samples: x' = w (y - x) is held back. */
    public static double[] coupled(double[] y, double step, double corner) {
        double a = 2 * Math.PI * corner * step;
        double kept = Math.exp(-a);
        double share = -Math.expm1(-a) / a;
        double[] out = new double[y.length];
        double x = y[0];
        for (int i = 0; i < y.length; i++) {
            x = i == 0 ? x : kept * x + (share - kept) * y[i - 1] + (1 - share) * y[i];
            out[i] = y[i] - x;
        }
        return out;
    }

    /**
     * A mass on a spring and a damper over the ground, pushed by {@code mass.force.z}.
     *
     * @param sensor on the mass, or a force's, in the link below it
     */
    public static Model oscillator(double mass, double stiffness, double damping, Channel sensor) {
        boolean below = sensor.quantity() == wbv.recording.Quantity.FORCE;
        return new Model("bench", Optional.empty(), 'z', new Model.Base("ground", Optional.empty()),
                java.util.List.of(body("mass", mass, below ? Optional.empty() : Optional.of(sensor))),
                java.util.List.of(link("ground", "mass", stiffness, damping, below ? Optional.of(sensor) : Optional.empty())),
                java.util.List.of(new Model.Input("mass", Channel.parse("mass.force.z"))));
    }

    public static Model.Body body(String name, double mass, Optional<Channel> sensor) {
        return new Model.Body(name, mass, sensor, java.util.List.of(), Optional.empty(), java.util.List.of());
    }

    public static Model.Link link(String from, String to, double stiffness, double damping, Optional<Channel> sensor) {
        return new Model.Link(from, to, stiffness, damping, sensor, java.util.List.of(), java.util.List.of());
    }

    /** Drawn as well, as whoever asks has it. */
    public static Diagnosis diagnosed(Model model, Recording recording) {
        Diagnosed found = Diagnoser.examine(new Question(model, recording, Optional.empty(), OptionalDouble.empty()), (step, share) -> {});
        Pictures.of(found);
        return found.diagnosis();
    }
}
