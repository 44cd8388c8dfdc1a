package wbv.diagnosis.mechanism;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * The mechanisms that a diagnosis knows.
 *
 * @param mechanisms each word once; where two fit exactly alike, the one that stands first here is taken
 */
public record Library(List<Mechanism> mechanisms) {

    private static final Library STANDARD = new Library(List.of(new Softening(), new Hardening(), new Asymmetry(), new SpeedDamping(),
            new DryFriction(), new Hysteresis(), new Separation(), new EndStop(), new Clearance(), new AbruptChange(), new GradualChange(),
            new Viscoelasticity(), new StretchReflex(), new SensorMount(), new SensorDelay(), new SensorAcCoupling(), new SensorGain(),
            new SensorMisalignment(),
            new RotationalCoupling(), new CrossAxisCoupling(), new HiddenMass(), new UnmeasuredForce(), new SensorRectifying(),
            new SensorClipping(), new Scheduled(Scheduled.What.STIFFNESS), new Scheduled(Scheduled.What.DAMPING),
            new Scheduled(Scheduled.What.FRICTION),
            new SensorBias(), new SensorDropouts(), new SensorQuantised(), new ParameterError(), new LearnedForce()));

    public Library {
        mechanisms = List.copyOf(mechanisms);
        Set<String> words = new HashSet<>();
        for (Mechanism mechanism : mechanisms) {
            if (!words.add(mechanism.word())) {
                throw new IllegalArgumentException("a library has each mechanism once: two are called '" + mechanism.word() + "'");
            }
        }
    }

    /** What wbv knows. */
    public static Library standard() {
        return STANDARD;
    }

    /** This and one more. */
    public Library with(Mechanism more) {
        List<Mechanism> all = new ArrayList<>(mechanisms);
        all.add(more);
        return new Library(all);
    }

    /** The mechanism of a word; empty for a word that it does not know. */
    public Optional<Mechanism> of(String word) {
        return mechanisms.stream().filter(mechanism -> mechanism.word().equals(word)).findFirst();
    }

    /**
     * Every mechanism at every place where it makes sense, with bounds and starting points scaled to the motion: by link, by body, by
     * sensor.
     */
    public List<Hypothesis> hypotheses(Scene scene) {
        List<Hypothesis> out = new ArrayList<>();
        scene.links().forEach(link -> mechanisms.stream()
                .filter(mechanism -> link.stiffness() > 0 || mechanism.family() == Family.COUPLING)
                .forEach(mechanism -> out.addAll(mechanism.inLink(scene, link))));
        IntStream.range(0, scene.model().bodies().size())
                .forEach(body -> mechanisms.forEach(mechanism -> out.addAll(mechanism.onBody(scene, body))));
        IntStream.range(0, scene.outputs().size())
                .forEach(output -> mechanisms.forEach(mechanism -> out.addAll(mechanism.atSensor(scene, output))));
        return out;
    }
}
