package wbv.diagnosis.search;

import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.simulate.ModulatorSeries;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Start;

/**
 * Mechanisms that race for the best fit by free run from where the measured motion has them: along what was measured what a model lacks is
 * linear, see {@link MeasuredStarts}, so that one set of products tells what each leaves, and what any two at two places leave together.
 * Proposes, and decides nothing.
 */
final class MeasuredHeats {

    private static final Comparator<Pair> MOST = Comparator.comparingDouble(Pair::gain).reversed();

    private final Refinement refinement;
    private final Fitter.State base;
    private final List<Looked> looked;
    private final List<Way> ways;
    private final Race race;

    /** A way in which the model's numbers follow, and what they leave of all that was looked at then. */
    private record Way(AlongMeasured along, AlongMeasured.Products products, MeasuredStarts starts) {

        /** The model's numbers beside some of those that were looked at. */
        double[] numbers(Fitter.State base, Map<Integer, Double> strengths) {
            double[] x = base.x().clone();
            along.move(x, products.numbers(new TreeMap<>(strengths)));
            return x;
        }
    }

    /**
     * A mechanism as it is looked at.
     *
     * @param values of its numbers where it is once as strong, each in its unit
     */
    private record Looked(Hypothesis hypothesis, Start start, double[] values, Place place) {

        /** Its numbers where it is so many times as strong; empty where it may not be. */
        Optional<double[]> times(double strength) {
            if (start.columns().isEmpty()) {
                return strength * Effort.NEAR_ONE > 1 && strength < Effort.NEAR_ONE ? Optional.of(values) : Optional.empty();
            }
            double[] all = new double[start.columns().size()];
            Arrays.fill(all, strength);
            double[] sized = Screening.sized(hypothesis, start, all);
            return IntStream.range(0, sized.length)
                    .allMatch(i -> hypothesis.numbers().get(i).low() <= sized[i] && sized[i] <= hypothesis.numbers().get(i).high())
                            ? Optional.of(sized)
                            : Optional.empty();
        }
    }

    /** One of those that were looked at, and what it takes of the sum of squares [1]. */
    private record Single(Way way, int one, double strength, double gain) {}

    /** Two of those that were looked at, and what they take of the sum of squares [1]. */
    private record Pair(Way way, int one, int other, double[] strengths, double gain) {}

    /**
     * Each as it is looked at from all of its starts.
     *
     * @param base what they stand on, fitted, with its derivatives
     * @param motion as measured, or as what is nearly right moves
     */
    MeasuredHeats(Evidence evidence, Fitter.State base, Motion motion, List<Hypothesis> hypotheses) {
        this.refinement = new Refinement(evidence);
        this.base = base;
        this.race = Race.on(base, refinement, new Fitter(evidence));
        Directions directions = new Directions(evidence, base, motion, new ModulatorSeries(evidence.excitation(), motion));
        this.looked = hypotheses.stream().flatMap(h -> h.starts().stream().map(start -> looked(h, start))).toList();
        AlongMeasured measured = new AlongMeasured(directions, base, motion);
        AlongMeasured.Directed directed = measured.directed(Parallel.map(looked,
                each -> directions.measured(each.hypothesis(), base.candidate().with(each.hypothesis()), each.values())));
        this.ways = Stream.of(measured, measured.asModelled())
                .map(along -> new Way(along, along.products(directed), new MeasuredStarts(directions, base, along))).toList();
    }

    private Looked looked(Hypothesis hypothesis, Start start) {
        double[] once = new double[start.columns().size()];
        Arrays.fill(once, 1);
        return new Looked(hypothesis, start, Screening.sized(hypothesis, start, once), Place.plain(hypothesis, base.candidate()));
    }

    /** Those that fit best, polished: as many as are sought, best first; none that failed. */
    List<Fitter.State> best(int most) {
        return best(most, Effort.CONTENDERS);
    }

    /**
     * The one that fits best along a motion that is nearly right, for which fewer need to race; empty where it stands at a bound that
     * nothing real has.
     */
    Optional<Fitter.State> first() {
        return best(1, Effort.PLACES).stream().filter(fit -> !Refinement.extreme(fit)).findFirst();
    }

    /** @param contenders how many names race of each way */
    private List<Fitter.State> best(int most, int contenders) {
        List<Single> first = ways.stream().flatMap(way -> singles(way).limit(contenders)).toList();
        List<Trial> heat = race.last(Parallel.map(first, this::begun));
        Set<Set<String>> names = new HashSet<>();
        List<Fitter.State> last = heat.stream().map(Trial::first).filter(fit -> names.add(race.claims(fit))).limit(most).toList();
        return Parallel.map(last, refinement::polishFromBoth).stream().filter(fit -> !fit.failed())
                .sorted(Comparator.comparingDouble(Fitter.State::reduced)).toList();
    }

    /** The best of each name, those that take most first. */
    private Stream<Single> singles(Way way) {
        Map<String, Single> best = new LinkedHashMap<>();
        for (int i = 0; i < looked.size(); i++) {
            single(way, i).ifPresent(single -> best.merge(looked.get(single.one()).hypothesis().name(), single,
                    (a, b) -> a.gain() < b.gain() ? b : a));
        }
        return best.values().stream().sorted(Comparator.comparingDouble(Single::gain).reversed());
    }

    private Optional<Single> single(Way way, int one) {
        double square = way.products().each()[one][one];
        double strength = -way.products().left()[one] / square;
        return square > 0 && looked.get(one).times(strength).isPresent()
                ? Optional.of(new Single(way, one, strength, strength * strength * square))
                : Optional.empty();
    }

    /** The first step of one by free run, also from the shape that the measured motion has, where it is a law in a link. */
    private Trial begun(Single single) {
        Looked one = looked.get(single.one());
        Candidate with = base.candidate().with(one.hypothesis());
        double[] values = one.times(single.strength()).orElseThrow();
        double[] sized = base.candidate().extended(single.way().numbers(base, Map.of(single.one(), single.strength())), with,
                one.hypothesis(), values);
        return begun(with, Stream.concat(Stream.of(sized), single.way().starts().of(with, one.hypothesis()).stream()));
    }

    /**
     * The first step by free run from the best of some starts, and of the same with the model's numbers as fitted without: along a motion
     * that is measured with sensors that err, numbers go far that a free run must pay for.
     */
    private Trial begun(Candidate with, Stream<double[]> starts) {
        Trial.Ground ground = race.ground(with);
        Fitter.State best = starts.flatMap(x -> Stream.of(x, Candidate.standing(x, base.x()))).map(x -> ground.look(with, x))
                .min(Comparator.comparingDouble(Fitter.State::cost)).orElseThrow();
        return new Trial(ground, List.of(best)).onward(1);
    }

    /**
     * The pair that came first.
     *
     * @param fit polished
     * @param isAlone whether all of other names were given up on the way, as far behind as a hypothesis is that cannot come to be as good
     */
    record Found(Fitter.State fit, boolean isAlone) {}

    /**
     * The pair that fits best after a race; empty where none may be.
     *
     * @param places whether they may act at two places, of twins the first
     */
    Optional<Found> two(Predicate<Set<Place>> places, Twins twins) {
        List<Trial> heat = race.last(Parallel.map(ways.stream().flatMap(way -> pairs(way, places, twins)).toList(), this::begun));
        return Parallel.map(heat.stream().limit(Effort.SECONDS).toList(), trial -> refinement.polishFromBoth(trial.first())).stream()
                .filter(fit -> !fit.failed()).min(Comparator.comparingDouble(Fitter.State::reduced))
                .map(first -> new Found(first, isAlone(first, heat)));
    }

    private boolean isAlone(Fitter.State first, List<Trial> heat) {
        return heat.stream().filter(trial -> !race.claims(trial.first()).equals(race.claims(first)))
                .allMatch(trial -> trial.excess() > Effort.BEHIND
                        * Refinement.excess(trial.ground().look(first.candidate(), first.x()).reduced()));
    }

    /** The best of each two names, those that take most first. */
    private Stream<Pair> pairs(Way way, Predicate<Set<Place>> places, Twins twins) {
        Map<Set<String>, Pair> best = new HashMap<>();
        List<Place> first = looked.stream().map(each -> twins.first(each.place())).toList();
        List<String> claims = looked.stream().map(each -> each.hypothesis().claim()).toList();
        for (int i = 0; i < looked.size(); i++) {
            for (int j = 0; j < i; j++) {
                if (!first.get(i).equals(first.get(j)) && places.test(Set.of(first.get(i), first.get(j)))) {
                    Set<String> names = both(claims.get(i), claims.get(j));
                    pair(way, i, j).ifPresent(pair -> best.merge(names, pair, (a, b) -> a.gain() < b.gain() ? b : a));
                }
            }
        }
        return best.values().stream().sorted(MOST).limit(2 * Effort.CONTENDERS);
    }

    /** Both, or the one that both are. */
    static <T> Set<T> both(T one, T other) {
        return Set.copyOf(List.of(one, other));
    }

    /** Two of those that were looked at, as strong as leaves least; empty where they may not be, or do the same. */
    private Optional<Pair> pair(Way way, int one, int other) {
        double[][] p = way.products().each();
        double[] g = way.products().left();
        double across = p[one][other];
        double apart = p[one][one] * p[other][other] - across * across;
        if (!(apart > PartialledOut.LEAST_NEW * p[one][one] * p[other][other])) {
            return Optional.empty();
        }
        double first = (across * g[other] - p[other][other] * g[one]) / apart;
        double second = (across * g[one] - p[one][one] * g[other]) / apart;
        return looked.get(one).times(first).isPresent() && looked.get(other).times(second).isPresent()
                ? Optional.of(new Pair(way, one, other, new double[] {first, second}, -first * g[one] - second * g[other]))
                : Optional.empty();
    }

    /** The first step of both by free run. */
    private Trial begun(Pair pair) {
        Looked one = looked.get(pair.one());
        Looked other = looked.get(pair.other());
        double[] x = pair.way().numbers(base, Map.of(pair.one(), pair.strengths()[0], pair.other(), pair.strengths()[1]));
        Candidate first = base.candidate().with(one.hypothesis());
        Candidate both = first.with(other.hypothesis());
        x = base.candidate().extended(x, first, one.hypothesis(), one.times(pair.strengths()[0]).orElseThrow());
        x = first.extended(x, both, other.hypothesis(), other.times(pair.strengths()[1]).orElseThrow());
        return begun(both, Stream.of(x));
    }
}
