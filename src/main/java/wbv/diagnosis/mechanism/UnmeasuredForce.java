package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import wbv.body.Drive;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis.Number;

/**
 * A force of its own on a body: a tone, where one stands out. A push that is no tone is found without a law. Not looked for on a rig.
 */
public record UnmeasuredForce() implements Mechanism {

    /** Within half a line of its peak a tone's phase still runs away over the record: quarters of a line are near enough. */
    private static final double[] BESIDE = {0, -0.25, 0.25, -0.5, 0.5};

    @Override
    public Entry entry() {
        return new Entry("input.unmeasured", Family.FORCE, "A force that was not measured acts on %s");
    }

    @Override
    public List<Hypothesis> onBody(Scene scene, int body) {
        if (scene.onRig() || scene.lines().length == 0) {
            return List.of();
        }
        List<Start> tones = Arrays.stream(scene.lines()).boxed().flatMap(f -> Arrays.stream(BESIDE)
                .mapToObj(q -> Start.of(new double[] {1, 1, f + q * scene.spacing()}, new int[] {0}, new int[] {1}))).toList();
        return List.of(new Hypothesis(this, scene.model().bodies().get(body).name(), "",
                List.of(new Addition.Driven(body, new Drive.Tone(1, 1, scene.lines()[0]))), Number.named(Drive.Tone.class,
                        List.of(sum(1, -300, 300), sum(1, -300, 300), sum(0.01, 0.4, 20))),
                tones));
    }

    @Override
    public List<Told> told(List<Number> numbers) {
        return List.of(Told.plain(numbers.get(2).key(), 2), Told.amplitude("amplitude_N", 0, 1));
    }

    @Override
    public Doubt doubt(String key) {
        return key.equals("frequency_hz") ? Doubt.NONE : Doubt.SHARE;
    }

    @Override
    public Optional<String> against(Mechanism rival) {
        boolean told = rival.family() == Family.DYNAMIC || rival.family() == Family.DRIFT || rival.family() == Family.COUPLING;
        return told ? Optional.of(entry().experiment()) : Optional.empty();
    }
}
