package wbv.rig.concealed;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/**
 * A laboratory bench: one or two masses on springs, or one that nothing holds, moved by a measured force or on a measured base.
 *
 * @param chain    springs and dashpots; of a free mass the stiffness is 0
 * @param pushed   body on which the force acts, -1 where the base is shaken
 * @param axis     along which all moves
 * @param quantity that every body's sensor measures
 * @param first    the first resonance; of a free mass the middle of what moves it [Hz]
 * @param last the highest, as {@code first} for one mass [Hz]
 * @param rate     of the rows [Hz]
 * @param seconds of a recording
 * @param sweeps whether it is moved by sweeps, else at random
 * @param strength of what moves it, root mean square [N or m/s²]
 * @param noise standard deviation of a sensor's noise over what it measures
 */
record Bench(Chain chain, int pushed, char axis, Quantity quantity, double first, double last, double rate, double seconds, boolean sweeps,
        double strength, double noise) {

    /**
     * Fine samples in a period of the highest resonance: a force that is straight between them is off by 0.1 % at two and a half times
     * that.
     */
    private static final double FINE = 160;
    /** Steps a fine sample: bristles of friction need 300 a period. */
    private static final int STEPS = 5;
    private static final int COARSE = 3;
    /** Rows of the longest recording, where two seconds are not more. */
    private static final double ROWS = 20_000;
    private static final int TONES = 300;
    private static final List<String> NAMES = List.of("mass", "load");

    /** What a bench must be like. */
    enum Kind { ANY, HELD, SHAKEN, FREE }

    /** @param levels whether it is recorded at several levels, 6 s at least each */
    static Bench draw(Kind kind, boolean levels, RandomGenerator random) {
        boolean free = kind == Kind.FREE || kind == Kind.ANY && random.nextDouble() < 0.2;
        boolean shaken = kind == Kind.SHAKEN || !free && random.nextDouble() < 0.5;
        double first = free ? 4 * Math.pow(10, random.nextDouble()) : 5 * Math.pow(levels ? 20 : 200, random.nextDouble());
        int bodies = free || first > 300 || random.nextBoolean() ? 1 : 2;
        Chain chain = free ? free(first, random) : held(first, bodies, random);
        double last = free ? first : chain.frequencies()[bodies - 1];
        double rate = nice((8 + 8 * random.nextDouble()) * last);
        double periods = 80 * Math.pow(6, random.nextDouble());
        double seconds = Math.max(levels ? 6 : 2, Math.min(Math.min(60, ROWS / rate), Math.max(periods / first, free ? 10 : 0)));
        Quantity quantity = shaken ? Quantity.ACCELERATION : free ? random.nextBoolean() ? Quantity.POSITION : Quantity.VELOCITY
                : List.of(Quantity.ACCELERATION, Quantity.ACCELERATION, Quantity.VELOCITY, Quantity.POSITION).get(random.nextInt(4));
        double strength = (1 + 9 * random.nextDouble()) * (shaken ? 1 : chain.mass()[0]);
        double noise = (quantity == Quantity.POSITION ? 2e-4 : 2e-3) * Math.pow(5, random.nextDouble());
        return new Bench(chain, shaken ? -1 : free ? 0 : random.nextInt(bodies), random.nextBoolean() ? 'x' : 'z', quantity, first, last,
                rate, seconds, !free && random.nextBoolean(), strength, noise);
    }

    private static Chain free(double hertz, RandomGenerator random) {
        double mass = 1 + 30 * random.nextDouble();
        return new Chain(NAMES.subList(0, 1), new int[] {-1}, new double[] {mass}, new double[] {0},
                new double[] {(0.05 + 0.15 * random.nextDouble()) * mass * 2 * Math.PI * hertz});
    }

    private static Chain held(double first, int bodies, RandomGenerator random) {
        double[] mass = new double[bodies];
        double[] stiffness = new double[bodies];
        double[] damping = new double[bodies];
        int[] parent = new int[bodies];
        double carried = 0;
        for (int i = bodies - 1; i >= 0; i--) {
            mass[i] = i > 0 ? 0.2 + 0.8 * random.nextDouble() : 1;
            carried += mass[i];
            double omega = 2 * Math.PI * first * (i > 0 ? 1.3 + 0.9 * random.nextDouble() : 1.2);
            stiffness[i] = carried * omega * omega;
            damping[i] = 2 * (0.02 + 0.08 * random.nextDouble()) * carried * omega;
            parent[i] = i - 1;
        }
        double kilograms = (first < 30 ? 5 : first < 200 ? 0.5 : 0.05) * Math.pow(10, random.nextDouble());
        double ratio = first / new Chain(NAMES.subList(0, bodies), parent, mass, stiffness, damping).frequencies()[0];
        for (int i = 0; i < bodies; i++) {
            mass[i] *= kilograms;
            stiffness[i] *= kilograms * ratio * ratio;
            damping[i] *= kilograms * ratio;
        }
        return new Chain(NAMES.subList(0, bodies), parent, mass, stiffness, damping);
    }

    /** To two digits, as rates are chosen. */
    private static double nice(double rate) {
        double unit = Math.pow(10, Math.floor(Math.log10(rate)) - 1);
        return Math.rint(rate / unit) * unit;
    }

    boolean isFree() {
        return chain.stiffness()[0] == 0;
    }

    Acquisition acquisition() {
        return new Acquisition(rate, (int) Math.ceil(FINE * last / rate));
    }

    /**
     * What moves it, by fine sample: at rest first and last.
     *
     * @param level over the usual one
     */
    double[] drive(double level, RandomGenerator random) {
        Acquisition fine = acquisition();
        int length = (int) Math.rint(seconds * rate) * (int) Math.rint(fine.fine() / rate);
        int begin = length / 50;
        double[] part = sweeps ? sweep(length - begin - length / 12, fine.fine(), random)
                : tones(length - begin - length / 12, fine.fine(), (isFree() ? 0.3 : 0.15) * first, (isFree() ? 3 : 2.2) * last, random);
        int fade = part.length / 40;
        for (int i = 0; i < fade; i++) {
            double gain = 0.5 - 0.5 * StrictMath.cos(Math.PI * i / fade);
            part[i] *= gain;
            part[part.length - 1 - i] *= gain;
        }
        double[] out = new double[length];
        System.arraycopy(UniformSeries.scaled(part, level * strength / UniformSeries.rms(part)), 0, out, begin, part.length);
        return out;
    }

    /** Sines of random phase, all of one amplitude. */
    private static double[] tones(int length, double fine, double low, double high, RandomGenerator random) {
        double[] out = new double[length];
        for (int tone = 0; tone < TONES; tone++) {
            double turn = 2 * Math.PI * (low + (high - low) * (tone + random.nextDouble()) / TONES) / fine;
            double phase = 2 * Math.PI * random.nextDouble();
            double cos = StrictMath.cos(turn);
            double sin = StrictMath.sin(turn);
            double re = StrictMath.cos(phase);
            double im = StrictMath.sin(phase);
            for (int i = 0; i < length; i++) {
                out[i] += im;
                double next = re * cos - im * sin;
                im = re * sin + im * cos;
                re = next;
            }
        }
        return out;
    }

    /** Two to five sweeps up and down, each octave as long as the next. */
    private double[] sweep(int length, double fine, RandomGenerator random) {
        double[] out = new double[length];
        int passes = 2 + random.nextInt(4);
        double low = 0.25 * first;
        double octaves = Math.log(1.8 * last / low);
        double phase = 0;
        for (int i = 0; i < length; i++) {
            double along = (double) i * passes / length;
            double share = along - Math.floor(along);
            out[i] = StrictMath.sin(phase);
            phase += 2 * Math.PI * low * Math.exp(octaves * ((int) along % 2 == 0 ? share : 1 - share)) / fine;
        }
        return out;
    }

    /**
     * How it moves.
     *
     * @param fine whether to the last digit, or as far as sizes matter
     */
    ChainPlant.Trace run(Setup setup, double[] drive, boolean fine) {
        double[] base = pushed < 0 ? drive : new double[drive.length];
        double rate = acquisition().fine();
        return new ChainPlant(setup, rate, fine ? STEPS : COARSE).run(base, rate);
    }

    /** The bench with nothing concealed. */
    Setup setup(double[] drive) {
        Setup setup = new Setup(chain);
        if (pushed >= 0) {
            setup.push(pushed, drive);
        }
        return setup;
    }

    /** What a body's sensor feels, by fine sample. */
    double[] felt(ChainPlant.Trace trace, int body, Quantity what) {
        if (what == Quantity.ACCELERATION) {
            return trace.acceleration()[body];
        }
        double[] sum = new double[trace.acceleration()[body].length];
        for (int i = body; i >= 0; i = chain.parent()[i]) {
            double[] one = what == Quantity.VELOCITY ? trace.rate()[i] : trace.extension()[i];
            Arrays.setAll(sum, s -> sum[s] + one[s]);
        }
        return sum;
    }

    /** A free mass wanders, so that of its position no spectrum can be taken: its speed serves for sizes. */
    Quantity sized() {
        return isFree() ? Quantity.VELOCITY : quantity;
    }

    /**
     * Best linear benches for outputs of perfect sensors.
     *
     * @param rows of what moves it, and of each body as {@link #sized}
     */
    LinearFit fit(double[] rows, double[][] outputs) {
        int[] body = new int[outputs.length];
        int[] order = new int[outputs.length];
        Arrays.setAll(body, i -> i);
        Arrays.fill(order, sized() == Quantity.ACCELERATION ? 2 : sized() == Quantity.VELOCITY ? 1 : 0);
        return new LinearFit(body, new LinearFit.Drive(pushed, order), rows, outputs, rate, low(), high());
    }

    /** Edges of the band that is moved [Hz]. */
    double low() {
        return (isFree() ? 0.3 : 0.25) * first;
    }

    double high() {
        return Math.min(0.38 * rate, (isFree() ? 2.5 : 1.8) * last);
    }

    String base() {
        return pushed < 0 ? "table" : "ground";
    }

    String link(int i) {
        return (i == 0 ? base() : chain.names().get(i - 1)) + "-" + chain.names().get(i);
    }

    Channel input() {
        return pushed < 0 ? new Channel(base(), Quantity.ACCELERATION, axis) : new Channel(chain.names().get(pushed), Quantity.FORCE, axis);
    }

    Channel output(int body) {
        return new Channel(chain.names().get(body), quantity, axis);
    }

    List<Channel> channels() {
        List<Channel> out = new ArrayList<>(List.of(input()));
        for (int i = 0; i < chain.size(); i++) {
            out.add(output(i));
        }
        return out;
    }

    /**
     * As its user writes it.
     *
     * @param values as he believes them to be
     */
    ObjectNode json(String name, Chain values) {
        ObjectNode root = values.json(name, List.of());
        root.put("subject", "rig").put("axis", String.valueOf(axis));
        ObjectNode base = root.putObject("base").put("name", base());
        if (pushed < 0) {
            base.put("sensor", input().toString());
        } else {
            base.putNull("sensor");
            ArrayNode inputs = root.putArray("inputs");
            inputs.addObject().put("body", chain.names().get(pushed)).put("sensor", input().toString());
        }
        for (int i = 0; i < chain.size(); i++) {
            ((ObjectNode) root.get("bodies").get(i)).put("sensor", output(i).toString());
            ((ObjectNode) root.get("links").get(i)).put("from", i == 0 ? base() : chain.names().get(i - 1));
        }
        return root;
    }
}
