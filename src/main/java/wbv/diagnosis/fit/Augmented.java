package wbv.diagnosis.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.LawAt;
import wbv.body.Model;
import wbv.body.Structure;
import wbv.body.number.Numbers;

/** The user's model with the values and additions of an assembly, in the format in which it came. */
public final class Augmented {

    private Augmented() {}

    /**
     * The model completed.
     *
     * @param assembly of the same model: what was added stands behind the model's own links and bodies
     */
    public static Model of(Model model, Assembly assembly) {
        Structure s = assembly.structure();
        List<Model.Link> links = new ArrayList<>();
        for (int l = 0; l < model.links().size(); l++) {
            Model.Link link = model.links().get(l);
            int place = l;
            links.add(link.completed(s.stiffness()[l], s.damping()[l],
                    assembly.laws().stream().filter(at -> at.link() == place).map(LawAt::law).toList(), drives(assembly, place, false),
                    List.of()));
        }
        List<Model.Body> bodies = new ArrayList<>();
        int output = 0;
        for (int b = 0; b < model.bodies().size(); b++) {
            Model.Body body = model.bodies().get(b);
            bodies.add(body.completed(s.mass()[b], body.sensor().isPresent() ? assembly.outputs().get(output++).faults() : List.of(),
                    hidden(model, assembly, b), drives(assembly, b, true)));
        }
        for (int l = 0; l < links.size(); l++) {
            Model.Link link = links.get(l);
            if (link.sensor().isPresent()) {
                links.set(l, link.completed(link.stiffness(), link.damping(), link.laws(), link.drives(),
                        assembly.outputs().get(output++).faults()));
            }
        }
        List<Model.Sensor> sensors = new ArrayList<>();
        for (Model.Sensor sensor : model.sensors()) {
            sensors.add(new Model.Sensor(sensor.channel(), sensor.reads(), assembly.outputs().get(output++).faults(), sensor.at()));
        }
        return new Model(model.name(),
                Optional.of(model.source().map(source -> source + "; ").orElse("") + "fitted and completed by wbv"),
                model.axis(), model.base(), bodies, links,
                inputs(assembly, bodies), model.declared(), sensors);
    }

    private static List<Model.Input> inputs(Assembly assembly, List<Model.Body> bodies) {
        List<Model.Input> inputs = new ArrayList<>();
        for (Assembly.DriveAt at : assembly.drives()) {
            if (at.drive() instanceof Drive.Measured force) {
                inputs.add(new Model.Input(bodies.get(at.place()).name(), force.channel(), force.offset()));
            }
        }
        return inputs;
    }

    private static List<Drive> drives(Assembly assembly, int place, boolean onBody) {
        return assembly.drives().stream().filter(at -> at.place() == place && at.drive().actsOnBody() == onBody
                && !(at.drive() instanceof Drive.Measured))
                .map(Assembly.DriveAt::drive).toList();
    }

    /** Bodies behind the model's own ride on the lower end of their link. */
    private static Optional<Model.HiddenMode> hidden(Model model, Assembly assembly, int body) {
        Structure s = assembly.structure();
        for (int l = model.links().size(); l < s.links(); l++) {
            if (s.from()[l] == body) {
                double mass = s.mass()[s.to()[l]];
                double omega = Math.sqrt(s.stiffness()[l] / mass);
                int link = l;
                double cubic = assembly.laws().stream().filter(at -> at.link() == link)
                        .mapToDouble(at -> Numbers.values((Record) at.law())[0]).sum();
                return Optional.of(new Model.HiddenMode(mass, omega / (2 * Math.PI), s.damping()[l] / (2 * mass * omega),
                        cubic / s.stiffness()[l]));
            }
        }
        return Optional.empty();
    }
}
