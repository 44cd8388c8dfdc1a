package wbv.diagnosis.mechanism;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.Model;
import wbv.body.Structure;
import wbv.body.law.Law;
import wbv.body.number.Modulator;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/**
 * What mechanisms take their measure from: a model as it fits without them, how it moved, and what was recorded. Arrays are not copied:
 * treat them as read-only.
 *
 * @param onRig     whether it is a test rig and no person: a damper of 20 kN and an electronic oscillator of 50 mV have no newton in
 *                  common, so bounds go by the motion and the forces of the recording alone, and there is nothing of a sitter
 * @param structure the model's numbers as fitted
 * @param links     by index
 * @param onBase    bodies that feel what acts on them as they feel what acts in their link to the base
 * @param across    channels of other axes than the model's that were recorded and are no part of it, by location and quantity
 * @param beside    channels of a quantity along other axes than a sensor's own, recorded where it is
 * @param measured  by output of the model: mean removed, gaps filled
 * @param lines     as many as there are frequencies at which what the model leaves stands out [Hz]
 * @param spacing   distance of two frequencies that the stretch tells apart [Hz]
 * @param step      time between two samples [s]
 * @param end       where the stretch that is fitted ends [s]
 * @param schedules recorded channels by which a link may go, that the model has no use for
 */
public record Scene(Model model, boolean onRig, Structure structure, List<Link> links, Set<Integer> onBase,
        BiFunction<String, Quantity, List<Channel>> across, BiFunction<Channel, Quantity, List<Channel>> beside, List<double[]> measured,
        double[] lines, double spacing, double step, double end, List<Schedule> schedules) {

    public Scene {
        links = List.copyOf(links);
        onBase = Set.copyOf(onBase);
        measured = List.copyOf(measured);
        schedules = List.copyOf(schedules);
    }

    /** Channels of the forces that push a body. */
    Stream<Channel> inputsOn(int body) {
        return model.inputs().stream().filter(input -> model.index(input.body()) == body).map(Model.Input::sensor);
    }

    List<Channel> outputs() {
        return model.outputs();
    }

    /** Outputs of one device, such as a person's IMU, whose channels have one clock and one mounting: by index, this one with them. */
    List<Integer> device(int output) {
        return device(outputs(), onRig, output);
    }

    /** The same of some outputs. */
    public static List<Integer> device(List<Channel> outputs, boolean onRig, int output) {
        String location = outputs.get(output).location();
        return onRig ? List.of(output)
                : IntStream.range(0, outputs.size()).filter(o -> outputs.get(o).location().equals(location)).boxed().toList();
    }

    List<Channel> across(String location, Quantity quantity) {
        return across.apply(location, quantity);
    }

    List<Channel> beside(Channel sensor, Quantity quantity) {
        return beside.apply(sensor, quantity);
    }

    /** The location of the sensor on a body or base; empty where there is none. */
    String location(String body) {
        Optional<
                Channel> sensor = body.equals(model.base().name()) ? model.base().sensor() : model.bodies().get(model.index(body)).sensor();
        return sensor.map(Channel::location).orElse("");
    }

    /**
     * A channel by which a link may go.
     *
     * @param level its range
     * @param levels parts of the range in which it was, each for a while
     */
    public record Schedule(Modulator.Level level, int levels) {}

    /**
     * How a link moved, and the scales that follow.
     *
     * @param own        its own stiffness as fitted, which may be 0 [N/m]
     * @param ownDamping its own damping as fitted, which may be 0 [N s/m]
     * @param stiffness  that would carry what the link carries [N/m]; not positive where nothing tells one, and no law has a measure
     * @param damping    as fitted, or where there is none what such a link has [N s/m]
     * @param deflection root mean square [m]
     * @param speed      root mean square [m/s]
     * @param force      what it carries, root mean square: as measured where it is, as its spring and dashpot make it elsewhere [N]
     * @param reached    deflection towards a side that is not passed for a share of the time [m]
     * @param pull       of its spring and dashpot, likewise [N]
     */
    public record Link(int index, String name, double own, double ownDamping, double stiffness, double damping, double deflection,
            double speed, double force, Map<Law.Side, DoubleUnaryOperator> reached, DoubleUnaryOperator pull) {

        /** Of a sine of as much deflection and speed [s]: what is long for one link is a moment for another. */
        double period() {
            return 2 * Math.PI * deflection / speed;
        }

        double reached(Law.Side side, double share) {
            return reached.get(side).applyAsDouble(share);
        }

        double pull(double share) {
            return pull.applyAsDouble(share);
        }
    }
}
