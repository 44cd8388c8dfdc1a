package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Start.fixed;
import static wbv.diagnosis.mechanism.Start.grid;

import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import wbv.body.law.ContactLoss;
import wbv.body.law.RoundedContactLoss;

/** Ends that part where a preload is overcome, at once or gradually. */
record Separation() implements Mechanism {

    /** Preloads that are looked for, in parts of the greatest pull of a link that never parts [1]: assumed. */
    private static final double LEAST = 3e-3;
    private static final double MOST = 5;

    @Override
    public Entry entry() {
        return new Entry("contact.loss", Family.CONTACT, "Contact is lost at %s");
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        double most = link.pull(1);
        if (!(link.own() > 0) || scene.model().driven() || !(most > 0)) {
            return List.of();
        }
        double[] seldom = {0.65, 0.85, 0.95, 0.99};
        double least = LEAST * most;
        Hypothesis.Number preload = factor(least, MOST * most);
        return List.of(Hypothesis.law(this, link, "", new ContactLoss(most), List.of(preload),
                Stream.concat(grid(seldom, q -> fixed(Math.max(least, link.pull(q)))).stream(),
                        DoubleStream.of(0.4, 0.6, 0.8, 0.95).mapToObj(q -> fixed(q * most))).toList()),
                Hypothesis.law(this, link, "rounded", new RoundedContactLoss(most, 0.1 * most),
                        List.of(preload, factor(0.1 * least, most)), grid(seldom, q -> {
                            double at = Math.max(least, link.pull(q));
                            return fixed(at, 0.1 * at);
                        })));
    }
}
