package wbv.diagnosis;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Law;
import wbv.body.Model;
import wbv.body.Structure;
import wbv.diagnosis.mechanism.Scene;
import wbv.recording.Channel;

/** What mechanisms take their measure from, as some evidence shows it. */
final class FittedScene {

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

    /** @param fitted the baseline as fitted @param motion of it @param lines frequencies at which the residual stands out [Hz] */
    static Scene of(Evidence evidence, Assembly fitted, Motion motion, double... lines) {
        FittedScene scene = new FittedScene(evidence, fitted, motion);
        Model model = evidence.model();
        return new Scene(model, evidence.onRig(), fitted.structure(), IntStream.range(0, model.links().size()).mapToObj(scene::link).toList(),
                IntStream.range(0, model.bodies().size()).filter(scene::standsOnBase).boxed().collect(Collectors.toSet()),
                evidence::across, evidence::companions, IntStream.range(0, evidence.outputs().size()).mapToObj(evidence::measured).toList(), lines,
                evidence.fit().spacing(), evidence.recording().clock().step(), scene.samples * evidence.excitation().fineStep());
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
        return new Scene.Link(index, evidence.model().links().get(index).name(), own, k, c, r, v, force, reached, quantiles(pull));
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
