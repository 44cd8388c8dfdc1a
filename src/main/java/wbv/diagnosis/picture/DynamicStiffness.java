package wbv.diagnosis.picture;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.learn.LatentForce;
import wbv.diagnosis.learn.LinkScale;

/** The latent force over deflection at each frequency, which shows a law that is linear and remembers. */
final class DynamicStiffness {

    private final Evidence evidence;
    private final LatentForce latent;
    private final String where;
    private final LinkScale scale;

    DynamicStiffness(Evidence evidence, LatentForce latent, String where, LinkScale scale) {
        this.evidence = evidence;
        this.latent = latent;
        this.where = where;
        this.scale = scale;
    }

    /** Its real and its imaginary part, measured and as the law has it; none where the recording is too short to tell. */
    List<Portrait> portraits() {
        double rate = evidence.recording().clock().rate();
        return OutputCharts.response(latent.displacement(), new double[][] {latent.knownForce(), latent.law()}, rate).map(h -> {
            int[] shown = OutputCharts.usable(evidence, h.get(0), 1.2);
            double[] f = OutputCharts.pick(h.get(0).frequency(), shown);
            List<Portrait> out = new ArrayList<>();
            for (int part = 0; part < 2; part++) {
                double[] measured = OutputCharts.pick(part == 0 ? h.get(0).h1().re() : h.get(0).h1().im(), shown);
                double[] law = OutputCharts.pick(part == 0 ? h.get(1).h1().re() : h.get(1).h1().im(), shown);
                double[] error = IntStream.of(shown).mapToDouble(k -> h.get(0).error()[k] * h.get(0).h1().magnitude(k)).toArray();
                out.add(new Portrait((part == 0 ? "Stiffness" : "Loss") + " of " + where + " beside the linear link",
                        new Portrait.Scale("Frequency", "Hz", true),
                        Portrait.Scale.of(part == 0 ? "Real part" : "Imaginary part", scale.stiffness()),
                        List.of(Portrait.Trail.measured("as the recording asks", f, shown(measured), shown(error)),
                                Portrait.Trail.law("law found", f, shown(law))),
                        part == 0 ? "Force over deflection at each frequency: a spring is level, a relaxing one rises." : ""));
            }
            return out;
        }).orElse(new ArrayList<>());
    }

    private double[] shown(double[] x) {
        return Arrays.stream(x).map(value -> scale.stiff() * value).toArray();
    }
}
