package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Start.fixed;
import static wbv.diagnosis.mechanism.Hypothesis.Start.grid;

import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import wbv.body.law.ContactLoss;
import wbv.body.law.RoundedContactLoss;

/** Ends that part where a preload is overcome, at once or gradually. None on a rig, whose links have no weight on them. */
record Separation() implements Mechanism {

    /** The least preload to start from [N]. */
    private static final double LEAST = 0.5;

    @Override
    public Entry entry() {
        return new Entry("contact.loss", Family.CONTACT, "Contact is lost at %s");
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        if (scene.onRig()) {
            return List.of();
        }
        double[] seldom = {0.65, 0.85, 0.95, 0.99};
        double most = link.pull(1);
        return List.of(Hypothesis.law(this, link, "", new ContactLoss(100), List.of(factor(0.5, 1000)),
                Stream.concat(grid(seldom, q -> fixed(Math.max(LEAST, link.pull(q)))).stream(),
                        DoubleStream.of(0.4, 0.6, 0.8, 0.95).mapToObj(q -> fixed(Math.max(LEAST, q * most)))).toList()),
                Hypothesis.law(this, link, "rounded", new RoundedContactLoss(100, 10), List.of(factor(0.5, 1000), factor(0.05, 300)),
                        grid(seldom, q -> {
                            double preload = Math.max(LEAST, link.pull(q));
                            return fixed(preload, 0.1 * preload);
                        })));
    }
}
