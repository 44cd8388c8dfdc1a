package wbv.diagnosis;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Simulator;
import wbv.body.Stroke;

/**
 * What a driven link carries beside what the user's model says, over its deflection and its velocity: the loops that were measured, and
 * those of the laws that were found. Nothing stands between the force and its sensor, so the picture is the measurement itself.
 */
final class DrivenPortraits {

    private static final int MOST = 4000;

    private final Evidence evidence;
    private final String where;
    private final double[] beside;
    private final double[] laws;

    /** @param chosen the fit whose added laws are drawn @param user laws that the user's model has itself */
    DrivenPortraits(Evidence evidence, Fitter.State chosen, int user, int output, String where) {
        this.evidence = evidence;
        this.where = where;
        Assembly full = chosen.candidate().at(chosen.x());
        Assembly bare = new Assembly(full.structure(), full.laws().subList(0, user), full.drives(), full.outputs());
        Simulator simulator = new Simulator(evidence.whole());
        double[] without = simulator.outputs(bare)[output];
        double[] with = simulator.outputs(full)[output];
        double[] measured = evidence.measured(output);
        beside = IntStream.range(0, without.length)
                .mapToDouble(i -> evidence.valid(output)[i] ? measured[i] - without[i] : Double.NaN).toArray();
        laws = IntStream.range(0, without.length).mapToDouble(i -> with[i] - without[i]).toArray();
    }

    List<Portrait> all() {
        Stroke stroke = evidence.whole().stroke().orElseThrow();
        return List.of(over("deflection", Portrait.Scale.of("Deflection", "mm"), stroke.position()),
                over("velocity", Portrait.Scale.of("Velocity", "mm/s"), stroke.velocity()));
    }

    private Portrait over(String side, Portrait.Scale scale, double[] along) {
        int step = Math.max(1, along.length / MOST);
        int[] shown = IntStream.iterate(0, i -> i < along.length, i -> i + step).toArray();
        // The base's motion shortens the link.
        double[] x = Arrays.stream(shown).mapToDouble(i -> -1e3 * along[i]).toArray();
        return new Portrait("Force in " + where + " over " + side, scale, Portrait.Scale.of("Force beside the model's own", "N"),
                List.of(Portrait.Trail.samples("measured", x, Arrays.stream(shown).mapToDouble(i -> beside[i]).toArray()),
                        Portrait.Trail.law("laws found", x, Arrays.stream(shown).mapToDouble(i -> laws[i]).toArray())),
                "Both ends' motion was measured, so the force is drawn as its sensor read it.");
    }
}
