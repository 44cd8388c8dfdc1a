import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import wbv.body.Assembly;
import wbv.body.Model;
import wbv.body.LawAt;
import wbv.body.law.LearnedTerm;
import wbv.body.number.Modulator;
import wbv.body.number.Shape;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.Diagnoser;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.Question;
import wbv.diagnosis.mechanism.Family;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Library;
import wbv.diagnosis.mechanism.Mechanism;
import wbv.diagnosis.mechanism.Scene;
import wbv.diagnosis.mechanism.Start;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;

/**
 * A law of one's own in a diagnosis: a cushion whose damping grows with the square of its deflection, which no entry of the library has. It
 * is tried beside all others, and named in its own words. The recording is simulated here.
 *
 * <pre>java -cp "target/wbv.jar:target/lib/*" examples/OwnLaw.java</pre>
 */
public final class OwnLaw {

    private static final double RATE = 60;
    private static final int SAMPLES = 2400;
    private static final double NOISE = 0.01;
    /** From seat to torso. */
    private static final int CUSHION = 1;

    private OwnLaw() {}

    /** What the law is called, and in which link, with which number, from which size on it is tried. */
    private record Gripping() implements Mechanism.Custom {
        @Override
        public Entry entry() {
            return new Entry("cushion.gripping", Family.LOSS, "The cushion %s grips as it is bent");
        }

        @Override
        public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
            double usual = 0.1 * link.damping() / (link.deflection() * link.deflection());
            return List.of(Hypothesis.law(this, link, "", law(usual), List.of(Hypothesis.Number.sum(usual, -100 * usual, 100 * usual)),
                    List.of(Start.scaled(usual))));
        }
    }

    /** c r² v. */
    private static LearnedTerm law(double c) {
        return new LearnedTerm(Shape.parse("r^2 v"), Modulator.NONE, c);
    }

    public static void main(String[] arguments) {
        Model model = new Model("sitter", Optional.empty(), 'z', new Model.Base("platform", Optional.of(Channel.parse("platform.acc.z"))),
                List.of(body("seat", 15, "seat.acc.z"), body("torso", 40, "sternum.acc.z")),
                List.of(link("platform", "seat", 70e3, 900), link("seat", "torso", 45e3, 800)));
        Question question = Question.of(model, ride(model, law(1.5e9))).with(Library.standard().with(new Gripping()));
        Diagnosis diagnosis = Diagnoser.examine(question, (step, share) -> {}).diagnosis();
        System.out.println(diagnosis.sentence());
        diagnosis.missing().forEach(each -> System.out.println(each.mechanism() + " at " + each.where() + ": " + each.parameters()));
    }

    /** Forty seconds of the model with the law in its cushion, under 300 sines between 2 and 9 Hz. */
    private static Recording ride(Model model, LearnedTerm law) {
        Random random = new Random(11);
        double[] base = new double[SAMPLES];
        for (int s = 0; s < 300; s++) {
            double f = 2 + 7 * random.nextDouble();
            double phase = 2 * Math.PI * random.nextDouble();
            for (int i = 0; i < SAMPLES; i++) {
                base[i] += 0.5 * Math.sqrt(2.0 / 300) * Math.sin(2 * Math.PI * f * i / RATE + phase);
            }
        }
        Assembly linear = model.assembly();
        double[][] outputs = new Simulator(new Excitation(RATE, base, Map.of()))
                .outputs(new Assembly(linear.structure(), List.of(new LawAt(CUSHION, law)), List.of(), linear.outputs()));
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        channels.put(Channel.parse("platform.acc.z"), noisy(base, random));
        channels.put(Channel.parse("seat.acc.z"), noisy(outputs[0], random));
        channels.put(Channel.parse("sternum.acc.z"), noisy(outputs[1], random));
        return new Recording(new Clock(0, RATE), channels, Metadata.NONE);
    }

    private static Model.Body body(String name, double mass, String sensor) {
        return new Model.Body(name, mass, Optional.of(Channel.parse(sensor)), List.of(), Optional.empty(), List.of());
    }

    private static Model.Link link(String from, String to, double stiffness, double damping) {
        return new Model.Link(from, to, stiffness, damping, Optional.empty(), List.of(), List.of());
    }

    private static double[] noisy(double[] clean, Random random) {
        double[] values = clean.clone();
        for (int i = 0; i < values.length; i++) {
            values[i] += NOISE * random.nextGaussian();
        }
        return values;
    }
}
