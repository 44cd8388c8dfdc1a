package wbv.diagnosis.surrogate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.Model;
import wbv.recording.Channel;

/** Arrangements of bodies and links along one axis that may do what a simulation did, with the numbers at which their fits start. */
final class ChainArrangements {

    /** Natural frequencies of a link under all that it carries [Hz], where fits start: of the lowest, and of the others. */
    private static final double[][] STARTS = {{4, 8}, {4, 16}, {2, 6}, {8, 16}};
    /** Where fits of soft parts start: mass over that of all, natural frequency [Hz]. */
    private static final double[][] SOFT = {{0.1, 5}, {0.1, 10}, {0.15, 7}};
    /** Part of all mass that would swing on a backrest at that frequency, where fits start. */
    private static final double BACKREST = 0.05;
    /** Mass of a body that is added within a link, over those known, where fits start: beside {@link Enrichment#LIGHT}. */
    private static final double HEAVY = 0.4;

    private final Channel input;
    private final List<Channel> outputs;

    /** @param outputs one of each body that was measured, from the base upwards */
    ChainArrangements(Channel input, List<Channel> outputs) {
        this.input = input;
        this.outputs = List.copyOf(outputs);
    }

    /** The measured bodies, alike, each on the one before, in their usual order. */
    Model plain() {
        return chain(outputs, 0, channel -> 1);
    }

    /** The same with other numbers. */
    List<Model> startedElsewhere() {
        return IntStream.range(1, STARTS.length).mapToObj(start -> chain(outputs, start, channel -> 1)).toList();
    }

    /** The measured bodies in a chain, in every order, started at the usual frequencies and at high ones. */
    List<Model> reordered() {
        return orders(outputs).stream()
                .flatMap(order -> IntStream.of(0, STARTS.length - 1).mapToObj(start -> chain(order, start, channel -> 1))).toList();
    }

    /**
     * The measured bodies as a person's on a seat, where they are: from the seat's frame a backrest to the trunk, and soft parts in that.
     */
    List<Model> seated() {
        List<String> places = outputs.stream().map(Channel::location).toList();
        int trunk = IntStream.range(0, places.size()).filter(i -> Segment.TRUNK.contains(places.get(i))).findFirst().orElse(-1);
        // What the trunk sits on has to be known apart from it, and what each place weighs.
        boolean known = trunk > 0 && places.stream().allMatch(place -> Segment.at(place).isPresent());
        return known ? Arrays.stream(SOFT).map(soft -> leaning(places.get(trunk), soft[0], soft[1])).toList() : List.of();
    }

    /**
     * A person who leans on a backrest.
     *
     * @param share     of all mass that is soft parts [1]
     * @param frequency of these [Hz]
     */
    private Model leaning(String trunk, double share, double frequency) {
        String frame = outputs.stream().map(Channel::location).filter(Segment.FRAME::contains).findFirst().orElse(input.location());
        Model chain = chain(outputs, 0, output -> Segment.at(output.location()).orElseThrow().mass());
        double mass = share * chain.mass();
        List<Model.Body> bodies = chain.bodies().stream()
                .map(body -> body.name().equals(trunk) ? body(body.name(), body.mass() - mass, body.sensor()) : body).toList();
        return model(with(bodies, body("soft_parts", mass, Optional.empty())),
                with(with(chain.links(), carrying(frame, trunk, BACKREST * chain.mass(), frequency)),
                        carrying(trunk, "soft_parts", mass, frequency)));
    }

    /** A model with a body within a link, with one on a body, and with a link past a body. */
    List<Model> richer(Model model) {
        String name = "unmeasured" + (model.bodies().size() - outputs.size() + 1);
        double mass = Enrichment.LIGHT * model.mass();
        return Stream.of(divided(model, name), ridden(model, name, mass), bypassed(model, mass)).flatMap(List::stream).toList();
    }

    private List<Model> divided(Model model, String name) {
        List<Model> out = new ArrayList<>();
        for (Model.Link link : model.links()) {
            List<Model.Link> links = new ArrayList<>(model.links());
            links.remove(link);
            links.add(link(link.from(), name, 2 * link.stiffness(), 2 * link.damping()));
            links.add(link(name, link.to(), 2 * link.stiffness(), 2 * link.damping()));
            out.add(model(with(model.bodies(), body(name, Enrichment.LIGHT * model.mass(), Optional.empty())), links));
            out.add(model(with(model.bodies(), body(name, HEAVY * model.mass(), Optional.empty())), links));
        }
        return out;
    }

    private List<Model> ridden(Model model, String name, double mass) {
        return model.bodies().stream()
                .flatMap(body -> Arrays.stream(Enrichment.FREQUENCIES)
                        .mapToObj(frequency -> model(with(model.bodies(), body(name, mass, Optional.empty())),
                                with(model.links(), carrying(body.name(), name, mass, frequency)))))
                .toList();
    }

    private List<Model> bypassed(Model model, double mass) {
        List<Model> out = new ArrayList<>();
        List<String> places = Stream.concat(Stream.of(input.location()), model.bodies().stream().map(Model.Body::name)).toList();
        for (int a = 0; a < places.size(); a++) {
            for (int b = a + 1; b < places.size(); b++) {
                String from = places.get(a);
                String to = places.get(b);
                if (model.links().stream().noneMatch(link -> List.of(link.from(), link.to()).containsAll(List.of(from, to)))) {
                    out.add(model(model.bodies(), with(model.links(), carrying(from, to, mass, Enrichment.FREQUENCIES[0]))));
                }
            }
        }
        return out;
    }

    /**
     * Bodies, each on the one before.
     *
     * @param start  which natural frequencies to begin with
     * @param masses of them [kg]
     */
    private Model chain(List<Channel> order, int start, ToDoubleFunction<Channel> masses) {
        List<Model.Body> bodies = new ArrayList<>();
        List<Model.Link> links = new ArrayList<>();
        String below = input.location();
        double[] mass = order.stream().mapToDouble(masses).toArray();
        for (int i = 0; i < order.size(); i++) {
            String name = order.get(i).location();
            bodies.add(body(name, mass[i], Optional.of(order.get(i))));
            links.add(carrying(below, name, Arrays.stream(mass).skip(i).sum(), STARTS[start][i == 0 ? 0 : 1]));
            below = name;
        }
        return model(bodies, links);
    }

    private Model model(List<Model.Body> bodies, List<Model.Link> links) {
        return new Model("surrogate", Optional.empty(), input.axis(), new Model.Base(input.location(), Optional.of(input)),
                bodies, links);
    }

    private static <T> List<T> with(List<T> known, T more) {
        return Stream.concat(known.stream(), Stream.of(more)).toList();
    }

    static Model.Body body(String name, double mass, Optional<Channel> sensor) {
        return new Model.Body(name, mass, sensor, List.of(), Optional.empty(), List.of());
    }

    private static Model.Link carrying(String from, String to, double mass, double frequency) {
        Suspension suspension = Suspension.of(mass, frequency);
        return link(from, to, suspension.stiffness(), suspension.damping());
    }

    static Model.Link link(String from, String to, double stiffness, double damping) {
        return new Model.Link(from, to, stiffness, damping, Optional.empty(), List.of(), List.of());
    }

    private static List<List<Channel>> orders(List<Channel> channels) {
        return channels.isEmpty() ? List.of(List.of())
                : channels.stream()
                        .flatMap(first -> orders(channels.stream().filter(channel -> !channel.equals(first)).toList()).stream()
                                .map(rest -> Stream.concat(Stream.of(first), rest.stream()).toList()))
                        .toList();
    }
}
