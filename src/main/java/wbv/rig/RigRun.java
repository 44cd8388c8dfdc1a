package wbv.rig;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.recording.Channel;
import wbv.recording.Metadata;
import wbv.recording.RowReader;
import wbv.rig.platform.Axis;
import wbv.rig.platform.PlatformCommand;
import wbv.rig.platform.Seeds;

/**
 * An experiment being played, sample by sample, in memory that does not grow: a {@link RowReader} of what the sensors say,
 * and beside every row the truth.
 *
 * <p>Row i is at i / rate seconds, the same instant for all sensors: one clock. With the boxcar its values are means over the
 * 1 / rate seconds before. Excitation begins at 0.
 */
public final class RigRun implements RowReader {

    private static final String SOURCE = "simulated by wbv rig, not measured; AGPL-3.0-or-later";

    private final RigSpec spec;
    private final double ticksPerRow;
    private final long rows;
    private final double[] command = new double[Axis.COUNT];
    private final PlaceMotion platform = new PlaceMotion();
    private final PlatformCommand drive;
    private final Hexapod hexapod;
    private final Plant plant;
    private final Imu[] imus;
    private final double[] clean;
    private final Happenings happenings;
    private long tick;
    private long row;

    RigRun(RigSpec spec) {
        double h = 1 / RigSpec.INNER_RATE;
        Seeds seeds = new Seeds(spec.seed());
        List<String> places = spec.sitter().places();
        this.spec = spec;
        ticksPerRow = RigSpec.INNER_RATE / spec.rate();
        rows = spec.rows();
        // The first output needs a whole interval before it: start at rest one interval early.
        tick = -(long) Math.ceil(ticksPerRow) - 1;
        drive = spec.program().drive(h, seeds.of("program"));
        hexapod = new Hexapod(h);
        plant = Plant.of(spec.sitter(), spec.effects(), h, (tick + 1) * h);
        imus = new Imu[places.size()];
        ImuErrors errors = ImuErrors.TABLE_3_2.withNoise(spec.noise());
        for (int i = 0; i < imus.length; i++) {
            imus[i] = new Imu(i, places.get(i), spec.channels(), errors, spec.effects(), spec.filter(), spec.rate(), h, seeds);
        }
        clean = new double[1 + spec.channels().size()];
        happenings = new Happenings(plant, places, spec.rate());
        advanceTo(-ticksPerRow, clean, false);
    }

    /** The experiment. */
    public RigSpec spec() {
        return spec;
    }

    @Override
    public List<Channel> channels() {
        return spec.channels();
    }

    /** Rate, subject and the spec, by which the recording can be made again. */
    @Override
    public Metadata metadata() {
        Optional<Metadata.Subject> subject = spec.sitter() instanceof Sitter.Person person
                ? Optional
                        .of(new Metadata.Subject(OptionalDouble.of(person.subject().mass()), OptionalDouble.of(person.subject().stature()),
                                OptionalDouble.empty(), Optional.empty()))
                : Optional.empty();
        return new Metadata(OptionalDouble.of(spec.rate()), Map.of(), subject, Optional.of("simulated: " + spec.program()),
                OptionalDouble.empty(), Optional.of(SOURCE), Map.of("rig", spec.toString()));
    }

    @Override
    public boolean read(double[] into) {
        if (row == rows) {
            return false;
        }
        advanceTo(row * ticksPerRow, into, true);
        into[0] = row / spec.rate();
        clean[0] = into[0];
        happenings.take(drive);
        row++;
        return true;
    }

    /** Always 0: there is no file. */
    @Override
    public long line() {
        return 0;
    }

    /** Nothing to close. */
    @Override
    public void close() {}

    /** Names of the true parameters of the sitter, such as {@code zeta} and {@code omega} (natural, undamped, rad/s). */
    public List<String> parameters() {
        return plant.parameters();
    }

    /**
     * The true parameters at the last row read.
     *
     * @param into as long as {@link #parameters}, each in its own unit. Modified.
     */
    public void parameters(double[] into) {
        plant.parameters(into);
    }

    /** Names of the states of the equations of motion, with their units. */
    public List<String> states() {
        return plant.states();
    }

    /**
     * The states at the last row read.
     *
     * @param into as long as {@link #states}, each in its own unit. Modified.
     */
    public void states(double[] into) {
        plant.states(into);
    }

    /**
     * Names of what is true of the events of a ride: {@code episode} (0 idle, 1 riding, 2 rocking), {@code jolt} (1 from its
     * beginning until the sitter has rung out), and how seat and head really jerked up [m/s³]. None for other programs.
     */
    public List<String> events() {
        return spec.program().eventful() ? Happenings.NAMES : List.of();
    }

    /**
     * What is true of the events at the last row read.
     *
     * @param into as long as {@link #events}, each in its own unit. Modified.
     */
    public void events(double[] into) {
        if (into.length > 0) {
            happenings.copy(into);
        }
    }

    /**
     * What ideal sensors, without noise, bias, tilt, bandwidth, range or loss, would have given as the last row read.
     *
     * @param into time [s] and channels in SI units, as long as for {@link #read}. Modified.
     */
    public void ideal(double[] into) {
        System.arraycopy(clean, 0, into, 0, clean.length);
    }

    /** The constant errors of the sensors by name: tilt [rad] and bias of every channel in its unit. */
    public Map<String, Double> sensorErrors() {
        Map<String, Double> errors = new LinkedHashMap<>();
        List<String> places = spec.sitter().places();
        for (int i = 0; i < imus.length; i++) {
            imus[i].describe(errors, places.get(i));
        }
        return errors;
    }

    private void advanceTo(double instant, double[] into, boolean wanted) {
        while (tick < instant) {
            tick++;
            if (tick >= 0) {
                Arrays.fill(command, 0);
                drive.next(1, command);
            }
            hexapod.step(command, platform);
            plant.step(platform);
            for (Imu imu : imus) {
                imu.sense(plant);
            }
        }
        double fraction = instant - (tick - 1);
        for (Imu imu : imus) {
            imu.take(fraction, wanted ? into : clean, clean, 1);
        }
    }
}
