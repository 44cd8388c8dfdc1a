package wbv.rig;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Quantity;
import wbv.recording.Recording;
import wbv.rig.platform.Axis;
import wbv.rig.platform.PlatformExcitation;
import wbv.rig.platform.Program;
import wbv.rig.platform.SpecNumbers;

/**
 * An experiment: everything that a recording of the rig depends on. The same spec gives the same bytes, on any machine.
 *
 * <p>It is written as one line of words, which {@link #parse} reads and {@link #toString} writes in full, such as
 * {@code subject=2 regime=4 seconds=120 seed=7 rate=60 effects=usual,loss}.
 *
 * @param sitter   who sits on the platform
 * @param program  what the platform does, and for how long
 * @param seed     of everything random
 * @param rate     output rate of the sensors [Hz], &gt; 0 to 1000
 * @param filter   anti-alias filter of the sensors
 * @param noise    ratio of the densities of the sensors' noise to those of {@link ImuErrors#TABLE_3_2}, &gt;= 0
 * @param effects  what is on; of a linear sitter, only what the sensors do
 * @param channels what is recorded, in this order: {@code acc}, {@code accg}, {@code gyr} and {@code mag} of the sitter's places,
 *                 {@code force} of the seat
 */
public record RigSpec(Sitter sitter, Program program, long seed, double rate, AntiAlias filter, double noise, Effects effects,
        List<Channel> channels) {

    /** Inner rate of platform, sitter and sensors [Hz]. */
    public static final double INNER_RATE = 1000;

    private static final Set<Quantity> WORN = EnumSet.of(Quantity.ACCELERATION, Quantity.SPECIFIC_FORCE, Quantity.ANGULAR_RATE,
            Quantity.MAGNETIC_FIELD);

    public RigSpec {
        if (!(rate > 0 && rate <= INNER_RATE)) {
            throw new IllegalArgumentException("rate must be > 0 to 1000 Hz: " + rate);
        }
        if (!(noise >= 0) || Double.isInfinite(noise)) {
            throw new IllegalArgumentException("noise must be >= 0 times the usual: " + noise);
        }
        effects = sitter instanceof Sitter.Person ? effects : effects.ofSensors();
        channels = List.copyOf(channels);
        if (channels.isEmpty()) {
            throw new IllegalArgumentException("at least one channel must be recorded");
        }
        for (int i = 0; i < channels.size(); i++) {
            Channel channel = channels.get(i);
            if (!sitter.places().contains(channel.location())) {
                throw new IllegalArgumentException("a place of this sitter is one of " + sitter.places() + ": " + channel);
            }
            if (channel.quantity() == Quantity.FORCE ? !channel.location().equals("seat") : !WORN.contains(channel.quantity())) {
                throw new IllegalArgumentException("a sensor of the rig gives acc, accg, gyr or mag, and that on the seat force: "
                        + channel);
            }
            if (channels.indexOf(channel) != i) {
                throw new IllegalArgumentException("a channel can be recorded once only: " + channel);
            }
        }
    }

    /**
     * The linear sitter with one degree of freedom under vertical random motion from 0.5 to 12 Hz, at 60 Hz with the sensors'
     * usual errors: what an estimator is measured against.
     *
     * @param zeta damping ratio
     * @param frequency undamped natural frequency [Hz]
     * @param rms of the platform [m/s²]
     * @param seconds length [s]
     */
    public static RigSpec oneDof(double zeta, double frequency, double rms, double seconds, long seed) {
        Sitter sitter = new Sitter.OneDof(zeta, frequency, Optional.empty());
        return new RigSpec(sitter, Program.of(new PlatformExcitation.Random(Axis.Z, 0.5, 12, rms), seconds), seed, 60,
                AntiAlias.BOXCAR, 1, Effects.USUAL, Channels.usual(sitter, false));
    }

    /**
     * A person under a regime, all ten sensors at 60 Hz.
     *
     * @param subject 1 to 4
     * @param regime 0 to 8
     * @param seconds [s]
     */
    public static RigSpec person(int subject, int regime, double seconds, long seed) {
        Sitter sitter = new Sitter.Person(Subject.of(subject));
        return new RigSpec(sitter, Program.of(new PlatformExcitation.OfRegime(regime), seconds), seed, 60, AntiAlias.BOXCAR, 1,
                Effects.USUAL, Channels.usual(sitter, false));
    }

    /**
     * Reads a spec. Words and what they are when left out: {@code sitter=person} or {@code one-dof} or {@code two-dof};
     * {@code subject=1} to {@code 4}, or {@code random:7}, someone of a population; {@code mass=} (his own) [kg];
     * {@code posture=normal}, {@code slouched} or {@code erect}; {@code zeta=0.35 f0=5}; {@code cross=0.3,-0.2} (none;
     * {@link Sitter.OneDof}); {@code torso=50.2,74300,2807 head=5.5,41000,318} (kg, N/m, N·s/m);
     * {@code step=1.25@60} (none); {@code excitation=regime:1}, or {@code regime=1} for short ({@code random:z:0.5-12:1}
     * for linear sitters); {@code seconds=120} (or what the
     * segments of the excitation say); {@code seed=1}; {@code rate=60}; {@code filter=boxcar}; {@code noise=1};
     * {@code gravity=removed} or {@code included}; {@code channels=all}, or places or channels separated by commas,
     * such as {@code all,seat.force.z,head.mag.x};
     * {@code effects=usual}.
     *
     * @throws IllegalArgumentException if a word is unknown or its value does not fit
     */
    public static RigSpec parse(String text) {
        return new RigWords(text).spec();
    }

    /** The number of rows of the recording. */
    public long rows() {
        return Math.round(program.seconds() * rate);
    }

    /** The same with other random numbers. */
    public RigSpec withSeed(long other) {
        return new RigSpec(sitter, program, other, rate, filter, noise, effects, channels);
    }

    /** The same experiment with another length [s]: the last excitation is cut or goes on. */
    public RigSpec withSeconds(double seconds) {
        return new RigSpec(sitter, program.lasting(seconds), seed, rate, filter, noise, effects, channels);
    }

    /** The same with another program. */
    public RigSpec withProgram(Program other) {
        return new RigSpec(sitter, other, seed, rate, filter, noise, effects, channels);
    }

    /** The same with other effects. */
    public RigSpec withEffects(Effects others) {
        return new RigSpec(sitter, program, seed, rate, filter, noise, others, channels);
    }

    /** The same at another rate [Hz], &gt; 0 to 1000. */
    public RigSpec withRate(double other) {
        return new RigSpec(sitter, program, seed, other, filter, noise, effects, channels);
    }

    /** The same with another anti-alias filter. */
    public RigSpec withFilter(AntiAlias other) {
        return new RigSpec(sitter, program, seed, rate, other, noise, effects, channels);
    }

    /** The same with other channels recorded, in this order. */
    public RigSpec withChannels(List<Channel> others) {
        return new RigSpec(sitter, program, seed, rate, filter, noise, effects, others);
    }

    /**
     * All springs of a linear sitter multiplied at a time.
     *
     * @param factor new over old stiffness
     * @param time when [s]
     * @throws IllegalArgumentException if the sitter is a person
     */
    public RigSpec withStiffnessStep(double factor, double time) {
        Optional<Sitter.Step> step = Optional.of(new Sitter.Step(factor, time));
        Sitter other;
        if (sitter instanceof Sitter.OneDof one) {
            other = new Sitter.OneDof(one.zeta(), one.frequency(), step, one.crossX(), one.crossY());
        } else if (sitter instanceof Sitter.TwoDof two) {
            other = new Sitter.TwoDof(two.torso(), two.k1(), two.c1(), two.head(), two.k2(), two.c2(), step);
        } else {
            throw new IllegalArgumentException("a stiffness step needs a linear sitter: " + sitter);
        }
        return new RigSpec(other, program, seed, rate, filter, noise, effects, channels);
    }

    /** The whole recording, in memory. */
    public Recording recording() {
        Map<Channel, double[]> values = new LinkedHashMap<>();
        channels.forEach(channel -> values.put(channel, new double[Math.toIntExact(rows())]));
        double[][] columns = values.values().toArray(double[][]::new);
        double[] row = new double[1 + columns.length];
        RigRun run = run();
        for (int i = 0; run.read(row); i++) {
            for (int j = 0; j < columns.length; j++) {
                columns[j][i] = row[1 + j];
            }
        }
        return new Recording(new Clock(0, rate), values, run.metadata());
    }

    /** Plays the experiment from its beginning. */
    public RigRun run() {
        return new RigRun(this);
    }

    /** The spec in full, as {@link #parse} reads it. */
    @Override
    public String toString() {
        List<String> words = new ArrayList<>();
        if (sitter instanceof Sitter.OneDof one) {
            words.add("sitter=one-dof zeta=" + SpecNumbers.plain(one.zeta()) + " f0=" + SpecNumbers.plain(one.frequency()));
            if (one.crossX() != 0 || one.crossY() != 0) {
                words.add("cross=" + SpecNumbers.plain(one.crossX()) + ',' + SpecNumbers.plain(one.crossY()));
            }
            one.step().ifPresent(step -> words.add("step=" + step));
        } else if (sitter instanceof Sitter.TwoDof two) {
            words.add("sitter=two-dof torso=" + triple(two.torso(), two.k1(), two.c1()) + " head="
                    + triple(two.head(), two.k2(), two.c2()));
            two.step().ifPresent(step -> words.add("step=" + step));
        } else if (sitter instanceof Sitter.Person person) {
            words.add(person.subject().toString());
        }
        words.add("excitation=" + program);
        words.add("seconds=" + SpecNumbers.plain(program.seconds()));
        words.add("seed=" + seed);
        words.add("rate=" + SpecNumbers.plain(rate));
        words.add("filter=" + filter);
        words.add("noise=" + SpecNumbers.plain(noise));
        words.add("channels=" + Channels.format(sitter, channels));
        words.add("effects=" + effects);
        return String.join(" ", words);
    }

    private static String triple(double mass, double stiffness, double damping) {
        return SpecNumbers.plain(mass) + ',' + SpecNumbers.plain(stiffness) + ',' + SpecNumbers.plain(damping);
    }
}
