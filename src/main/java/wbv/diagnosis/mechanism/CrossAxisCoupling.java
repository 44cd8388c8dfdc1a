package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Start.scaled;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import wbv.body.Drive;
import wbv.body.Model;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis.Number;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/** Motion along another axis that stretches a link or pushes a body. Where it was recorded, and not on a rig. */
record CrossAxisCoupling() implements Mechanism {

    /** Unit of a stiffness across [N/m]. */
    private static final double UNIT = 1000;
    /** Where a seated trunk or head swings across [Hz], to start from, and its damping ratio: assumed. */
    private static final double[] SWINGS = {1, 2, 4};
    private static final double SWING_DAMPING = 0.4;
    /** Stiffness across [N/m], frequency [Hz] and damping ratio of the swing, height [m]: bounds far beyond a person's. */
    private static final List<
            Number> NUMBERS = List.of(sum(UNIT, -1e6, 1e6), Number.factor(0.5, 10), Number.factor(0.05, 2), sum(0.5, -3, 3));

    @Override
    public Entry entry() {
        return new Entry("coupling.axis", Family.COUPLING, "Motion across couples into %s");
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        if (scene.onRig()) {
            return List.of();
        }
        Model.Link ends = scene.model().links().get(link.index());
        String base = scene.location(scene.model().base().name());
        String lower = scene.location(ends.from());
        String upper = scene.location(ends.to());
        List<Hypothesis> out = new ArrayList<>();
        for (char axis : "xyz".toCharArray()) {
            Optional<Channel> floor = along(axis, scene.across(base, Quantity.ACCELERATION));
            Optional<Channel> rate = scene.across(base, Quantity.ANGULAR_RATE).stream().filter(channel -> channel.axis() != axis)
                    .findFirst();
            Optional<Channel> below = along(axis, scene.across(lower, Quantity.ACCELERATION));
            Optional<Channel> above = along(axis, scene.across(upper, Quantity.ACCELERATION));
            if (below.isPresent() && above.isPresent()) {
                out.add(new Hypothesis(this, link.name(), String.valueOf(axis),
                        List.of(new Addition.Driven(link.index(), new Drive.CrossAxis(above.get(), below.get(), UNIT))),
                        List.of(sum(UNIT, -1e6, 1e6).named("cross_stiffness_N_per_m")), List.of(scaled(UNIT))));
            } else if (floor.isPresent() && rate.isPresent()) {
                below.map(end -> swinging(link, axis, new Drive.UpperSwings(floor.get(), rate.get(), end, UNIT, 1, SWING_DAMPING, 0)))
                        .ifPresent(out::add);
                above.map(end -> swinging(link, axis, new Drive.LowerSwings(floor.get(), rate.get(), end, UNIT, 1, SWING_DAMPING, 0)))
                        .ifPresent(out::add);
            }
        }
        out.addAll(pushes(scene, link.name(), upper, across -> new Addition.Driven(link.index(), new Drive.AcrossLink(across, 1))));
        return out;
    }

    private static Optional<Channel> along(char axis, List<Channel> channels) {
        return channels.stream().filter(channel -> channel.axis() == axis).findFirst();
    }

    private Hypothesis swinging(Scene.Link link, char axis, Drive swings) {
        return new Hypothesis(this, link.name(), String.valueOf(axis), List.of(new Addition.Driven(link.index(), swings)),
                Number.named(swings.getClass(), NUMBERS),
                Start.grid(SWINGS, frequency -> Start.of(new double[] {UNIT, frequency, SWING_DAMPING, 0}, new int[] {0})));
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
