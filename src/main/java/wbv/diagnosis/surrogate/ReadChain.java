package wbv.diagnosis.surrogate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import wbv.body.Model;
import wbv.diagnosis.algebra.DampedEquations;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.signal.LostSamples;

/**
 * Which bodies hang on which, read from their motion where all of them were measured: what accelerates a body is what springs and dashpots
 * to the others make of the distances to them, which is linear in these.
 *
 * <p>Accelerations alone know distances and their rates without constants: the equation of motion is weighted by the second derivative of a
 * smooth pulse and integrated by parts, so that only accelerations are left (modulating functions: Shinbrot 1957). Pulses of several widths
 * let resonances count wherever they are. With a body that nobody measured it is wrong, and a start like others.
 */
final class ReadChain {

    /** Standard deviation of the narrowest pulse, in samples: it has left 7e-3 at half the Nyquist frequency, 3e-9 at that itself. */
    private static final double NARROWEST = 2;
    /** How many times as wide each is as the one before. */
    private static final double WIDER = 2;
    /** Width of the widest, over the length of the recording: of so many about two hundred go beside one another. */
    private static final double WIDEST = 0.005;
    /** Where a pulse ends, in standard deviations: what is left out is 1e-8 of it. */
    private static final double END = 6;
    /** Damping of a link that seems to have none, as a ratio under one of the two bodies. */
    private static final double LEAST_RATIO = 0.01;

    /** Base first, then the bodies. */
    private final List<double[]> accelerations;
    private final double rate;
    /** Stiffness and damping over the mass of the body [body][other][2]. */
    private final double[][][] carried;
    /** How much of what accelerates a body another makes [body][other], 0 where it pushes it away. */
    private final double[][] shares;

    private ReadChain(Recording driven, Channel input, List<Channel> outputs) {
        accelerations = new ArrayList<>(List.of(LostSamples.filled(driven.values(input))));
        outputs.forEach(output -> accelerations.add(LostSamples.filled(driven.values(output))));
        rate = driven.clock().rate();
        carried = new double[accelerations.size()][accelerations.size()][2];
        shares = new double[accelerations.size()][accelerations.size()];
        IntStream.range(1, accelerations.size()).forEach(this::read);
    }

    /**
     * The bodies in the tree of links that make most of their motion; empty where some body seems to hang on nothing.
     *
     * @param driven  input and outputs
     * @param outputs one of each body
     */
    static Optional<Model> of(Recording driven, Channel input, List<Channel> outputs) {
        return new ReadChain(driven, input, outputs).tree().map(tree -> tree.model(input, outputs));
    }

    /** What the others do to a body, by least squares. */
    private void read(int body) {
        int others = accelerations.size();
        double[][] normal = new double[2 * others][2 * others];
        double[] right = new double[2 * others];
        double all = 0;
        int length = accelerations.get(0).length;
        for (double width = NARROWEST; width <= Math.max(NARROWEST, WIDEST * length); width *= WIDER) {
            Pulse pulse = Pulse.of(width, rate);
            int step = (int) Math.max(1, width);
            double[][] rows = IntStream.iterate(pulse.reach(), at -> at + pulse.reach() < length, at -> at + step)
                    .mapToObj(at -> row(body, pulse, at)).toArray(double[][]::new);
            centre(rows);
            // Slow pulses weigh as much as fast ones.
            double size = Arrays.stream(rows).mapToDouble(row -> row[2 * others] * row[2 * others]).sum();
            for (double[] row : size > 0 ? rows : new double[0][]) {
                for (int i = 0; i < 2 * others; i++) {
                    for (int j = 0; j < 2 * others; j++) {
                        normal[i][j] += row[i] * row[j] / size;
                    }
                    right[i] += row[i] * row[2 * others] / size;
                }
            }
            all += size > 0 ? 1 : 0;
        }
        boolean[] held = new boolean[2 * others];
        held[2 * body] = true;
        held[2 * body + 1] = true;
        double[] found = DampedEquations.solve(normal, right, held, 0);
        for (int other = 0; other < others; other++) {
            double k = found[2 * other];
            double c = found[2 * other + 1];
            carried[body][other] = new double[] {k, c};
            double square = k * k * normal[2 * other][2 * other] + 2 * k * c * normal[2 * other][2 * other + 1]
                    + c * c * normal[2 * other + 1][2 * other + 1];
            shares[body][other] = k > 0 ? Math.sqrt(square / all) : 0;
        }
    }

    /**
     * Takes the mean of each column: an offset of a sensor, or of the base that a simulation took none of, moves nothing.
     *
     * @param rows Modified.
     */
    private static void centre(double[][] rows) {
        for (int column = 0; rows.length > 0 && column < rows[0].length; column++) {
            int at = column;
            double mean = Arrays.stream(rows).mapToDouble(row -> row[at]).average().orElseThrow();
            for (double[] row : rows) {
                row[at] -= mean;
            }
        }
    }

    /** What distances to the others and their rates weigh at a pulse, and what the body's acceleration does. */
    private double[] row(int body, Pulse pulse, int at) {
        int others = accelerations.size();
        double[] out = new double[2 * others + 1];
        double[] own = accelerations.get(body);
        for (int other = 0; other < others; other++) {
            double[] beside = accelerations.get(other);
            for (int i = -pulse.reach(); i <= pulse.reach(); i++) {
                double apart = beside[at + i] - own[at + i];
                out[2 * other] += pulse.height()[i + pulse.reach()] * apart;
                out[2 * other + 1] -= pulse.slope()[i + pulse.reach()] * apart;
            }
        }
        for (int i = -pulse.reach(); i <= pulse.reach(); i++) {
            out[2 * others] += pulse.bend()[i + pulse.reach()] * own[at + i];
        }
        return out;
    }

    /**
     * A smooth pulse and its derivatives, in units of samples and seconds.
     *
     * @param height by sample [1]
     * @param slope  [1/s]
     * @param bend   [1/s²]
     */
    private record Pulse(double[] height, double[] slope, double[] bend) {

        /** @param width standard deviation of a bell, in samples */
        static Pulse of(double width, double rate) {
            int reach = (int) Math.ceil(END * width);
            double[] at = IntStream.rangeClosed(-reach, reach).mapToDouble(i -> i / width).toArray();
            double[] height = Arrays.stream(at).map(s -> Math.exp(-s * s / 2)).toArray();
            double per = rate / width;
            return new Pulse(height, IntStream.range(0, at.length).mapToDouble(i -> -per * at[i] * height[i]).toArray(),
                    IntStream.range(0, at.length).mapToDouble(i -> per * per * (at[i] * at[i] - 1) * height[i]).toArray());
        }

        int reach() {
            return height.length / 2;
        }
    }

    /** How much of the motion of two bodies what is between them makes, of each of the two; all of one where the other is the base. */
    private double strength(int one, int other) {
        int low = Math.min(one, other);
        int high = Math.max(one, other);
        return low == 0 ? shares[high][0] : Math.sqrt(shares[low][high] * shares[high][low]);
    }

    /**
     * Bodies on one another.
     *
     * @param masses of base and bodies over that of the first body that stands on the base [1]
     * @param links  pairs of these, from below
     */
    private record Tree(ReadChain read, double[] masses, List<int[]> links) {
        Model model(Channel input, List<Channel> outputs) {
            List<Model.Body> bodies = IntStream.range(0, outputs.size()).mapToObj(
                    i -> ChainArrangements.body(outputs.get(i).location(), masses[i + 1], Optional.of(outputs.get(i)))).toList();
            return new Model("surrogate", Optional.empty(), input.axis(), new Model.Base(input.location(), Optional.of(input)), bodies,
                    links.stream().map(link -> link(link, input, outputs)).toList());
        }

        private Model.Link link(int[] ends, Channel input, List<Channel> outputs) {
            double mass = masses[ends[1]];
            double stiffness = mass * read.carried[ends[1]][ends[0]][0];
            double damping = Math.max(mass * read.carried[ends[1]][ends[0]][1], 2 * LEAST_RATIO * Math.sqrt(stiffness * mass));
            return ChainArrangements.link(ends[0] == 0 ? input.location() : outputs.get(ends[0] - 1).location(),
                    outputs.get(ends[1] - 1).location(), stiffness, damping);
        }
    }

    /** The tree of greatest strength (Prim 1957), with masses by which both ends of a link are pulled alike. */
    private Optional<Tree> tree() {
        int count = accelerations.size();
        double[] masses = new double[count];
        List<int[]> links = new ArrayList<>();
        Set<Integer> open = new HashSet<>(IntStream.range(1, count).boxed().toList());
        while (!open.isEmpty()) {
            int[] best = {0, 0};
            for (int from = 0; from < count; from++) {
                for (int to : open.contains(from) ? Set.<Integer>of() : open) {
                    best = strength(from, to) > strength(best[0], best[1]) ? new int[] {from, to} : best;
                }
            }
            if (best[1] == 0) {
                return Optional.empty();
            }
            // On the base a mass may be any; what stands there beside others is taken for as heavy as they are.
            masses[best[1]] = best[0] == 0 ? 1 : masses[best[0]] * carried[best[0]][best[1]][0] / carried[best[1]][best[0]][0];
            links.add(best);
            open.remove(best[1]);
        }
        return Optional.of(new Tree(this, masses, links));
    }
}
