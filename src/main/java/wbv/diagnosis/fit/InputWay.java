package wbv.diagnosis.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import wbv.body.Assembly;
import wbv.body.Model;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.measured.InputNoise;
import wbv.diagnosis.measured.Rounding;
import wbv.recording.Channel;

/**
 * The noise of a sensor of the input, and its way to the outputs: whatever the sensor reads, noise too, moves the model.
 *
 * @param noise    as it enters
 * @param transfer what a unit of it does to each output, spectra by output; asked for only where it is needed
 */
public record InputWay(Channel sensor, InputNoise noise, Supplier<double[][]> transfer) {

    /**
     * Those of all sensors of the input, of the base first; of forces that were measured on a rig only.
     *
     * @param model without laws that are not linear
     */
    public static List<InputWay> of(Evidence evidence, Excitation from, Assembly model) {
        List<InputWay> out = new ArrayList<>();
        List<Channel> base = evidence.model().base().sensors();
        for (int axis = 0; axis < base.size(); axis++) {
            int along = axis;
            InputNoise known = evidence.measured().inputNoises().get(axis);
            out.add(heard(evidence, base.get(axis), known.deviation(), known.order(),
                    () -> new Simulator(from).transmissibility(model, along)));
        }
        for (Model.Input input : evidence.onRig() ? evidence.model().inputs() : List.<Model.Input>of()) {
            Place body = new Place(Place.Kind.BODY, evidence.model().index(input.body()));
            Optional<Rounding> steps = Rounding.coarse(evidence.recording().values(input.sensor()));
            out.add(heard(evidence, input.sensor(), steps.map(Rounding::noise).orElse(0.0), 0, () -> body.direction(from, model)));
        }
        return out;
    }

    /** @param known deviation that the sensor has beside what a fit has told of it */
    private static InputWay heard(Evidence evidence, Channel sensor, double known, int order, Supplier<double[][]> transfer) {
        return new InputWay(sensor, new InputNoise(Math.hypot(known, evidence.heard().getOrDefault(sensor, 0.0)), order), transfer);
    }
}
