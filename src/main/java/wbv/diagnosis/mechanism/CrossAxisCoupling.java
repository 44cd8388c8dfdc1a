package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Hypothesis.Start.scaled;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import wbv.body.Drive;
import wbv.body.Model;
import wbv.diagnosis.mechanism.Hypothesis.Addition;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/** Motion along another axis that stretches a link or pushes a body. Where it was recorded, and not on a rig. */
record CrossAxisCoupling() implements Mechanism {

    /** Unit of a stiffness across [N/m]. */
    private static final double UNIT = 1000;

    @Override
    public Entry entry() {
        return new Entry("coupling.axis", Family.COUPLING, "Motion across couples into %s");
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        if (scene.onRig()) {
            return List.of();
        }
        Model model = scene.model();
        String lower = scene.location(model.links().get(link.index()).from());
        String upper = scene.location(model.links().get(link.index()).to());
        List<Hypothesis> out = new ArrayList<>();
        for (Channel across : scene.across(upper, Quantity.ACCELERATION)) {
            Channel below = new Channel(lower.isEmpty() ? across.location() : lower, Quantity.ACCELERATION, across.axis());
            if (!lower.isEmpty() && scene.across(lower, Quantity.ACCELERATION).contains(below)) {
                out.add(new Hypothesis(this, link.name(), String.valueOf(across.axis()),
                        List.of(new Addition.Driven(link.index(), new Drive.CrossAxis(across, below, UNIT))),
                        List.of(sum(UNIT, -1e6, 1e6).named("cross_stiffness_N_per_m")), List.of(scaled(UNIT))));
            }
        }
        out.addAll(pushes(scene, link.name(), upper, across -> new Addition.Driven(link.index(), new Drive.AcrossLink(across, 1))));
        return out;
    }

    @Override
    public List<Hypothesis> onBody(Scene scene, int body) {
        String name = scene.model().bodies().get(body).name();
        return scene.onRig() || scene.onBase().contains(body) ? List.of()
                : pushes(scene, name, scene.location(name), across -> new Addition.Driven(body, new Drive.AcrossBody(across, 1)));
    }

    /** Acceleration across as a force, in a link or on a body: of what is measured at the base and at the place itself. */
    private List<Hypothesis> pushes(Scene scene, String where, String location, Function<Channel, Addition> addition) {
        Set<Channel> across = new LinkedHashSet<>(scene.across(scene.location(scene.model().base().name()), Quantity.ACCELERATION));
        across.addAll(scene.across(location, Quantity.ACCELERATION));
        return across.stream().map(channel -> new Hypothesis(this, where, "push " + channel, List.of(addition.apply(channel)),
                List.of(sum(1, -200, 200).named("coupled_mass_kg")), List.of(scaled(1)))).toList();
    }
}
