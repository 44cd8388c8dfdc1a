package wbv.diagnosis;

import java.util.Arrays;
import java.util.List;
import wbv.body.Assembly;
import wbv.body.Law;
import wbv.body.Model;
import wbv.body.Structure;
import wbv.diagnosis.mechanism.Scene;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/**
 * A model as it fits some evidence without anything added, and how it moves.
 *
 * @param fitted the baseline as fitted @param lines frequencies at which the residual stands out [Hz]
 */
record FittedScene(Evidence evidence, Assembly fitted, Motion motion, double[] lines) implements Scene {

    /** With nothing that stands out. */
    static FittedScene plain(Evidence evidence, Assembly fitted, Motion motion) {
        return new FittedScene(evidence, fitted, motion, new double[0]);
    }

    @Override
    public Model model() {
        return evidence.model();
    }

    @Override
    public boolean onRig() {
        return evidence.onRig();
    }

    @Override
    public Structure structure() {
        return fitted.structure();
    }

    @Override
    public boolean standsOnBase(int body) {
        return new Place(Place.Kind.BODY, body).plain(fitted).kind() != Place.Kind.BODY;
    }

    @Override
    public List<Channel> outputs() {
        return evidence.outputs();
    }

    @Override
    public double[] measured(int output) {
        return evidence.measured(output);
    }

    @Override
    public boolean has(Channel channel) {
        return evidence.recording().has(channel);
    }

    @Override
    public List<Channel> companions(String location, Quantity quantity) {
        return evidence.companions(location, quantity);
    }

    @Override
    public double step() {
        return evidence.recording().clock().step();
    }

    @Override
    public double end() {
        return samples() * evidence.excitation().fineStep();
    }

    @Override
    public double spacing() {
        return evidence.fit().spacing();
    }

    /** Samples of the motion up to the end of what is fitted. */
    private int samples() {
        return (int) ((evidence.fit().start() + evidence.fit().length()) / evidence.recording().clock().rate() / evidence.excitation().fineStep());
    }

    @Override
    public Link link(int index) {
        return new FittedLink(index);
    }

    private final class FittedLink implements Link {

        private final int index;
        private final double deflection;
        private final double speed;
        private final double force;
        private final double stiffness;
        private final double damping;
        private final double[][] reached = new double[Law.Side.values().length][];
        private final double[] pull;

        FittedLink(int index) {
            this.index = index;
            double[] r = motion.displacement(index);
            double[] v = motion.velocity(index);
            this.deflection = Motion.rms(r, samples());
            this.speed = Motion.rms(v, samples());
            this.force = carried();
            double ownDamping = structure().damping()[index];
            // What a link was given without is no scale; a link of neither holds nothing that could be another law.
            double ofPerson = own() > 0 ? own() : ownDamping * speed / deflection;
            this.stiffness = onRig() ? deflection > 0 && speed > 0 ? force / deflection : 0 : ofPerson;
            this.damping = ownDamping > 0 ? ownDamping : Baseline.USUAL_LOSS * stiffness * deflection / speed;
            for (Law.Side side : Law.Side.values()) {
                reached[side.ordinal()] = Motion.sorted(Arrays.stream(r).map(x -> side == Law.Side.COMPRESSION ? -x
                        : side == Law.Side.EXTENSION ? x : Math.abs(x)).toArray(), samples());
            }
            double[] linear = new double[r.length];
            for (int i = 0; i < linear.length; i++) {
                linear[i] = stiffness * r[i] + damping * v[i];
            }
            this.pull = Motion.sorted(linear, samples());
        }

        private double carried() {
            Model.Link link = model().links().get(index);
            for (int o = 0; o < outputs().size(); o++) {
                if (link.sensor().isPresent() && link.sensor().get().equals(outputs().get(o))) {
                    return Motion.rms(measured(o), evidence.fit().length());
                }
            }
            return Math.hypot(own() * deflection, structure().damping()[index] * speed);
        }

        @Override
        public int index() {
            return index;
        }

        @Override
        public String name() {
            return model().links().get(index).name();
        }

        @Override
        public double own() {
            return structure().stiffness()[index];
        }

        @Override
        public double stiffness() {
            return stiffness;
        }

        @Override
        public double damping() {
            return damping;
        }

        @Override
        public double deflection() {
            return deflection;
        }

        @Override
        public double speed() {
            return speed;
        }

        @Override
        public double force() {
            return force;
        }

        @Override
        public double reached(Law.Side side, double share) {
            return Motion.quantile(reached[side.ordinal()], share);
        }

        @Override
        public double pull(double share) {
            return Motion.quantile(pull, share);
        }
    }
}
