package wbv.diagnosis.surrogate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.Model;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Augmented;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.fit.Slot;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Recording;

/**
 * Looks for the least arrangement of bodies and links that does what was measured: the measured bodies in a chain, with a body or a link
 * more as long as each halves what is missed, in another order where nothing else helps. Where none is found that does all of it, the
 * simulation is no such net, and what is missed says nothing of where bodies and links are missing: then it is taken for what most are, a
 * person who leans on a backrest, with soft parts that swing in the trunk.
 *
 * <p>What a base's motion does to bodies tells their masses ill, once a chain is not all that there is: one that misses 2 % may put a third
 * of a person into the seat, and then carries a force in a link wrongly by a half. So a segment's mass is expected to be about what such a
 * segment weighs, and the more so, the more the arrangement misses; where it misses nothing the masses are the data's.
 */
final class ChainSearch {

    /** An arrangement that misses no more is good enough. */
    static final double GOOD = 0.005;
    /** One that misses more may have its bodies in another order. */
    private static final double POOR = 0.1;
    /** Bodies or links that nobody measured: each brings so many places for a law that more would hide where it is. */
    static final int MOST_ADDED = 2;
    /** Orders of so many bodies are all tried. */
    private static final int MOST_ORDERED = 4;
    private static final int ROUNDS = 10;
    /** A round that lowers the cost by less than this factor is the last. */
    private static final double SETTLED = 0.9;
    /** Of what a simulation did before that nothing is known [s]. */
    static final double SETTLING = 3;
    /** [s] */
    private static final double PART = 30;
    private static final int FEWEST = 1536;

    /** From the base upwards; what is not here comes last, in the order of its columns. */
    static final List<String> USUAL = List.of("platform", "floor", "seat", "cushion", "pelvis", "abdomen", "lumbar",
            "torso", "trunk", "chest", "sternum", "neck", "head");

    /** Natural frequencies of a link under all that it carries [Hz], where fits start: of the lowest, and of the others. */
    private static final double[][] STARTS = {{4, 8}, {4, 16}, {2, 6}, {8, 16}};
    /** Damping ratio of a link under what it carries, where fits start: a sitter's is 0.2 to 0.5 (assumed). */
    static final double RATIO = 0.3;
    /**
     * What rests on a seat, by location [kg]: a man of 73 kg (de Leva 1996: head and neck 6.9 %, chest and abdomen 32 %, arms 10 %, pelvis
     * 11 %, thighs 28 %, of which the seat carries half); a seat's frame and cushion are assumed. Only their ratios count.
     */
    static final Map<String,
            Double> USUAL_MASS = Map.ofEntries(Map.entry("seat", 10.0), Map.entry("cushion", 3.0), Map.entry("pelvis", 19.0),
                    Map.entry("abdomen", 12.0), Map.entry("lumbar", 12.0), Map.entry("torso", 31.0), Map.entry("trunk", 31.0),
                    Map.entry("chest", 31.0), Map.entry("sternum", 31.0), Map.entry("neck", 1.5), Map.entry("head", 5.0));
    /**
     * By what natural logarithm such a mass differs from one person, seat and cut through the body to the next: a factor of 1.5, assumed.
     */
    static final double MASS_SPREAD = 0.4;
    /** Where the search for it ends: what so wide a spread leaves out is one in fifteen thousand. */
    private static final double FARTHEST_MASS = 4 * MASS_SPREAD;
    static final Set<String> TRUNK = Set.of("torso", "trunk", "chest", "sternum");
    static final Set<String> FRAME = Set.of("seat");
    /** Where fits of soft parts start: mass over that of all, natural frequency [Hz]. */
    private static final double[][] SOFT = {{0.1, 5}, {0.1, 10}, {0.15, 7}};
    /** Part of all mass that would swing on a backrest at that frequency, where fits start. */
    private static final double BACKREST = 0.05;
    /** Masses of a body that is added, over those known, where fits start. */
    static final double LIGHT = 0.1;
    private static final double HEAVY = 0.4;
    static final double[] ADDED_FREQUENCIES = {5, 12};

    /**
     * A model as it was fitted.
     *
     * @param errors missed over signal, by channel
     * @param square what is missed over the noise, as a sum of squares
     * @param spread of masses about the usual ones, see {@link #weighed}; infinite where they were free
     */
    record Fitted(Model model, Map<Channel, Double> errors, double square, double spread) {
        double worst() {
            return errors.values().stream().mapToDouble(Double::doubleValue).max().orElseThrow();
        }

    }

    private final Recording driven;
    private final Recording part;
    private final Channel input;
    private final List<Channel> outputs;
    private final OptionalDouble noise;
    private final BiConsumer<String, Double> progress;

    /** @param driven input and outputs, nothing else */
    ChainSearch(Recording driven, Channel input, List<Channel> outputs, BiConsumer<String, Double> progress) {
        this.driven = driven;
        this.part = loudest(driven, input);
        this.input = input;
        this.outputs = outputs.stream().sorted(Comparator.comparingInt(ChainSearch::height)).toList();
        // What was computed has no noise; one that is small beside every output lets all of them count.
        double faintest = outputs.stream().mapToDouble(output -> size(driven.values(output), 0)).min().orElseThrow();
        this.noise = OptionalDouble.of(GOOD * faintest);
        this.progress = progress;
    }

    /** What arrangements are tried on: as much of the recording as a fit needs, where its input is greatest. */
    private static Recording loudest(Recording driven, Channel input) {
        double rate = driven.clock().rate();
        int length = (int) Math.max(PART * rate, FEWEST);
        if (length >= driven.length()) {
            return driven;
        }
        int best = 0;
        double greatest = -1;
        for (int from = 0; from + length <= driven.length(); from += length / 4) {
            double size = size(Arrays.copyOfRange(driven.values(input), from, from + length), 0);
            best = size > greatest ? from : best;
            greatest = Math.max(size, greatest);
        }
        int from = best;
        Map<Channel, double[]> values = new LinkedHashMap<>();
        driven.channels().forEach(channel -> values.put(channel, Arrays.copyOfRange(driven.values(channel), from,
                from + length)));
        return new Recording(new Clock(driven.clock().time(from), rate), values, driven.metadata());
    }

    private static int height(Channel channel) {
        return height(channel.location());
    }

    /** Which one a place is, from the base upwards. */
    static int height(String place) {
        int at = USUAL.indexOf(place);
        return at < 0 ? USUAL.size() : at;
    }

    /** The best on a part, fitted to all. */
    Fitted best() {
        Fitted found = arrangement();
        return fitted(found.model(), driven, found.spread());
    }

    private Fitted arrangement() {
        progress.accept("identifying the simulation", 0.0);
        Fitted best = plain();
        if (best.worst() > GOOD) {
            best = better(best, IntStream.range(1, STARTS.length).mapToObj(start -> chain(outputs, start)));
        }
        best = enriched(best);
        if (best.worst() > POOR && outputs.size() > 1 && outputs.size() <= MOST_ORDERED) {
            Fitted other = better(best, orders(outputs).stream().flatMap(order -> Stream.of(chain(order, 0), chain(order, 3))));
            best = other == best ? best : enriched(other);
        }
        List<Model> seated = best.worst() > GOOD ? seated() : List.of();
        if (seated.isEmpty()) {
            return best;
        }
        // An arrangement that is not the right one errs once by output, not by line.
        double spread = MASS_SPREAD * Math.sqrt(outputs.size() / best.square());
        return Parallel.map(seated, model -> fitted(model, part, spread)).stream().min(Comparator.comparingDouble(Fitted::worst))
                .orElseThrow();
    }

    /**
     * The measured bodies as a person's on a seat, where they are: from the seat's frame a backrest to the trunk, and soft parts in that.
     */
    private List<Model> seated() {
        Optional<String> trunk = outputs.stream().map(Channel::location).filter(TRUNK::contains).findFirst();
        int at = trunk.map(name -> outputs.stream().map(Channel::location).toList().indexOf(name)).orElse(0);
        if (at < 1 || outputs.stream().anyMatch(output -> !USUAL_MASS.containsKey(output.location()))) {
            return List.of();   // what the trunk sits on is not known apart from it, or what something weighs
        }
        String frame = outputs.stream().map(Channel::location).filter(FRAME::contains).findFirst().orElse(input.location());
        List<Model> out = new ArrayList<>();
        for (double[] soft : SOFT) {
            Model chain = chain(outputs, 0, output -> USUAL_MASS.get(output.location()));
            double mass = soft[0] * chain.mass();
            List<Model.Body> bodies = chain.bodies().stream().map(body -> body.name().equals(trunk.get())
                    ? body(body.name(), body.mass() - mass, body.sensor()) : body).toList();
            out.add(model(with(bodies, body("soft_parts", mass, Optional.empty())), with(with(chain.links(),
                    carrying(frame, trunk.get(), BACKREST * chain.mass(), soft[1])), carrying(trunk.get(), "soft_parts", mass, soft[1]))));
        }
        return out;
    }

    /** The measured bodies in a chain in their usual order, fitted from one start. */
    Fitted plain() {
        return fitted(chain(outputs, 0), part);
    }

    private Fitted enriched(Fitted chain) {
        Fitted best = chain;
        for (int added = 0; added < MOST_ADDED && best.worst() > GOOD; added++) {
            progress.accept("identifying the simulation", (1.0 + added) / (1 + MOST_ADDED));
            Fitted richer = better(best, richer(best.model()));
            if (richer.worst() > best.worst() / 2) {
                break;
            }
            best = richer;
        }
        return best;
    }

    private Fitted better(Fitted known, Stream<Model> models) {
        return Stream.concat(Stream.of(known), Parallel.map(models.toList(), model -> fitted(model, part)).stream())
                .min(Comparator.comparingDouble(Fitted::worst)).orElseThrow();
    }

    /** Fits with masses and springs that may end far from where they start: each round begins where the last one ended. */
    private Fitted fitted(Model start, Recording to) {
        return fitted(start, to, Double.POSITIVE_INFINITY);
    }

    /** @param spread of masses about the usual ones, see {@link #weighed} */
    private Fitted fitted(Model start, Recording to, double spread) {
        Model model = start;
        double cost = Double.POSITIVE_INFINITY;
        for (int round = 0; round < ROUNDS; round++) {
            List<Model.Body> masses = model.bodies();
            Evidence evidence = Evidence.computed(model, to, noise);
            Candidate baseline = weighed(Baseline.of(evidence), model, spread);
            double[] at = baseline.knobs().stream().mapToDouble(knob -> knob.slot().kind() == Slot.Kind.MASS
                    ? knob.coordinate(masses.get(knob.slot().at()).mass()) : 0).toArray();
            Fitter fitter = new Fitter(evidence);
            Fitter.Frame frame = fitter.frame(baseline, at, evidence.fit());
            Fitter.State state = fitter.fit(baseline, at, frame, 20, 1e-4);
            if (!(state.square() < SETTLED * cost)) {
                break;
            }
            cost = state.square();
            model = Augmented.of(model, baseline.at(state.x()));
        }
        Evidence evidence = Evidence.computed(model, to, noise);
        double[][] simulated = new Simulator(evidence.whole()).outputs(model.assembly());
        Map<Channel, Double> errors = new LinkedHashMap<>();
        int settled = (int) (SETTLING * evidence.recording().clock().rate());
        for (int o = 0; o < simulated.length; o++) {
            double[] counted = evidence.measured(o).clone();
            for (int i = 0; i < counted.length; i++) {
                counted[i] = evidence.valid(o)[i] ? counted[i] : Double.NaN;
            }
            errors.put(evidence.outputs().get(o), error(counted, simulated[o], settled));
        }
        return new Fitted(model, errors, cost, spread);
    }

    /**
     * With masses that are expected to be about as usual, against that of the heaviest body.
     *
     * @param spread standard deviation of a mass' natural logarithm about that of the usual one; infinite for masses that are free
     */
    private static Candidate weighed(Candidate baseline, Model model, double spread) {
        if (Double.isInfinite(spread)) {
            return baseline;
        }
        Model.Body heaviest = model.bodies().stream().max(Comparator.comparingDouble(Model.Body::mass)).orElseThrow();
        List<Knob> knobs = new ArrayList<>();
        for (Knob knob : baseline.knobs()) {
            boolean mass = knob.slot().kind() == Slot.Kind.MASS;
            String name = mass ? model.bodies().get(knob.slot().at()).name() : "";
            if (!mass || !USUAL_MASS.containsKey(name) || !USUAL_MASS.containsKey(heaviest.name())) {
                knobs.add(knob);
                continue;
            }
            double usual = heaviest.mass() * USUAL_MASS.get(name) / USUAL_MASS.get(heaviest.name());
            double far = Math.max(FARTHEST_MASS, Math.abs(Math.log(knob.reference() / usual)) + MASS_SPREAD);
            knobs.add(new Knob(knob.name(), knob.slot(), usual, 0, -far, far, spread));
        }
        return new Candidate(baseline.template(), knobs, List.of());
    }

    /**
     * The measured bodies, alike, each on the one before.
     *
     * @param start which natural frequencies to begin with
     */
    private Model chain(List<Channel> order, int start) {
        return chain(order, start, channel -> 1);
    }

    /** The same with masses of their own. */
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

    /** With a body within a link, with one on a body, and with a link past a body. */
    private Stream<Model> richer(Model model) {
        List<Model> out = new ArrayList<>();
        String name = "unmeasured" + (model.bodies().size() - outputs.size() + 1);
        for (Model.Link link : model.links()) {
            List<Model.Link> links = new ArrayList<>(model.links());
            links.remove(link);
            links.add(link(link.from(), name, 2 * link.stiffness(), 2 * link.damping()));
            links.add(link(name, link.to(), 2 * link.stiffness(), 2 * link.damping()));
            out.add(model(with(model.bodies(), body(name, LIGHT * model.mass(), Optional.empty())), links));
            out.add(model(with(model.bodies(), body(name, HEAVY * model.mass(), Optional.empty())), links));
        }
        double mass = LIGHT * model.mass();
        for (Model.Body body : model.bodies()) {
            for (double frequency : ADDED_FREQUENCIES) {
                out.add(model(with(model.bodies(), body(name, mass, Optional.empty())),
                        with(model.links(), carrying(body.name(), name, mass, frequency))));
            }
        }
        List<String> places = new ArrayList<>(List.of(input.location()));
        model.bodies().forEach(body -> places.add(body.name()));
        for (int a = 0; a < places.size(); a++) {
            for (int b = a + 1; b < places.size(); b++) {
                String from = places.get(a);
                String to = places.get(b);
                if (model.links().stream().noneMatch(link -> List.of(link.from(), link.to()).containsAll(List.of(from, to)))) {
                    out.add(model(model.bodies(), with(model.links(), carrying(from, to, mass, ADDED_FREQUENCIES[0]))));
                }
            }
        }
        return out.stream();
    }

    private Model model(List<Model.Body> bodies, List<Model.Link> links) {
        return new Model("surrogate", Optional.empty(), input.axis(), new Model.Base(input.location(), Optional.of(input)),
                bodies, links);
    }

    private static <T> List<T> with(List<T> known, T more) {
        return Stream.concat(known.stream(), Stream.of(more)).toList();
    }

    private static Model.Body body(String name, double mass, Optional<Channel> sensor) {
        return new Model.Body(name, mass, sensor, List.of(), Optional.empty(), List.of());
    }

    private static Model.Link link(String from, String to, double stiffness, double damping) {
        return new Model.Link(from, to, stiffness, damping, Optional.empty(), List.of(), List.of());
    }

    /**
     * A link on which a mass swings at a frequency.
     *
     * @param mass [kg]
     * @param frequency [Hz]
     */
    private static Model.Link carrying(String from, String to, double mass, double frequency) {
        double omega = 2 * Math.PI * frequency;
        return link(from, to, mass * omega * omega, 2 * RATIO * mass * omega);
    }

    private static List<List<Channel>> orders(List<Channel> channels) {
        if (channels.isEmpty()) {
            return List.of(List.of());
        }
        List<List<Channel>> out = new ArrayList<>();
        for (Channel first : channels) {
            for (List<Channel> rest : orders(channels.stream().filter(channel -> !channel.equals(first)).toList())) {
                List<Channel> order = new ArrayList<>(List.of(first));
                order.addAll(rest);
                out.add(order);
            }
        }
        return out;
    }

    /**
     * Root mean square of a difference over that of the first, means left out, where both are known.
     *
     * @param from first sample
     */
    static double error(double[] x, double[] y, int from) {
        double[] difference = new double[x.length];
        Arrays.setAll(difference, i -> x[i] - y[i]);
        return size(difference, from) / size(x, from);
    }

    private static double size(double[] x, int from) {
        double sum = 0;
        double squares = 0;
        int count = 0;
        for (int i = from; i < x.length; i++) {
            if (!Double.isNaN(x[i])) {
                sum += x[i];
                squares += x[i] * x[i];
                count++;
            }
        }
        return Math.sqrt(Math.max(0, squares / count - sum / count * (sum / count)));
    }
}
