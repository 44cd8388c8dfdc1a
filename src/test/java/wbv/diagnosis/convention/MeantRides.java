package wbv.diagnosis.convention;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import wbv.body.Model;
import wbv.diagnosis.Bench;
import wbv.recording.Channel;
import wbv.recording.Recording;

/**
 * People and benches in chains, simulated here by code that shares nothing with the models, and models of them whose numbers are off by
 * what users err by.
 */
final class MeantRides {

    /** A model and a recording as they are meant. */
    record Ride(Model model, Recording recording) {
        Ride reading(Channel channel, UnaryOperator<double[]> how) {
            Map<Channel, double[]> values = new LinkedHashMap<>();
            recording.channels().forEach(each -> values.put(each,
                    each.equals(channel) ? how.apply(recording.values(each)) : recording.values(each)));
            return new Ride(model, new Recording(recording.clock(), values, recording.metadata()));
        }

        Ride times(String channel, double factor) {
            return reading(Channel.parse(channel), x -> Arrays.stream(x).map(value -> factor * value).toArray());
        }

        Ride exchanged(String one, String other) {
            double[] first = recording.values(Channel.parse(one));
            double[] second = recording.values(Channel.parse(other));
            return reading(Channel.parse(one), x -> second).reading(Channel.parse(other), x -> first);
        }

        Ride of(Model other) {
            return new Ride(other, recording);
        }
    }

    /** What a link carries beside its spring and damper [N], by its stretch [m] and its rate [m/s]. */
    interface Extra {
        Extra NONE = (r, v) -> 0;

        double force(double stretch, double rate);
    }

    private MeantRides() {}

    /**
     * A seat, a trunk and a head, shaken from 0.8 to 18 Hz for a minute.
     *
     * @param off standard deviation of the logarithm of what is given
     */
    static Ride person(long seed, double off, Extra seat) {
        return shaken(seed, off, Model.Subject.PERSON, 60, 60, 18, new String[] {"seat", "trunk", "head"}, new double[] {12, 48, 5},
                new double[] {70e3, 60e3, 28e3}, new double[] {900, 1200, 160}, seat, "acc");
    }

    /** Two masses on a table. */
    static Ride bench(long seed, double off, Extra first) {
        return shaken(seed, off, Model.Subject.RIG, 200, 40, 30, new String[] {"frame", "load"}, new double[] {4, 9},
                new double[] {30e3, 12e3}, new double[] {60, 40}, first, "acc");
    }

    /** A mass on the ground that is pushed. @param quantity what is read of it */
    static Ride pushed(long seed, double off, String quantity, Extra spring) {
        Random random = new Random(seed);
        double[] given = errors(random, off, 3);
        DoubleUnaryOperator push = Bench.tones(40, 0.5, 0.49, 3.4, random);
        Bench bench = new Bench(200, 30, 20, 2).run((t, x, v, out) -> out[0] = push.applyAsDouble(t) - 25 * v[0] - 8000 * x[0]
                - spring.force(x[0], v[0]));
        Channel sensor = Channel.parse("mass." + quantity + ".z");
        double[] read = bench.sampled(quantity.equals("pos") ? bench.position(0)
                : quantity.equals("vel") ? bench.velocity(0) : bench.acceleration(0));
        return new Ride(Bench.oscillator(2 * given[0], 8000 * given[1], 25 * given[2], sensor),
                bench.recording("mass.force.z", Bench.noisyBy(0.003, bench.sampled(push), random), sensor,
                        Bench.noisyBy(0.003, read, random)));
    }

    /** A mass that a force of one size pushes to and fro, as a binary sequence has it, and whose speed is read without its sign. */
    static Ride switched(long seed) {
        Random random = new Random(seed);
        double[] given = errors(random, 0.3, 3);
        double[] side = IntStream.range(0, 400).mapToDouble(i -> random.nextBoolean() ? 1 : -1).toArray();
        DoubleUnaryOperator push = t -> side[(int) (t / 0.2) % side.length];
        Bench bench = new Bench(50, 60, 40, 0.05).run((t, x, v, out) -> out[0] = push.applyAsDouble(t) - 0.5 * v[0] - 1.5 * x[0]);
        Channel sensor = Channel.parse("mass.vel.z");
        double[] read = Arrays.stream(bench.sampled(bench.velocity(0))).map(Math::abs).toArray();
        return new Ride(Bench.oscillator(0.05 * given[0], 1.5 * given[1], 0.5 * given[2], sensor),
                bench.recording("mass.force.z", bench.sampled(push), sensor, Bench.noisyBy(0.003, read, random)));
    }

    private static double[] errors(Random random, double off, int count) {
        return random.doubles(count).map(any -> Math.exp(off * random.nextGaussian())).toArray();
    }

    private static Ride shaken(long seed, double off, Model.Subject subject, double rate, double seconds, double highest, String[] names,
            double[] mass, double[] stiffness, double[] damping, Extra extra, String quantity) {
        Random random = new Random(seed);
        int n = names.length;
        double[] given = errors(random, off, 3 * n);
        double lowest = 0.8;
        double apart = (highest - lowest) / 50;
        double[] omega = IntStream.range(0, 51).mapToDouble(k -> 2 * Math.PI * (lowest + (k + 0.5 * random.nextDouble()) * apart))
                .toArray();
        double[] phase = random.doubles(51, 0, 2 * Math.PI).toArray();
        double size = 1.2 * Math.sqrt(2.0 / 51);
        DoubleUnaryOperator place = t -> sum(omega, phase, w -> -size / (w * w), t, 0);
        DoubleUnaryOperator speed = t -> sum(omega, phase, w -> -size / w, t, 1);
        Bench bench = new Bench(rate, seconds, (int) (1200 / rate), mass);
        double[] at = new double[n];
        Arrays.fill(at, place.applyAsDouble(0));
        double[] going = new double[n];
        Arrays.fill(going, speed.applyAsDouble(0));
        bench.run((t, x, v, out) -> {
            Arrays.fill(out, 0);
            for (int i = 0; i < n; i++) {
                double r = x[i] - (i == 0 ? place.applyAsDouble(t) : x[i - 1]);
                double dr = v[i] - (i == 0 ? speed.applyAsDouble(t) : v[i - 1]);
                double force = stiffness[i] * r + damping[i] * dr + (i == 0 ? extra.force(r, dr) : 0);
                out[i] -= force;
                if (i > 0) {
                    out[i - 1] += force;
                }
            }
        }, at, going, (t, x, v, out) -> {});
        List<Object> columns = new ArrayList<>(List.of("platform.acc.z",
                Bench.noisy(bench.sampled(t -> sum(omega, phase, w -> size, t, 0)), 0.01, random)));
        List<Model.Body> bodies = new ArrayList<>();
        List<Model.Link> links = new ArrayList<>();
        for (int i = 0; i < n; i++) {
            Channel sensor = Channel.parse(names[i] + "." + quantity + ".z");
            columns.addAll(List.of(sensor, Bench.noisy(bench.sampled(bench.acceleration(i)), 0.012, random)));
            // A person's masses are known better.
            double heavier = subject == Model.Subject.PERSON ? Math.pow(given[3 * i], 0.3) : given[3 * i];
            bodies.add(Bench.body(names[i], mass[i] * heavier, Optional.of(sensor)));
            links.add(Bench.link(i == 0 ? "platform" : names[i - 1], names[i], stiffness[i] * given[3 * i + 1],
                    damping[i] * given[3 * i + 2], Optional.empty()));
        }
        Model model = new Model("chain", Optional.empty(), 'z', new Model.Base("platform", Optional.of(Channel.parse("platform.acc.z"))),
                bodies, links, List.of(), Optional.of(subject));
        return new Ride(model, bench.recording(columns.toArray()));
    }

    private static double sum(double[] omega, double[] phase, DoubleUnaryOperator size, double t, int derivative) {
        double sum = 0;
        for (int k = 0; k < omega.length; k++) {
            sum += size.applyAsDouble(omega[k]) * (derivative == 0 ? Math.sin(omega[k] * t + phase[k]) : Math.cos(omega[k] * t + phase[k]));
        }
        return sum;
    }
}
