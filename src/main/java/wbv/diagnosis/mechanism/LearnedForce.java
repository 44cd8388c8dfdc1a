package wbv.diagnosis.mechanism;

import java.util.List;
import wbv.body.law.Learned;
import wbv.body.law.LearnedInertance;

/**
 * A force in a link that no other mechanism makes: its law is learned term by term, and only where nothing here explains what is missing.
 * All but one: a force in proportion to the acceleration of one end against the other is asked for with all the others, since one that is
 * late imitates it (over a narrow band, with a negative stiffness, to the noise).
 */
public record LearnedForce() implements Mechanism {

    @Override
    public Entry entry() {
        return new Entry(Learned.MECHANISM, Family.UNLISTED, "The link %s has a law that is in no library");
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        double unit = 0.05 * scene.model().mass();
        return scene.onRig() ? List.of() : List.of(inertance(link.index(), link.name(), unit));
    }

    /**
     * A force in proportion to the acceleration of one end against the other.
     *
     * @param unit of a search for it [kg]
     */
    public Hypothesis inertance(int link, String where, double unit) {
        return new Hypothesis(this, where, "a", List.of(new Addition.InLink(link, new LearnedInertance(unit))),
                List.of(new Hypothesis.Number("inertance_kg", unit, -100 * unit, 100 * unit)), List.of(Start.scaled(unit)));
    }
}
