package wbv.diagnosis.convention;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.Model;
import wbv.body.simulate.Excitation;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.search.Priors;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.signal.ScalarProduct;

/** A model beside a part of a recording, as it is read and as conventions have it, each with the numbers that suit it best. */
final class Agreement {

    /** One recording in so many has some convention amiss, assumed. */
    private static final double AMISS = 50;
    /** Conventions that are fitted after a look at all. */
    private static final int FITTED = 8;
    /** Those beside which a second is asked for. */
    private static final int FIRSTS = 2;
    /** Part of an output that is left of which the model tells nothing: what is narrow in frequency chance explains some of. */
    private static final double UNEXPLAINED = 0.5;
    /** Part of what is left as it is read that is left at most as it is meant. */
    private static final double NEXT_TO_NOTHING = 1 - Priors.NEARLY_ALL;

    private final Model model;
    private final Stretch stretch;
    private final Case asRead;
    private final Optional<Weighed> given;
    private final Incoherence incoherence;

    Agreement(Model model, Recording part) {
        this.model = model;
        this.stretch = new Stretch(present(model, part));
        this.asRead = new Case(Optional.empty(), model, part, runs(model, part), spectra(part), List.of());
        this.given = weighed(asRead);
        this.incoherence = new Incoherence(model, part);
    }

    /**
     * A convention, or none, and the model and the measurements that it makes.
     *
     * @param begun where what is right already has led the numbers. Not copied
     */
    private record Case(Optional<Convention> convention, Model model, Recording part, ModelRuns runs, double[][] measured,
            List<double[]> begun) {
        Case from(double[] x) {
            return new Case(convention, model, part, runs, measured, List.of(x));
        }
    }

    /**
     * A case and what came of it.
     *
     * @param cost with that of the convention itself [nat]
     */
    private record Weighed(Case of, NumberFit.Fit fit, double cost) {
        Convention convention() {
            return of.convention().orElseThrow();
        }
    }

    /**
     * What is held.
     *
     * @param outputs what it touches: those whose names or values change, or all where what moves them does
     * @param before part of what these measured that is left as it is read [1]
     * @param after  likewise as it is meant [1]
     * @param others what explains as much, of which no recording tells it apart
     */
    record Held(Convention convention, List<Channel> outputs, double before, double after, List<Convention> others) {}

    private static boolean[] present(Model model, Recording part) {
        boolean[] present = new boolean[part.length()];
        Arrays.fill(present, true);
        model.channels().stream().map(part::values).forEach(x -> {
            for (int i = 0; i < present.length; i++) {
                present[i] &= !Double.isNaN(x[i]);
            }
        });
        return present;
    }

    private ModelRuns runs(Model meant, Recording read) {
        return new ModelRuns(meant, Excitation.of(meant, read, read.length()), stretch);
    }

    private double[][] spectra(Recording read) {
        return model.outputs().stream().map(output -> stretch.spectrum(read.values(output))).toArray(double[][]::new);
    }

    private static NumberFit fit(Case of) {
        return new NumberFit(of.runs(), of.measured());
    }

    /** Whether as much is left of what the sensors measured that one of so many conventions could be held. */
    boolean asks(int conventions) {
        return given.filter(fit -> fit.cost() - fit(asRead).least() > sure(conventions)).isPresent();
    }

    /** Odds against chance, in the logarithm, that a convention has to have beside those of any being amiss, and of its being that one. */
    private static double sure(int conventions) {
        double chance = Priors.CHANCE;
        return Math.log((1 - chance) / chance) + Math.log(AMISS * conventions);
    }

    /**
     * Outputs of which the model explains next to nothing, whatever its numbers, and should explain more.
     *
     * @param share part of the output's power that it should make at least, as it was given [1]
     */
    List<Channel> unexplained(double share) {
        return given.flatMap(fit -> asRead.runs().given().map(run -> IntStream.range(0, model.outputs().size()).filter(o -> {
            double[] own = asRead.measured()[o];
            double expected = ScalarProduct.of(run.outputs()[o], run.outputs()[o]) / ScalarProduct.of(own, own);
            return fit.fit().left()[o] > UNEXPLAINED && expected > share;
        }).mapToObj(model.outputs()::get).toList())).orElse(List.of());
    }

    /** The one of some conventions that is held, or the two where no one is; empty where neither. */
    Optional<Held> held(List<Convention> all) {
        return given.filter(before -> asks(all.size())).flatMap(before -> {
            double sure = sure(all.size());
            Case read = asRead.from(before.fit().x());
            List<Weighed> alone = likeliest(Stream.of(read), all);
            return held(before, alone, before.cost() - sure).or(() -> before.cost() - fit(asRead).least() > 2 * sure
                    ? held(before, likeliest(firsts(before, alone, all.stream().map(one -> read(read, one))), all),
                            alone.stream().mapToDouble(one -> one.cost() + sure).min().stream().reduce(before.cost(), Math::min) - 2 * sure)
                    : Optional.empty());
        });
    }

    /** Those beside which another may be amiss: that explain much alone, or that move every output where none is explained at all. */
    private Stream<Case> firsts(Weighed before, List<Weighed> alone, Stream<Case> all) {
        boolean nothing = unexplained(0).size() == model.outputs().size();
        return Stream.concat(
                alone.stream().filter(one -> before.cost() - one.cost() > -Math.log(Priors.ODDS)).limit(FIRSTS)
                        .map(one -> one.of().from(one.fit().x())),
                all.filter(each -> nothing && movesAll(each.convention().orElseThrow())));
    }

    /** @param most what it may cost [nat] */
    private Optional<Held> held(Weighed before, List<Weighed> some, double most) {
        List<Weighed> good = some.stream().filter(after -> explains(before, after, after.convention())).toList();
        return good.stream().findFirst().filter(best -> best.cost() < most)
                .map(best -> new Held(best.convention(), touched(best.convention()), left(before, best.convention()),
                        left(best, best.convention()), good.stream().skip(1)
                                .filter(other -> other.cost() < best.cost() - Math.log(Priors.ODDS)
                                        && explains(before, other, best.convention()))
                                .map(Weighed::convention).toList()));
    }

    /**
     * A look at a convention on top of a case.
     *
     * @param cost if the model were linear about where it begins [nat]
     */
    private record Glimpse(Case of, Convention next, double cost) {}

    /**
     * The likeliest conventions on top of some cases after a look at all, fitted, best first. Each two are looked at once.
     *
     * @param firsts one is held at a time, with its runs
     */
    private List<Weighed> likeliest(Stream<Case> firsts, List<Convention> all) {
        List<Glimpse> best = new ArrayList<>();
        Set<Convention> asked = new HashSet<>();
        for (Case first : (Iterable<Case>) firsts::iterator) {
            if (first.convention().isEmpty() || asked.add(first.convention().get())) {
                best.addAll(glimpses(first, all.stream().filter(next -> !asked.contains(next)
                        && first.convention().map(one -> one.goesWith(next)).orElse(true)).toList()));
                best.sort(Comparator.comparingDouble(Glimpse::cost));
                best.subList(Math.min(FITTED, best.size()), best.size()).clear();
            }
        }
        return Parallel.map(best, glimpse -> weighed(read(glimpse.of(), glimpse.next()))).stream().flatMap(Optional::stream)
                .sorted(Comparator.comparingDouble(Weighed::cost)).toList();
    }

    private List<Glimpse> glimpses(Case first, List<Convention> seconds) {
        return Parallel.map(seconds.stream().filter(next -> mayExplain(first, next)).toList(), next -> {
            Case both = read(first, next);
            return new Glimpse(first, next, fit(both).glimpse(starts(both)) + size(both));
        });
    }

    /** Whether any linear model could leave next to nothing of what a convention touches on top of a case. */
    private boolean mayExplain(Case first, Convention next) {
        Convention whole = whole(first, next);
        return given.filter(before -> incoherence.least(whole, touched(whole)) < NEXT_TO_NOTHING * left(before, whole)).isPresent();
    }

    private static Convention whole(Case first, Convention next) {
        return first.convention().<Convention>map(one -> new Both(one, next)).orElse(next);
    }

    private Case read(Case of, Convention convention) {
        Recording read = convention.read(of.part());
        Model meant = convention.read(of.model());
        boolean runsAnew = !meant.equals(of.model()) || model.excitations().stream().anyMatch(convention.touched()::contains);
        ModelRuns there = runsAnew ? runs(meant, read) : of.runs();
        return new Case(Optional.of(whole(of, convention)), meant, read, there, spectra(read), of.begun());
    }

    private Optional<Weighed> weighed(Case of) {
        return fit(of).best(starts(of)).map(fit -> new Weighed(of, fit, fit.cost() + size(of)));
    }

    /** Where fits begin: at what was given, and where what is right already has led the numbers. */
    private List<double[]> starts(Case of) {
        List<double[]> starts = new ArrayList<>(of.runs().starts());
        starts.addAll(of.begun());
        return starts;
    }

    /** By how much less usual sizes are as a convention has them [nat]. */
    private double size(Case of) {
        return of.convention().map(convention -> UsualSize.cost(of.model()) - UsualSize.cost(model) + convention.touched().stream()
                .mapToDouble(channel -> UsualSize.cost(of.part(), channel) - UsualSize.cost(asRead.part(), channel)).sum()).orElse(0.0);
    }

    /** Outputs that a convention touches: all of them where it changes what moves them. */
    private List<Channel> touched(Convention convention) {
        return model.outputs().stream().filter(output -> movesAll(convention) || convention.touched().contains(output)).toList();
    }

    private boolean movesAll(Convention convention) {
        return convention.ofNumbers() || model.excitations().stream().anyMatch(convention.touched()::contains);
    }

    /** Part of what these outputs measured that is left [1]. */
    private double left(Weighed of, Convention convention) {
        return touched(convention).stream().mapToDouble(output -> Math.min(1, of.fit().left()[model.outputs().indexOf(output)])).average()
                .orElse(1);
    }

    /** Whether a fit leaves next to nothing of what a convention touches. */
    private boolean explains(Weighed before, Weighed after, Convention of) {
        return left(after, of) < NEXT_TO_NOTHING * left(before, of);
    }
}
