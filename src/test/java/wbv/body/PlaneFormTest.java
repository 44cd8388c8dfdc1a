package wbv.body;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.learn.LearnedWords;
import wbv.recording.Channel;
import wbv.recording.DataFault;

/** A trunk that swings on two springs and a head on a neck, in the plane, against equations of motion written out for it alone. */
class PlaneFormTest {

    private static final double RATE = 200;
    private static final int SAMPLES = 2000;
    private static final int PARTS = 40;

    static final String MODEL = """
            {"name": "in a plane", "subject": "rig", "plane": "xz", "axis": "z",
             "base": {"name": "floor", "at_m": [0.1, 0], "sensors": ["floor.acc.z", "floor.acc.x", "floor.gyr.y"]},
             "bodies": [
              {"name": "trunk", "at_m": [0.05, 0.3], "mass_kg": 45, "inertia_kgm2": 2.5,
               "sensors": [{"sensor": "trunk.acc.z"}, {"sensor": "sternum.acc.x", "at_m": [0.15, 0.5]}, {"sensor": "trunk.gyr.y"}]},
              {"name": "head", "at_m": [0.12, 0.75], "mass_kg": 5, "inertia_kgm2": 0.03, "sensors": [{"sensor": "head.acc.z"}]}],
             "links": [
              {"from": "floor", "to": "trunk", "along": "z", "at_m": [0.3, 0], "stiffness_N_per_m": 30000, "damping_Ns_per_m": 500%s},
              {"from": "floor", "to": "trunk", "along": "x", "at_m": [-0.1, 0.35], "stiffness_N_per_m": 20000, "damping_Ns_per_m": 400},
              {"from": "floor", "to": "trunk", "about": "y", "stiffness_Nm_per_rad": 2500, "damping_Nms_per_rad": 60},
              {"from": "trunk", "to": "head", "along": "z", "at_m": [0.1, 0.62], "stiffness_N_per_m": 40000, "damping_Ns_per_m": 150},
              {"from": "trunk", "to": "head", "along": "x", "at_m": [0.1, 0.62], "stiffness_N_per_m": 30000, "damping_Ns_per_m": 120},
              {"from": "trunk", "to": "head", "about": "y", "stiffness_Nm_per_rad": 90, "damping_Nms_per_rad": 1.5}]}
            """;
    /** So small that what goes beyond small motions is nothing: the equations of {@link #rates} are those of small ones. */
    private static final double SMALL = 0.001;
    private static final double CUBIC = 4e7 / (SMALL * SMALL);
    private static final String HARDENING = ", \"laws\": [{\"law\": \"stiffness.hardening\", \"k3_N_per_m3\": " + CUBIC + "}]";

    @Tag("slow")
    @Test
    void movesAsTheEquationsOfThePlaneSay() {
        for (double cubic : new double[] {0, CUBIC}) {
            Model model = ModelFile.parse(String.format(MODEL, cubic > 0 ? HARDENING : ""), "plane.json");
            double[][] outputs = new Simulator(excitation(SMALL)).outputs(model.assembly());
            double[][] expected = byRungeKutta(cubic);
            List<String> channels = model.outputs().stream().map(Channel::toString).toList();
            assertEquals(List.of("trunk.acc.z", "trunk.gyr.y", "head.acc.z", "sternum.acc.x"), channels);
            for (int o = 0; o < outputs.length; o++) {
                double off = 0;
                double size = 0;
                for (int i = 0; i < SAMPLES; i++) {
                    off += Math.pow(outputs[o][i] - expected[o][i], 2);
                    size += Math.pow(expected[o][i], 2);
                }
                assertEquals(0, Math.sqrt(off / size), 2e-3, channels.get(o) + " with " + cubic);
            }
        }
    }

    @Test
    void hasTheDerivativesOfItsOwnDifferences() {
        for (String law : List.of("", HARDENING.replace(String.valueOf(CUBIC), "4e7"))) {
            Assembly assembly = ofSmallMotions(ModelFile.parse(String.format(MODEL, law), "plane.json").assembly());
            Simulator simulator = new Simulator(excitation(1));
            Simulator.Response response = simulator.run(assembly, true);
            double[] values = assembly.values();
            Structure structure = assembly.structure();
            for (int p = 0; p < values.length; p++) {
                double kept = values[p];
                double h = 1e-5 * kept;
                values[p] = kept + h;
                double[][] high = simulator.run(assembly.with(values), false).outputs();
                values[p] = kept - h;
                double[][] low = simulator.run(assembly.with(values), false).outputs();
                values[p] = kept;
                for (int o = 0; o < high.length; o++) {
                    double off = 0;
                    double size = 0;
                    for (int k = 0; k < high[o].length; k++) {
                        double slope = (high[o][k] - low[o][k]) / (2 * h);
                        off += Math.pow(slope - response.slopes()[p][o][k], 2);
                        size += slope * slope;
                    }
                    assertTrue(Math.sqrt(off) <= 1e-4 * Math.sqrt(size) + 1e-15,
                            "parameter " + p + " of " + structure.parameters() + ", output " + o + ": " + off + " of " + size);
                }
            }
        }
    }

    /** Derivatives are those of small motions. */
    private static Assembly ofSmallMotions(Assembly assembly) {
        Structure s = assembly.structure();
        Kinematics k = s.kinematics();
        return new Assembly(new Structure(s.from(), s.to(), s.stiffness(), s.damping(), s.mass(), s.held(),
                new Kinematics(k.stretch(), k.carried(), k.massOf(), Optional.empty())), assembly.laws(), assembly.drives(),
                assembly.outputs().stream()
                        .map(output -> new Assembly.Output(output.place(), output.reading(), output.faults(), output.reads())).toList());
    }

    @Test
    void weighsABodyOnce() {
        Model model = ModelFile.parse(String.format(MODEL, ""), "plane.json");
        assertEquals(50, model.mass(), 1e-12);
        Structure structure = model.assembly().structure();
        double[] values = structure.values();
        values[2 * structure.links()] = 60;
        assertEquals(60, structure.with(values).mass()[0], 0);
        assertEquals(60, structure.with(values).mass()[1], 0);
        assertEquals(2.5, structure.with(values).mass()[2], 0);
    }

    @Test
    void readsBackWhatItWrites() {
        Model model = ModelFile.parse(String.format(MODEL, HARDENING), "plane.json");
        assertEquals(model, ModelFile.parse(ModelFile.text(model), "again.json"));
    }

    @Test
    void readsTheModelOfTheReference() throws IOException {
        String page = Files.readString(Path.of("docs/reference/model.md"));
        int begin = page.indexOf("```json\n{\"name\": \"sitter on a shaker\"") + 8;
        Model model = ModelFile.parse(page.substring(begin, page.indexOf("```", begin)), "model.md");
        assertEquals("trunk.pitch-head.pitch", model.links().get(5).name());
        assertEquals(57.2, model.mass(), 1e-12);
    }

    @Test
    void namesUnitsAboutAnAxis() {
        assertEquals(
                List.of("k3_Nm_per_rad3", "c2_Nms2_per_rad2", "friction_Nm", "transition_rad_per_s", "gap_rad", "stop_Nm_per_rad1_5",
                        "relaxation_s"),
                List.of("k3_N_per_m3", "c2_Ns2_per_m2", "friction_N", "transition_m_per_s", "gap_m", "stop_N_per_m1_5", "relaxation_s")
                        .stream()
                        .map(ModelFile::keyAbout).toList());
        assertEquals("coefficient_[N·m/(rad/s)] of v thinned", ModelFile.keyAbout("coefficient_[N/(m/s)] of v thinned"));
        assertEquals("coefficient_[N·m/(rad·N)] of r × load of link 2", ModelFile.keyAbout("coefficient_[N/(m·N)] of r × load of link 2"));
    }

    @Test
    void aLearnedLawAboutAnAxisIsWrittenInRadians() {
        Model model = ModelFile
                .parse(String.format(MODEL, "").replace("\"damping_Nms_per_rad\": 1.5", "\"damping_Nms_per_rad\": 1.5, \"laws\": ["
                        + "{\"law\": \"learned\", \"coefficient_N\": -16, \"thinning\": 1.5, \"speed_m_per_s\": 0.794}]"), "model.json");
        assertEquals("F = −16 N·m/(rad/s) · v / (1 + |v / 794 mrad/s|^1.5)",
                new LearnedWords(model, "trunk.pitch-head.pitch").formula());
    }

    @Test
    void saysWhatIsWrong() {
        fault(MODEL.replace("\"along\": \"x\", \"at_m\": [0.1, 0.62]", "\"along\": \"y\", \"at_m\": [0.1, 0.62]"),
                "'along' must be \"x\" or \"z\": 'y'");
        fault(MODEL.replace("\"at_m\": [0.12, 0.75]", "\"at_m\": [0.12]"), "'at_m' must be two numbers [x, z] in m");
        fault(MODEL.replace("head.acc.z", "head.acc.y"), "a sensor reads along x or z, or an angle about y: head.acc.y");
        fault(MODEL.replace(", \"inertia_kgm2\": 0.03", ""), "'head' has no inertia_kgm2 and so does not turn");
        fault(MODEL.replace("\"plane\": \"xz\"", "\"plane\": \"yz\""), "'plane' must be \"xz\"");
        fault(MODEL.replace("\"floor.gyr.y\"", "\"floor.gyr.y\", \"floor.ang.y\""), "'sensors' holds two of one motion");
        fault(MODEL.replace("\"from\": \"trunk\"", "\"from\": \"chest\""), "it joins 'chest', which is no body");
    }

    /** What counts at a millimetre is more the higher the power: 1e17 N/m³ times its cube is 1e8 N. */
    @Test
    void readsWhatALinkMayHave() {
        String law = ", \"laws\": [{\"law\": \"stiffness.hardening\", \"k3_N_per_m3\": %s}]";
        Model model = ModelFile.parse(String.format(MODEL, String.format(law, "1e17")), "plane.json");
        assertEquals(List.of("[CubicSpring[cubic=1.0E17]]"),
                model.links().stream().filter(link -> !link.laws().isEmpty()).map(link -> link.laws().toString()).toList());
        fault(String.format(MODEL, String.format(law, "2e21")),
                "'k3_N_per_m3' is 2.0E21, which no body or link has; at most 1.0E21 is read");
        fault(MODEL.replace("\"stiffness_N_per_m\": 30000", "\"stiffness_N_per_m\": 2e15"),
                "'stiffness_N_per_m' is 2.0E15, which no body or link has; at most 1.0E15 is read");
    }

    private static void fault(String text, String says) {
        DataFault fault = assertThrows(DataFault.class, () -> ModelFile.parse(String.format(text, ""), "plane.json"));
        assertTrue(fault.getMessage().contains(says), fault.getMessage());
    }

    // What the base does: accelerations along z and x, and an angle's, each a few sines that come and go smoothly.

    private static double base(int axis, double t, int derivative) {
        double sum = 0;
        for (int i = 0; i < 4; i++) {
            double f = 1.1 + 2.3 * i + 0.7 * axis;
            double w = 2 * Math.PI * f;
            double size = SMALL * new double[] {1.5, 1, 2}[axis] / (w * w);
            double u = Math.PI * t * RATE / SAMPLES;
            double ramp = Math.PI * RATE / SAMPLES;
            // sin⁴(u) sin(w t + i)
            double s = Math.sin(u);
            double c = Math.cos(u);
            double p = Math.pow(s, 4);
            double p1 = 4 * s * s * s * c * ramp;
            double p2 = (12 * s * s * c * c - 4 * Math.pow(s, 4)) * ramp * ramp;
            double q = Math.sin(w * t + i);
            double q1 = w * Math.cos(w * t + i);
            double q2 = -w * w * q;
            sum += size * (derivative == 0 ? p * q : derivative == 1 ? p1 * q + p * q1 : p2 * q + 2 * p1 * q1 + p * q2);
        }
        return sum;
    }

    private static Excitation excitation(double size) {
        double[][] base = new double[3][SAMPLES];
        for (int i = 0; i < SAMPLES; i++) {
            for (int axis = 0; axis < 3; axis++) {
                base[axis][i] = size / SMALL * base(axis, i / RATE, 2);
            }
        }
        Map<Channel, double[]> others = new HashMap<>();
        return new Excitation(RATE, base, others);
    }

    /** Positions against the ground of trunk x, z, angle, head x, z, angle, then their speeds. */
    private static double[] rates(double[] y, double t, double cubic) {
        double[] force = new double[6];
        spring(y, t, force, -1, 0, 'z', 0.3, 0, 30000, 500, cubic);
        spring(y, t, force, -1, 0, 'x', -0.1, 0.35, 20000, 400, 0);
        spring(y, t, force, -1, 0, 'r', 0, 0, 2500, 60, 0);
        spring(y, t, force, 0, 1, 'z', 0.1, 0.62, 40000, 150, 0);
        spring(y, t, force, 0, 1, 'x', 0.1, 0.62, 30000, 120, 0);
        spring(y, t, force, 0, 1, 'r', 0, 0, 90, 1.5, 0);
        double[] mass = {45, 45, 2.5, 5, 5, 0.03};
        double[] out = new double[12];
        for (int i = 0; i < 6; i++) {
            out[i] = y[6 + i];
            out[6 + i] = force[i] / mass[i];
        }
        return out;
    }

    private static final double[][] CENTRES = {{0.05, 0.3}, {0.12, 0.75}};

    private static double point(double[] y, double t, int body, char along, double px, double pz, int derivative) {
        if (body < 0) {
            double angle = base(2, t, derivative);
            return along == 'r' ? angle : along == 'x' ? base(1, t, derivative) + pz * angle : base(0, t, derivative) - (px - 0.1) * angle;
        }
        int at = 6 * derivative + 3 * body;
        return along == 'r' ? y[at + 2]
                : along == 'x' ? y[at] + (pz - CENTRES[body][1]) * y[at + 2] : y[at + 1] - (px - CENTRES[body][0]) * y[at + 2];
    }

    private static void spring(double[] y, double t, double[] force, int from, int to, char along, double px, double pz, double k, double c,
            double cubic) {
        double r = point(y, t, to, along, px, pz, 0) - point(y, t, from, along, px, pz, 0);
        double v = point(y, t, to, along, px, pz, 1) - point(y, t, from, along, px, pz, 1);
        double pull = k * r + c * v + cubic * r * r * r;
        push(force, to, along, px, pz, -pull);
        push(force, from, along, px, pz, pull);
    }

    private static void push(double[] force, int body, char along, double px, double pz, double size) {
        if (body >= 0) {
            force[3 * body + (along == 'x' ? 0 : along == 'z' ? 1 : 2)] += size;
            force[3 * body + 2] += along == 'x' ? size * (pz - CENTRES[body][1]) : along == 'z' ? -size * (px - CENTRES[body][0]) : 0;
        }
    }

    private static double[][] byRungeKutta(double cubic) {
        double[][] out = new double[4][SAMPLES];
        double[] y = new double[12];
        double h = 1 / RATE / PARTS;
        for (int i = 0; i < SAMPLES; i++) {
            double t = i / RATE;
            double[] a = rates(y, t, cubic);
            out[0][i] = a[7];
            out[1][i] = y[8];
            out[2][i] = a[10];
            out[3][i] = a[6] + (0.5 - 0.3) * a[8];
            for (int part = 0; part < PARTS; part++) {
                double at = t + part * h;
                List<double[]> slopes = new ArrayList<>(List.of(rates(y, at, cubic)));
                for (double share : new double[] {0.5, 0.5, 1}) {
                    slopes.add(rates(moved(y, slopes.get(slopes.size() - 1), share * h), at + share * h, cubic));
                }
                for (int s = 0; s < 12; s++) {
                    y[s] += h / 6 * (slopes.get(0)[s] + 2 * slopes.get(1)[s] + 2 * slopes.get(2)[s] + slopes.get(3)[s]);
                }
            }
        }
        return out;
    }

    private static double[] moved(double[] y, double[] by, double step) {
        double[] out = y.clone();
        for (int i = 0; i < out.length; i++) {
            out[i] += step * by[i];
        }
        return out;
    }
}
