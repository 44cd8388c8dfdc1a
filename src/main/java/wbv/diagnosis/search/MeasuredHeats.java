package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.simulate.ModulatorSeries;
import wbv.diagnosis.algebra.DirectionProducts;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.fit.Projection;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Start;

/**
 * Mechanisms that race for the best fit by free run from where the measured motion has them: along what was measured what a model lacks is
 * linear, see {@link MeasuredStarts}, so that one set of products tells what each leaves, and what any two at two places leave together.
 * Proposes, and decides nothing.
 */
final class MeasuredHeats {

    private static final Comparator<SizedMechanisms> MOST = Comparator.comparingDouble(SizedMechanisms::gain).reversed();

    private final Refinement refinement;
    private final Fitter.State base;
    private final List<SizedMechanisms.Looked> looked;
    private final Directions directions;
    private final Motion motion;
    private final Race race;

    /**
     * A way in which the model's numbers follow, and what they leave of all that was looked at then.
     *
     * @param starts where the sensors' errors follow without bounds
     */
    private record Way(AlongMeasured along, AlongMeasured.Products products, MeasuredStarts starts) {

        /** The model's numbers beside some of those that were looked at. */
        double[] numbers(Fitter.State base, DirectionProducts.Together beside) {
            double[] x = base.x().clone();
            along.move(x, products.numbers(beside));
            return x;
        }

        /** Some of those that were looked at, as strong as leaves least by some products. */
        Optional<SizedMechanisms> sized(Fitter.State base, DirectionProducts by, List<SizedMechanisms.Looked> each) {
            return SizedMechanisms.of(by, each, beside -> {
                double[] x = numbers(base, beside);
                Arrays.setAll(x, k -> Math.exp(x[k] - base.x()[k]));   // of what is no factor nothing goes by this
                return x;
            });
        }
    }

    /** What begins a race. */
    private record Contender(Way way, SizedMechanisms sized) {}

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
        this.directions = new Directions(evidence, base, motion, new ModulatorSeries(evidence.excitation(), motion));
        this.looked = looked(hypotheses);
        this.motion = motion;
    }

    /** @param pairs whether two that were looked at are asked together */
    private List<Way> ways(boolean pairs) {
        AlongMeasured measured = new AlongMeasured(directions, base, motion, new Projection(base));
        AlongMeasured free = measured.with(Projection.ofAll(base));
        AlongMeasured.Directed directed = measured.directed(Parallel.map(looked, this::vectors), pairs);
        return Stream.<UnaryOperator<AlongMeasured>>of(along -> along, AlongMeasured::asModelled).map(way -> {
            AlongMeasured along = way.apply(measured);
            return new Way(along, along.products(directed), new MeasuredStarts(directions, base, way.apply(free)));
        }).toList();
    }

    private List<SizedMechanisms.Looked> looked(List<Hypothesis> hypotheses) {
        List<SizedMechanisms.Looked> out = new ArrayList<>();
        int count = 0;
        for (Hypothesis hypothesis : hypotheses) {
            for (Start start : hypothesis.starts()) {
                SizedMechanisms.Looked one = SizedMechanisms.Looked.of(hypothesis, start, count, base.candidate(), directions);
                out.add(one);
                count += one.own().length;
            }
        }
        return List.copyOf(out);
    }

    /** What each amplitude does by itself. */
    private List<double[]> vectors(SizedMechanisms.Looked each) {
        Candidate with = base.candidate().with(each.hypothesis());
        return IntStream.range(0, each.own().length).mapToObj(c -> directions.measured(each.hypothesis(), with, each.only(c))).toList();
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
        List<Contender> first = ways(false).stream()
                .flatMap(way -> singles(way).limit(contenders).map(sized -> new Contender(way, sized))).toList();
        Set<Hypothesis> promising = promising(first);
        List<Trial> heat = race.last(Parallel.map(first, one -> begun(one, shaped(one))),
                trial -> promising.contains(trial.first().candidate().last()));
        Set<Set<String>> names = new HashSet<>();
        List<Fitter.State> last = heat.stream().map(Trial::first).filter(fit -> names.add(race.claims(fit))).limit(most).toList();
        return Parallel.map(last, refinement::polishFromBoth).stream().filter(fit -> !fit.failed())
                .sorted(Comparator.comparingDouble(Fitter.State::reduced)).toList();
    }

    /** Those that take nearly as much along the measured motion as the first of their way does. */
    private static Set<Hypothesis> promising(List<Contender> contenders) {
        Map<Way, Double> most = contenders.stream()
                .collect(Collectors.toMap(Contender::way, one -> one.sized().gain(), Math::max));
        return contenders.stream().filter(one -> one.sized().gain() >= Priors.NEARLY_ALL * most.get(one.way()))
                .map(one -> one.sized().each().get(0).hypothesis()).collect(Collectors.toSet());
    }

    /** The best of each name, those that take most first. */
    private Stream<SizedMechanisms> singles(Way way) {
        Map<String, SizedMechanisms> best = new LinkedHashMap<>();
        looked.forEach(one -> way.sized(base, way.products().directions(), List.of(one))
                .ifPresent(single -> best.merge(one.hypothesis().name(), single, MeasuredHeats::more)));
        return best.values().stream().sorted(MOST);
    }

    private static SizedMechanisms more(SizedMechanisms one, SizedMechanisms other) {
        return one.gain() < other.gain() ? other : one;
    }

    /** Where a law in a link starts that has the shape which the measured motion has. */
    private Stream<double[]> shaped(Contender single) {
        return single.way().starts().of(single.sized().on(base.candidate()), single.sized().each().get(0).hypothesis()).stream();
    }

    /** The first step by free run, also from other starts. */
    private Trial begun(Contender contender, Stream<double[]> others) {
        double[] x = contender.sized().on(base.candidate(), contender.way().numbers(base, contender.sized().together()));
        return begun(contender.sized().on(base.candidate()), Stream.concat(Stream.of(x), others));
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
        List<Trial> heat = race.last(Parallel.map(
                ways(true).stream().flatMap(way -> pairs(way, places, twins).map(sized -> new Contender(way, sized))).toList(),
                pair -> begun(pair, Stream.of())), pair -> false);
        return Parallel.map(heat.stream().limit(Effort.SECONDS).toList(), trial -> refinement.polishFromBoth(trial.first())).stream()
                .filter(fit -> !fit.failed()).min(Comparator.comparingDouble(Fitter.State::reduced))
                .map(first -> new Found(first, isAlone(first, heat)));
    }

    private boolean isAlone(Fitter.State first, List<Trial> heat) {
        return heat.stream().filter(trial -> !race.claims(trial.first()).equals(race.claims(first)))
                .allMatch(trial -> trial.excess() > Effort.BEHIND
                        * Refinement.excess(trial.ground().look(first.candidate(), first.x()).reduced()));
    }

    /**
     * The best of each two names, those that take most first: of each the best if the sensors' errors were free, or if they stayed what
     * they are without, since both are asked quickly.
     */
    private Stream<SizedMechanisms> pairs(Way way, Predicate<Set<Place>> places, Twins twins) {
        Map<Set<String>, SizedMechanisms> best = new HashMap<>();
        DirectionProducts directions = way.products().directions();
        for (DirectionProducts quick : List.of(directions.free(), directions.resting())) {
            pairs(way, quick, places, twins).forEach((names, found) -> way.sized(base, directions, found.each())
                    .ifPresent(pair -> best.merge(names, pair, MeasuredHeats::more)));
        }
        return best.values().stream().sorted(MOST).limit(2 * Effort.CONTENDERS);
    }

    private Map<Set<String>, SizedMechanisms> pairs(Way way, DirectionProducts directions, Predicate<Set<Place>> places, Twins twins) {
        Map<Set<String>, SizedMechanisms> best = new HashMap<>();
        List<Place> first = looked.stream().map(each -> twins.first(each.place())).toList();
        List<String> claims = looked.stream().map(each -> each.hypothesis().claim()).toList();
        for (int i = 0; i < looked.size(); i++) {
            for (int j = 0; j < i; j++) {
                if (!first.get(i).equals(first.get(j)) && places.test(Set.of(first.get(i), first.get(j)))) {
                    Set<String> names = both(claims.get(i), claims.get(j));
                    way.sized(base, directions, List.of(looked.get(i), looked.get(j)))
                            .ifPresent(pair -> best.merge(names, pair, MeasuredHeats::more));
                }
            }
        }
        return best;
    }

    /** Both, or the one that both are. */
    static <T> Set<T> both(T one, T other) {
        return Set.copyOf(List.of(one, other));
    }
}
