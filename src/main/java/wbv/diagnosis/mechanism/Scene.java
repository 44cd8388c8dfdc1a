package wbv.diagnosis.mechanism;

import java.util.List;
import java.util.Optional;
import wbv.body.Law;
import wbv.body.Model;
import wbv.body.Structure;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/** What mechanisms take their measure from: a model as it fits without them, how it moved, and what was recorded. Arrays are read-only. */
public interface Scene {

    Model model();

    /**
     * Whether it is a test rig and no person: a damper of 20 kN and an electronic oscillator of 50 mV have no newton in common, so bounds go
     * by the motion and the forces of the recording alone, and there is nothing of a sitter.
     */
    boolean onRig();

    /** The model's numbers as fitted. */
    Structure structure();

    Link link(int index);

    /** Whether a body feels what acts on it as it feels what acts in its link to the base. */
    boolean standsOnBase(int body);

    List<Channel> outputs();

    /** What was measured at an output, mean removed, gaps filled. */
    double[] measured(int output);

    boolean has(Channel channel);

    /** Other channels of a quantity at a location. */
    List<Channel> companions(String location, Quantity quantity);

    /** Time between two samples [s]. */
    double step();

    /** Where the stretch that is fitted ends [s]. */
    double end();

    /** Frequencies at which what the model leaves stands out [Hz]. */
    double[] lines();

    /** Distance of two frequencies that the stretch tells apart [Hz]. */
    double spacing();

    /** The location of the sensor on a body or base; empty where there is none. */
    default String location(String body) {
        Model model = model();
        Optional<Channel> sensor = body.equals(model.base().name()) ? model.base().sensor() : model.bodies().get(model.index(body)).sensor();
        return sensor.map(Channel::location).orElse("");
    }

    /** How a link moved, and the scales that follow. */
    interface Link {

        int index();

        String name();

        /** Its own stiffness as fitted, which may be 0 [N/m]. */
        double own();

        /** Stiffness that would carry what the link carries [N/m]; not positive where nothing tells one, and no law has a measure. */
        double stiffness();

        /** Damping as fitted, or where there is none what such a link has [N s/m]. */
        double damping();

        /** Deflection, root mean square [m]. */
        double deflection();

        /** Velocity, root mean square [m/s]. */
        double speed();

        /** What it carries, root mean square: as measured where it is, as its spring and dashpot make it elsewhere [N]. */
        double force();

        /** Deflection towards a side that is not passed for a share of the time [m]. */
        double reached(Law.Side side, double share);

        /** The same of the pull of its spring and dashpot [N]. */
        double pull(double share);
    }
}
