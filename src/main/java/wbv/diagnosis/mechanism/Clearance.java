package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Start.fixed;
import static wbv.diagnosis.mechanism.Start.grid;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import wbv.body.law.Backlash;
import wbv.body.law.EngagingFriction;
import wbv.body.law.RoundedBacklash;

/** Play, sharp or rounded; in a driven link also friction that a reversal lets go and that has to engage again. */
record Clearance() implements Mechanism {

    @Override
    public Entry entry() {
        return new Entry("contact.backlash", Family.CONTACT, "There is play in %s");
    }

    @Override
    public String sentence(Set<String> keys) {
        return keys.contains("engagement_m") ? "Friction in %s lets go where the motion turns round, and engages again over a travel"
                : entry().sentence();
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        double r = link.deflection();
        List<Hypothesis> out = new ArrayList<>();
        if (link.own() > 0) {
            Hypothesis.Number gap = factor(1e-3 * r, 10 * r);
            out.add(Hypothesis.law(this, link, "", new Backlash(r), List.of(gap), grid(new double[] {0.05, 0.2, 0.6}, q -> fixed(q * r))));
            if (!scene.model().driven()) {
                out.add(Hypothesis.law(this, link, "rounded", new RoundedBacklash(r, 0.5 * r, 0.3),
                        List.of(gap, factor(0.01 * r, 3 * r), sum(0.3, 0, 1)),
                        grid(new double[] {0.1, 0.4, 0.8}, q -> fixed(q * r, 0.5 * q * r, 0.3))));
            }
        }
        if (scene.model().driven()) {
            double f = link.stiffness() * r;
            List<Start> starts = new ArrayList<>();
            for (double travel : new double[] {0.15, 0.5, 1.5}) {
                for (double growth : new double[] {1, 3}) {
                    starts.add(Start.of(new double[] {f, f, travel * r, growth}, new int[] {0}, new int[] {1}));
                }
            }
            out.add(Hypothesis.law(this, link, "friction", new EngagingFriction(f, f, r, 1), List.of(sum(f, 0, 10 * f), sum(f, 0, 10 * f),
                    factor(1e-3 * r, 10 * r), factor(1e-3, 30)), starts));
        }
        return out;
    }
}
