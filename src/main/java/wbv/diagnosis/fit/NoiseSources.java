package wbv.diagnosis.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import wbv.body.Assembly;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.recording.Channel;

/**
 * What reaches several outputs at once and counts as noise, beside what the input's sensors are known to add.
 *
 * @param acting forces on bodies, as far as they were found
 * @param ignored places at which whatever enters is not to be seen
 * @param heard how noisy the sensors of a rig's input are, where a fit has told it: standard deviation of a sample, in its unit
 */
record NoiseSources(BodyForce.Acting acting, List<Place> ignored, Map<Channel, Double> heard) {

    static final NoiseSources NONE = new NoiseSources(BodyForce.Acting.NONE, List.of(), Map.of());

    NoiseSources {
        ignored = List.copyOf(ignored);
        heard = Map.copyOf(heard);
    }

    NoiseSources with(BodyForce.Acting forces) {
        return new NoiseSources(forces, ignored, heard);
    }

    NoiseSources with(Map<Channel, Double> levels) {
        return new NoiseSources(acting, ignored, levels);
    }

    NoiseSources ignoring(List<Place> places) {
        return new NoiseSources(acting, Stream.concat(ignored.stream(), places.stream()).toList(), heard);
    }

    /** Whether one of them is strong. */
    boolean areStrong() {
        return acting.any() || !ignored.isEmpty();
    }

    /**
     * The whitening of outputs that all these reach through a model, in a window.
     *
     * @param seen what sensors read of something that reaches the outputs: by output at the window's lines, see {@link Nuisances#seen}
     */
    Whitening whitening(Evidence evidence, Excitation from, Assembly model, Window window, UnaryOperator<double[][]> seen) {
        Assembly linear = new Simulator(from).equivalent(model);
        UnaryOperator<double[][]> read = way -> seen.apply(window.lines(from.omega(), way));
        List<Whitening.Source> sources = new ArrayList<>();
        InputWay.of(evidence, from, linear).stream().filter(input -> input.noise().deviation() > 0)
                .map(input -> new Whitening.Source(power(window, frequency -> input.noise().power(2 * Math.PI * frequency)),
                        read.apply(input.transfer().get())))
                .forEach(sources::add);
        acting.all().map(force -> new Whitening.Source(power(window, force::power),
                read.apply(new Place(Place.Kind.BODY, force.body()).direction(from, linear)))).forEach(sources::add);
        ignored.stream().map(place -> Whitening.Source.deafening(evidence.noise(), read.apply(place.direction(from, linear))))
                .forEach(sources::add);
        return new Whitening(window, evidence.noise(), sources, ignored.size());
    }

    private static double[] power(Window window, DoubleUnaryOperator atFrequency) {
        double[] out = new double[window.lines()];
        Arrays.setAll(out, line -> atFrequency.applyAsDouble(window.frequency(line)));
        return out;
    }
}
