package wbv.diagnosis.surrogate;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import wbv.body.Model;
import wbv.body.SensorFault;
import wbv.diagnosis.measured.Measured;
import wbv.recording.Channel;
import wbv.recording.Recording;

/**
 * What a simulation gave beside a model, as channels of the recording that move the sensors too: both together are the simulation, whatever
 * moved it.
 *
 * @param model     whose sensors read those channels too
 * @param recording that has them
 */
record GivenBeside(Model model, Recording recording) {

    /** What the locations of channels end in that hold what the simulation gave beside the model. */
    private static final String BESIDE = "_beside";

    /**
     * Beside what a model's sensors read.
     *
     * @param own   what these read, by output of the model and sample, each in its unit. Not modified.
     * @param given what the simulation gave of each, by sample
     */
    static GivenBeside of(Model model, double[][] own, Function<Channel, double[]> given, Recording recording) {
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        recording.channels().forEach(channel -> channels.put(channel, recording.values(channel)));
        for (int o = 0; o < own.length; o++) {
            Channel sensor = model.outputs().get(o);
            channels.put(beside(sensor), Measured.centred(Missed.of(given.apply(sensor), own[o])));
        }
        return new GivenBeside(moved(model), recording.with(channels));
    }

    private static Model moved(Model model) {
        List<Model.Body> bodies = model.bodies().stream().map(body -> body.completed(body.mass(),
                body.sensor().map(GivenBeside::faults).orElse(List.of()), body.hidden(), body.forces())).toList();
        List<Model.Sensor> sensors = model.sensors().stream()
                .map(sensor -> new Model.Sensor(sensor.channel(), sensor.reads(), faults(sensor.channel()), sensor.at())).toList();
        return new Model(model.name(), model.source(), model.axis(), model.base(), bodies, model.links(), model.inputs(), model.declared(),
                sensors);
    }

    private static Channel beside(Channel sensor) {
        return new Channel(sensor.location() + BESIDE, sensor.quantity(), sensor.axis());
    }

    private static List<SensorFault> faults(Channel sensor) {
        return List.of(new SensorFault.Beside(beside(sensor)));
    }
}
