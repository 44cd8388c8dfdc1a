package wbv.diagnosis.convention;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import wbv.body.Model;
import wbv.body.simulate.Excitation;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.measured.Measured;
import wbv.diagnosis.search.Priors;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.signal.LostSamples;
import wbv.signal.ScalarProduct;

/** A model beside a part of a recording, as it is read and as conventions have it, each with the numbers that suit it best. */
final class Agreement {

    /** One recording in so many has some convention amiss, assumed. */
    private static final double AMISS = 50;
    /** Conventions that are fitted after a look at all. */
    private static final int FITTED = 8;
    /** Starts beside the given numbers on a rig, whose resonance may be missed by its width: as for fits of physics. */
    private static final double[][] SHIFTS = {{0, 1.6}, {0.8, 0}, {-0.8, 0}};

    /** Part of an output that is left of which the model tells nothing: what is narrow in frequency chance explains some of. */
    private static final double UNEXPLAINED = 0.5;

    private final Model model;
    private final Recording part;
    private final Stretch stretch;
    private final Case asRead;
    private final Optional<Weighed> given;

    Agreement(Model model, Recording part) {
        this.model = model;
        this.part = part;
        this.stretch = new Stretch(present(model, part));
        this.asRead = new Case(Optional.empty(), runs(model, part), spectra(part));
        this.given = fit(asRead).best(starts(asRead)).map(fit -> new Weighed(asRead, fit, fit.cost()));
    }

    /** A convention, or none, and the model and the measurements that it makes. */
    private record Case(Optional<Convention> convention, ModelRuns runs, double[][] measured) {}

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

    /** The one of some conventions that is held; empty where none is. */
    Optional<Held> held(List<Convention> all) {
        return given.filter(before -> asks(all.size())).flatMap(before -> {
            List<Weighed> fitted = Parallel.map(likeliest(all), this::weighed).stream().flatMap(Optional::stream)
                    .filter(after -> explains(before, after, after.convention())).sorted(Comparator.comparingDouble(Weighed::cost))
                    .toList();
            return fitted.stream().findFirst().filter(best -> before.cost() - best.cost() > sure(all.size()))
                    .map(best -> new Held(best.convention(), touched(best.convention()), left(before, best.convention()),
                            left(best, best.convention()), fitted.stream().skip(1)
                                    .filter(other -> other.cost() < best.cost() - Math.log(Priors.ODDS)
                                            && explains(before, other, best.convention()))
                                    .map(Weighed::convention).toList()));
        });
    }

    private List<Case> likeliest(List<Convention> all) {
        List<Case> cases = all.stream().map(this::read).toList();
        double[] costs = new double[cases.size()];
        Parallel.each(costs.length, i -> costs[i] = fit(cases.get(i)).glimpse(begun(cases.get(i))) + size(cases.get(i)));
        return IntStream.range(0, costs.length).boxed().sorted(Comparator.comparingDouble(i -> costs[i])).limit(FITTED).map(cases::get)
                .toList();
    }

    private Case read(Convention convention) {
        Recording read = convention.read(part);
        Model meant = convention.read(model);
        boolean runsAnew = !meant.equals(model) || model.excitations().stream().anyMatch(convention.touched()::contains);
        return new Case(Optional.of(convention), runsAnew ? runs(meant, read) : asRead.runs(), spectra(read));
    }

    private Optional<Weighed> weighed(Case of) {
        return fit(of).best(begun(of)).map(fit -> new Weighed(of, fit, fit.cost() + size(of)));
    }

    private List<double[]> starts(Case of) {
        List<double[]> starts = new ArrayList<>(List.of(of.runs().shifted(0, 0)));
        for (double[] shift : model.isRig() && !model.driven() ? SHIFTS : new double[0][]) {
            starts.add(of.runs().shifted(shift[0], shift[1]));
        }
        return starts;
    }

    /** Where fits of conventions begin: there, and where what is right already has led the numbers. */
    private List<double[]> begun(Case of) {
        List<double[]> starts = starts(of);
        given.ifPresent(fit -> starts.add(fit.fit().x()));
        return starts;
    }

    /** By how much less usual sizes are as a convention has them [nat]. */
    private double size(Case of) {
        Convention convention = of.convention().orElseThrow();
        Recording read = convention.read(part);
        return UsualSize.cost(convention.read(model)) - UsualSize.cost(model) + convention.touched().stream()
                .mapToDouble(channel -> UsualSize.cost(channel.quantity(), rms(read.values(channel)))
                        - UsualSize.cost(channel.quantity(), rms(part.values(channel))))
                .sum();
    }

    private static double rms(double[] x) {
        return Math.sqrt(Arrays.stream(LostSamples.centred(x)).map(value -> value * value).average().orElseThrow());
    }

    /** Outputs that a convention touches: all of them where it changes what moves them. */
    private List<Channel> touched(Convention convention) {
        boolean moves = convention.touched().isEmpty() || model.excitations().stream().anyMatch(convention.touched()::contains);
        return model.outputs().stream().filter(output -> moves || convention.touched().contains(output)).toList();
    }

    /** Part of what these outputs measured that is left [1]. */
    private double left(Weighed of, Convention convention) {
        return touched(convention).stream().mapToDouble(output -> Math.min(1, of.fit().left()[model.outputs().indexOf(output)])).average()
                .orElse(1);
    }

    /** Whether a fit leaves next to nothing of what a convention touches. */
    private boolean explains(Weighed before, Weighed after, Convention of) {
        return left(after, of) < (1 - Priors.NEARLY_ALL) * left(before, of);
    }
}
