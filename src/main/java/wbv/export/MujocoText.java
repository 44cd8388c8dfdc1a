package wbv.export;

import java.util.List;
import wbv.body.Assembly;
import wbv.body.LawAt;
import wbv.body.Model;
import wbv.body.Structure;
import wbv.body.law.Backlash;
import wbv.body.law.LearnedInertance;
import wbv.recording.DataFault;

/**
 * A model for MuJoCo, seen from its base: each body slides along the model's axis, each link is a tendon of the difference of two slides.
 *
 * <p>Of the laws, MuJoCo has play (a tendon's spring has a range in which it is slack) and inertance (a tendon's armature); all others act
 * as generalized forces.
 */
final class MujocoText {

    /** [s]; whoever runs it takes a step that divides that of the input. */
    private static final double STEP = 5e-4;

    private final Model model;
    private final Assembly assembly;
    private final Names names;

    MujocoText(Model model) {
        this.model = model;
        this.assembly = model.assembly();
        this.names = Names.of(model);
        if (assembly.structure().held()) {
            throw new DataFault("'" + model.name()
                    + "' has driven links only: there is no body that MuJoCo could move; --to python, fmu and modelica can");
        }
        for (LawAt at : foreign()) {
            if (at.law() instanceof LearnedInertance inertance) {
                throw new DataFault("MuJoCo takes the inertance of " + inertance.inertance() + " kg in the link "
                        + names.links().get(at.link())
                        + " only between the base and a body, not negative, and where nobody reads the link's force; --to python, fmu "
                        + "and modelica can");
            }
        }
    }

    /** The laws that MuJoCo has not. */
    List<LawAt> foreign() {
        return assembly.laws().stream().filter(at -> !own(at)).toList();
    }

    /** Whether MuJoCo has the law; where the force of its link is read, in Python, it stands there too. */
    private boolean own(LawAt at) {
        boolean read = assembly.outputs().stream()
                .anyMatch(output -> output.reading() == Assembly.Reading.LINK_FORCE && output.place() == at.link())
                || assembly.laws().stream()
                        .anyMatch(other -> other.law().modulator().otherLink().filter(of -> of.link() == at.link()).isPresent());
        long play = assembly.laws().stream().filter(other -> other.link() == at.link() && other.law() instanceof Backlash).count();
        return !read && (at.law() instanceof Backlash && play == 1
                || at.law() instanceof LearnedInertance inertance && inertance.inertance() >= 0
                        && assembly.structure().from()[at.link()] < 0);   // a tendon's armature does not couple bodies side by side
    }

    String xml() {
        Structure structure = assembly.structure();
        StringBuilder out = new StringBuilder("<mujoco model=\"" + text(model.name()) + "\">\n");
        out.append("  <!-- Displacements against the base '").append(text(model.base().name()))
                .append("', whose acceleration is gravity turned round. -->\n");
        out.append("  <option timestep=\"").append(STEP).append("\" gravity=\"0 0 0\" integrator=\"RK4\"/>\n  <worldbody>\n");
        String axis = switch (model.axis()) {
            case 'x' -> "1 0 0";
            case 'y' -> "0 1 0";
            default -> "0 0 1";
        };
        for (int b = 0; b < structure.bodies(); b++) {
            String name = text(names.bodies().get(b));
            out.append("    <body name=\"").append(name).append("\">\n      <joint name=\"").append(name)
                    .append("\" type=\"slide\" axis=\"").append(axis)
                    .append("\"/>\n      <inertial pos=\"0 0 0\" mass=\"").append(structure.mass()[b])
                    .append("\" diaginertia=\"1 1 1\"/>\n      <site name=\"")
                    .append(name).append("\"/>\n    </body>\n");
        }
        out.append("  </worldbody>\n  <tendon>\n");
        for (int l = 0; l < structure.links(); l++) {
            link(l, structure, out);
        }
        out.append("  </tendon>\n  <sensor>\n");
        for (int o = 0; o < assembly.outputs().size(); o++) {
            Assembly.Output output = assembly.outputs().get(o);
            String name = "name=\"" + model.outputs().get(o) + "\"";
            switch (output.reading()) {
                case ACCELERATION -> out.append("    <accelerometer ").append(name).append(" site=\"")
                        .append(text(names.bodies().get(output.place()))).append("\"/>\n");
                case VELOCITY -> out.append("    <jointvel ").append(name).append(" joint=\"")
                        .append(text(names.bodies().get(output.place()))).append("\"/>\n");
                case POSITION -> out.append("    <jointpos ").append(name).append(" joint=\"")
                        .append(text(names.bodies().get(output.place()))).append("\"/>\n");
                case LINK_FORCE -> out.append("    <!-- ").append(model.outputs().get(o)).append(": see the Python file -->\n");
                default -> throw new IllegalStateException("no reading " + output.reading());
            }
        }
        return out.append("  </sensor>\n</mujoco>\n").toString();
    }

    private void link(int l, Structure structure, StringBuilder out) {
        double gap = 0;
        double armature = 0;
        for (LawAt at : assembly.laws()) {
            if (at.link() == l && own(at)) {
                gap += at.law() instanceof Backlash play ? play.gap() : 0;
                armature += at.law() instanceof LearnedInertance inertance ? inertance.inertance() : 0;
            }
        }
        out.append("    <fixed name=\"").append(text(names.links().get(l))).append(' ').append(l).append("\" stiffness=\"")
                .append(structure.stiffness()[l])
                .append("\" damping=\"").append(structure.damping()[l]).append("\" springlength=\"").append(-gap).append(' ').append(gap)
                .append('"');
        out.append(armature > 0 ? " armature=\"" + armature + "\"" : "").append(">\n");
        end(structure.to()[l], 1, out);
        if (structure.from()[l] >= 0) {
            end(structure.from()[l], -1, out);
        }
        out.append("    </fixed>\n");
    }

    private void end(int body, int coefficient, StringBuilder out) {
        out.append("      <joint joint=\"").append(text(names.bodies().get(body))).append("\" coef=\"").append(coefficient)
                .append("\"/>\n");
    }

    private static String text(String name) {
        return Names.plain(name).replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }
}
