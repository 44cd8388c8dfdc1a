package wbv.diagnosis;

import static wbv.diagnosis.Bank.factor;
import static wbv.diagnosis.Bank.fixed;
import static wbv.diagnosis.Bank.grid;
import static wbv.diagnosis.Bank.scaled;
import static wbv.diagnosis.Bank.start;
import static wbv.diagnosis.Bank.sum;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import wbv.body.Assembly;
import wbv.body.AsymmetricSpring;
import wbv.body.Backlash;
import wbv.body.BoucWen;
import wbv.body.BristleFriction;
import wbv.body.BumpStop;
import wbv.body.CoulombFriction;
import wbv.body.CubicSpring;
import wbv.body.EngagingFriction;
import wbv.body.Law;
import wbv.body.MaxwellArm;
import wbv.body.Model;
import wbv.body.PolynomialSpring;
import wbv.body.QuadraticDamping;
import wbv.body.QuadraticSpring;
import wbv.body.SaturatingSpring;
import wbv.body.SensorFault;
import wbv.body.Structure;
import wbv.diagnosis.Hypothesis.Addition;
import wbv.diagnosis.Hypothesis.Number;
import wbv.diagnosis.Hypothesis.Start;

/**
 * The library for test rigs, dampers and laboratory oscillators: as {@link Bank}, with every bound in terms of the motion and
 * the forces of the recording, since a damper of 20 kN and an electronic oscillator of 50 mV have no newton in common.
 */
final class RigBank {

    private final Evidence evidence;
    private final Structure structure;
    private final Motion motion;
    private final int fitEnd;
    private final List<Hypothesis> all = new ArrayList<>();

    /** @param fitted the baseline as fitted */
    RigBank(Evidence evidence, Assembly fitted, Motion motion) {
        this.evidence = evidence;
        this.structure = fitted.structure();
        this.motion = motion;
        double rate = evidence.recording().clock().rate();
        this.fitEnd = (int) ((evidence.fit().start() + evidence.fit().length()) / rate / evidence.excitation().fineStep());
        for (int l = 0; l < evidence.model().links().size(); l++) {
            double r = Motion.rms(motion.displacement(l), fitEnd);
            double v = Motion.rms(motion.velocity(l), fitEnd);
            if (r > 0 && v > 0) {
                springs(l, r, force(l, r, v) / r);
                dissipation(l, r, v, force(l, r, v));
                contacts(l, r, force(l, r, v) / r);
            }
        }
        for (int b = 0; b < evidence.model().bodies().size() && !evidence.model().driven(); b++) {
            hidden(b);
        }
        for (int o = 0; o < evidence.outputs().size(); o++) {
            sensor(o);
        }
    }

    List<Hypothesis> hypotheses() {
        return all;
    }

    /** What the link carries, root mean square: as measured where it is, as its spring and dashpot make it elsewhere [N]. */
    private double force(int l, double r, double v) {
        Model.Link link = evidence.model().links().get(l);
        for (int o = 0; o < evidence.outputs().size(); o++) {
            if (link.sensor().isPresent() && link.sensor().get().equals(evidence.outputs().get(o))) {
                return Motion.rms(evidence.measured(o), evidence.fit().length());
            }
        }
        return Math.hypot(structure.stiffness()[l] * r, structure.damping()[l] * v);
    }

    /** @param r displacement, root mean square [m] @param k stiffness that would carry all of the force [N/m] */
    private void springs(int l, double r, double k) {
        double even = 0.1 * k / r;
        double odd = 0.1 * k / (r * r);
        if (structure.stiffness()[l] > 0) {
            law(l, "", new SaturatingSpring(r), List.of(factor(0.02 * r, 50 * r)),
                    grid(new double[] {0.5, 1.5, 4}, q -> fixed(q * r)));
            law(l, "", new AsymmetricSpring(0.1), List.of(sum(0.1, -0.97, 12)), List.of(scaled(0.1)));
        }
        law(l, "", new CubicSpring(odd), List.of(sum(odd, 0, 1000 * odd)), List.of(scaled(odd)));
        law(l, "", new QuadraticSpring(even), List.of(sum(even, -1000 * even, 1000 * even)), List.of(scaled(even)));
        law(l, "polynomial", new PolynomialSpring(even, odd),
                List.of(sum(even, -1000 * even, 1000 * even), sum(odd, 0, 1000 * odd)),
                List.of(start(new double[] {even, odd}, new int[] {0}, new int[] {1})));
    }

    private void dissipation(int l, double r, double v, double f) {
        law(l, "", new QuadraticDamping(0.1 * f / (v * v)), List.of(sum(0.1 * f / (v * v), 0, 100 * f / (v * v))),
                List.of(scaled(0.1 * f / (v * v))));
        law(l, "", new CoulombFriction(f, v), List.of(sum(0.3 * f, 0, 10 * f), factor(1e-3 * v, 3 * v)),
                grid(new double[] {0.02, 0.15, 0.6}, q -> start(new double[] {f, q * v}, new int[] {0})));
        law(l, "bristles", new BristleFriction(f, 1.1 * f, 0.3 * v, 10 * f / r),
                List.of(factor(1e-3 * f, 10 * f), factor(1e-3 * f, 20 * f),
                factor(1e-2 * v, 30 * v), factor(0.1 * f / r, 1000 * f / r)),
                        grid(new double[] {2, 10, 50}, q -> fixed(f, 1.1 * f, 0.3 * v, q * f / r)));
        double k = structure.stiffness()[l];
        if (k > 0) {
            law(l, "", new BoucWen(0.1, r), List.of(sum(0.1, 0, 1), factor(1e-3 * r, 30 * r)),
                    grid(new double[] {0.1, 0.5, 2}, q -> start(new double[] {0.1, q * r}, new int[] {0})));
            law(l, "", new MaxwellArm(0.1 * k, r / v), List.of(factor(1e-3 * k, 100 * k), factor(1e-2 * r / v, 100 * r / v)),
                    grid(new double[] {0.3, 1, 5}, q -> start(new double[] {0.1 * k, q * r / v}, new int[] {0})));
        }
    }

    private void contacts(int l, double r, double k) {
        double own = structure.stiffness()[l];
        for (Law.Side side : Law.Side.values()) {
            double[] towards = Motion.sorted(Arrays.stream(motion.displacement(l))
                    .map(x -> side == Law.Side.COMPRESSION ? -x : side == Law.Side.EXTENSION ? x : Math.abs(x)).toArray(), fitEnd);
            law(l, side.name().toLowerCase(Locale.ROOT), new BumpStop(k, r, side),
                    List.of(sum(k, 1e-6 * k, 1000 * k), factor(1e-3 * r, 20 * r)),
                    grid(new double[] {0.6, 0.85, 0.97},
                            q -> start(new double[] {k, Math.max(2e-3 * r, Motion.quantile(towards, q))},
                            new int[] {0})));
        }
        if (own > 0) {
            law(l, "", new Backlash(r), List.of(factor(1e-3 * r, 10 * r)),
                    grid(new double[] {0.05, 0.2, 0.6}, q -> fixed(q * r)));
        }
        if (evidence.model().driven()) {
            double f = k * r;
            List<Start> starts = new ArrayList<>();
            for (double travel : new double[] {0.15, 0.5, 1.5}) {
                for (double growth : new double[] {1, 3}) {
                    starts.add(start(new double[] {f, f, travel * r, growth}, new int[] {0}, new int[] {1}));
                }
            }
            law(l, "friction", new EngagingFriction(f, f, r, 1), List.of(sum(f, 0, 10 * f), sum(f, 0, 10 * f),
                    factor(1e-3 * r, 10 * r), factor(1e-3, 30)), starts);
        }
    }

    private void hidden(int b) {
        double mass = Arrays.stream(structure.mass()).sum();
        double stiffness = Arrays.stream(structure.stiffness()).max().orElse(0);
        if (!(stiffness > 0)) {
            return;
        }
        double natural = Math.sqrt(stiffness / mass) / (2 * Math.PI);
        List<Start> starts = new ArrayList<>();
        for (double ratio : new double[] {0.5, 1, 2}) {
            Model.HiddenMode mode = new Model.HiddenMode(0.02 * mass, ratio * natural, 0.1);
            starts.add(start(new double[] {mode.mass(), mode.stiffness(), mode.damping()}, new int[] {0, 1, 2}));
        }
        double damping = starts.get(1).values()[2];
        all.add(new Hypothesis("mode.hidden", evidence.model().bodies().get(b).name(), "",
                List.of(new Addition.Hidden(b, new Model.HiddenMode(0.02 * mass, natural, 0.1))),
                List.of(new Number("mass_kg", 0, 1e-4 * mass, 3 * mass),
                        new Number("stiffness_N_per_m", 0, 1e-6 * stiffness, 30 * stiffness),
                        new Number("damping_Ns_per_m", 0, 1e-4 * damping, 1e4 * damping)), starts));
    }

    private void sensor(int o) {
        double[] y = evidence.measured(o);
        double top = Arrays.stream(y).max().orElse(1);
        double bottom = Arrays.stream(y).min().orElse(-1);
        double step = evidence.recording().clock().step();
        at(o, new SensorFault.Delay(step, 0), List.of(sum(0.3 * step, -50 * step, 50 * step), sum(1e-5, -1e-9, 1e-9)),
                List.of(start(new double[] {step, 0}, new int[] {0})));
        if (top > 0 && bottom > -0.1 * top) {   // only a signal that never turns negative can have lost its sign
            at(o, new SensorFault.Rectifying(), List.of(), List.of(fixed()));
        }
        if (top > 0 && bottom < 0) {
            List<Start> levels = new ArrayList<>(grid(new double[] {0.98, 0.9, 0.8}, q -> fixed(q * bottom, q * top)));
            at(o, new SensorFault.Clipping(bottom, top),
                    List.of(factor(0.01 * bottom, 40 * bottom), factor(0.01 * top, 40 * top)), levels);
        }
    }

    private void law(int link, String form, Law law, List<Number> bounds, List<Start> starts) {
        all.add(new Hypothesis(law.mechanism(), evidence.model().links().get(link).name(), form,
                List.of(new Addition.InLink(link, law)),
                Bank.named(law.getClass(), bounds), starts));
    }

    private void at(int output, SensorFault fault, List<Number> bounds, List<Start> starts) {
        all.add(new Hypothesis(fault.mechanism(), evidence.outputs().get(output).toString(), "",
                List.of(new Addition.AtSensor(output, fault)),
                Bank.named(fault.getClass(), bounds), starts));
    }
}
