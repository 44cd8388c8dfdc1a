package wbv.diagnosis.fit;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.Model;
import wbv.body.Structure;
import wbv.body.law.Law;
import wbv.body.number.Modulator;
import wbv.diagnosis.mechanism.Scene;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/** What mechanisms take their measure from, as some evidence shows it. */
public final class FittedScene {

    /** What may set a rig, and of these what moves nothing itself. */
    private static final Set<Quantity> SETS_ONLY = Set.of(Quantity.VOLTAGE, Quantity.TEMPERATURE);
    private static final Set<
            Quantity> SETTING = Set.of(Quantity.VOLTAGE, Quantity.TEMPERATURE, Quantity.POSITION, Quantity.ANGLE, Quantity.FORCE);
    /** Parts of a channel's range that are told apart: two for each number of the polynomial that takes most. */
    private static final int PARTS = 9;
    /** Of each of them, where a level may lie. */
    private static final int FINER = 3;
    /** Part of the record that is more than passing by [1]. */
    private static final double A_WHILE = 0.02;

    private final Evidence evidence;
    private final Assembly fitted;
    private final Motion motion;
    /** Samples of the motion up to the end of what is fitted. */
    private final int samples;

    private FittedScene(Evidence evidence, Assembly fitted, Motion motion) {
        this.evidence = evidence;
        this.fitted = fitted;
        this.motion = motion;
        double rate = evidence.recording().clock().rate();
        this.samples = (int) ((evidence.fit().start() + evidence.fit().length()) / rate / evidence.excitation().fineStep());
    }

    /**
     * What mechanisms may know of the evidence.
     *
     * @param fitted the baseline as fitted
     * @param motion of it
     * @param lines frequencies at which the residual stands out [Hz]
     */
    public static Scene of(Evidence evidence, Assembly fitted, Motion motion, double... lines) {
        FittedScene scene = new FittedScene(evidence, fitted, motion);
        Model model = evidence.model();
        return new Scene(model, evidence.onRig(), fitted.structure(),
                IntStream.range(0, model.links().size()).mapToObj(scene::link).toList(),
                IntStream.range(0, model.bodies().size()).filter(scene::standsOnBase).boxed().collect(Collectors.toSet()),
                evidence.measured()::across, evidence.measured()::companions,
                IntStream.range(0, evidence.outputs().size()).mapToObj(evidence::measured).toList(),
                lines, evidence.fit().spacing(), evidence.recording().clock().step(),
                evidence.recording().elapsed(evidence.fit().start() + evidence.fit().length()),
                scene.schedules());
    }

    /**
     * Channels by which links of a rig may go: across the motion, of a place where the model has no sensor, or of what only sets a rig and
     * moves nothing; what is read along the motion may be what it makes. Levels count over the
     * stretch that is fitted, the range over all of the recording.
     */
    private List<Scene.Schedule> schedules() {
        Model model = evidence.model();
        if (!evidence.onRig()) {
            return List.of();
        }
        Set<String> places = Stream.concat(evidence.outputs().stream(), model.excitations().stream()).map(Channel::location)
                .collect(Collectors.toSet());
        Set<Channel> used = fitted.drives().stream().map(Assembly.DriveAt::drive).filter(Drive.Given.class::isInstance)
                .map(drive -> ((Drive.Given) drive).channel())
                .collect(Collectors.toSet());
        return evidence.recording().channels().stream().filter(channel -> SETTING.contains(channel.quantity()) && !used.contains(channel)
                && (SETS_ONLY.contains(channel.quantity()) || channel.axis() != model.axis() && !places.contains(channel.location())))
                .flatMap(channel -> schedule(channel).stream()).toList();
    }

    private Optional<Scene.Schedule> schedule(Channel channel) {
        double[] values = evidence.series(channel);
        double low = Arrays.stream(values).min().orElse(0);
        double high = Arrays.stream(values).max().orElse(0);
        if (!(high > low)) {
            return Optional.empty();
        }
        Modulator.Level level = new Modulator.Level(channel, low, high);
        int[] counts = new int[FINER * PARTS];
        int end = evidence.fit().start() + evidence.fit().length();
        for (int i = evidence.fit().start(); i < end; i++) {
            counts[Math.min(counts.length - 1, (int) (counts.length * (values[i] - low) / (high - low)))]++;
        }
        int levels = 0;
        for (int part = 0; part < FINER * PARTS; part++) {
            if (counts[part] > A_WHILE / FINER * evidence.fit().length()) {
                levels++;
                part += FINER - 1;   // what is nearer is the same level
            }
        }
        return levels > 1 ? Optional.of(new Scene.Schedule(level, levels)) : Optional.empty();
    }

    private boolean standsOnBase(int body) {
        return new Place(Place.Kind.BODY, body).plain(fitted).kind() != Place.Kind.BODY;
    }

    private Scene.Link link(int index) {
        Structure s = fitted.structure();
        double[] displacement = motion.displacement(index);
        double[] velocity = motion.velocity(index);
        double r = Motion.rms(displacement, samples);
        double v = Motion.rms(velocity, samples);
        double own = s.stiffness()[index];
        double force = force(index, r, v);
        // What a link was given without is no scale; a link of neither holds nothing that could be another law.
        double ofPerson = own > 0 ? own : s.damping()[index] * v / r;
        double k = !evidence.onRig() ? ofPerson : r > 0 && v > 0 ? force / r : 0;
        double c = s.damping()[index] > 0 ? s.damping()[index] : Baseline.USUAL_LOSS * k * r / v;
        double[] pull = IntStream.range(0, displacement.length).mapToDouble(i -> k * displacement[i] + c * velocity[i]).toArray();
        Map<Law.Side, DoubleUnaryOperator> reached = new EnumMap<>(Law.Side.class);
        for (Law.Side side : Law.Side.values()) {
            reached.put(side, quantiles(Arrays.stream(displacement)
                    .map(x -> side == Law.Side.COMPRESSION ? -x : side == Law.Side.EXTENSION ? x : Math.abs(x)).toArray()));
        }
        return new Scene.Link(index, evidence.model().links().get(index).name(), own, s.damping()[index], k, c, r, v, force, reached,
                quantiles(pull));
    }

    private DoubleUnaryOperator quantiles(double[] x) {
        double[] sorted = Motion.sorted(x, samples);
        return share -> Motion.quantile(sorted, share);
    }

    /** What a link carries, root mean square: as measured where it is, as its spring and dashpot make it elsewhere [N]. */
    private double force(int link, double r, double v) {
        Optional<Channel> sensor = evidence.model().links().get(link).sensor();
        int output = sensor.map(evidence.outputs()::indexOf).orElse(-1);
        return output >= 0 ? Motion.rms(evidence.measured(output), evidence.fit().length())
                : Math.hypot(fitted.structure().stiffness()[link] * r, fitted.structure().damping()[link] * v);
    }
}
