package wbv.diagnosis.fit;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.Assembly;
import wbv.body.Model;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.mechanism.Addition;

/**
 * A force that acts on one body all the time and has nothing to do with the ride: breath, voice, muscles, hands. No model predicts it,
 * so it belongs to the noise that every model is judged by.
 *
 * @param body      index of the body
 * @param bands     how strong it is
 * @param carried   share of the excess that it carries
 * @param following how its level follows that of the motion where it acts
 * @param lead      how much more [1] of the excess it carries than a force in any link would: little for the first body and for a head,
 *                  whose links could do the same; negative infinity where a link with a law that was found would carry nearly as much
 * @param shared    part of its power that goes with what moves the base, 0 to 1: so does what a mass makes that no sensor sees, what the
 *                  form of a law leaves, what small errors of sensors make of the ride, and where a model has bent itself for the lack of
 *                  the force
 */
public record BodyForce(int body, ForceBands bands, double carried, LevelDependence following, double lead, double shared) {

    /**
     * Forces that act on bodies, of which each is one of many.
     *
     * @param own of a person who sits still
     * @param push of more than that
     */
    public record Acting(Optional<BodyForce> own, Optional<BodyForce> push) {

        static final Acting NONE = new Acting(Optional.empty(), Optional.empty());

        /** With another force of a person who sits still, or none. */
        public Acting withOwn(Optional<BodyForce> other) {
            return new Acting(other, push);
        }

        /** With another push, or none. */
        public Acting withPush(Optional<BodyForce> other) {
            return new Acting(own, other);
        }

        /** The same where all masses are greater by a factor [1]. */
        public Acting scaled(double factor) {
            return new Acting(own.map(force -> force.scaled(factor)), push.map(force -> force.scaled(factor)));
        }

        /** All of them. */
        public Stream<BodyForce> all() {
            return Stream.concat(own.stream(), push.stream());
        }

        /** Whether there is one. */
        public boolean any() {
            return own.isPresent() || push.isPresent();
        }
    }

    /** Part of the excess that a single body has to carry before the force is believed [1]: most of it. */
    private static final double CARRIED = 0.5;
    /** How much more of what the body carries a link has to carry to be believed instead. */
    private static final double BETTER = 0.05;
    /** Part of what a body carries by which another may carry less and still be as likely. */
    private static final double ALIKE = 0.02;
    /** What sitting still may take [N]. */
    private static final double ORDINARY = 4;
    /** Part of the heaviest body's mass from which on a body belongs to the trunk. */
    private static final double TRUNK = 0.3;
    private static final double LEAD = 0.03;
    /** The same over a link that holds a law that was found, whose form is never the last word. */
    private static final double CLEAR = 0.1;
    private static final double ALL = 0.9;

    /** Whether a person sitting still could be the cause: small, on the trunk, and not following its motion for all that is known. */
    public boolean ordinary(Evidence evidence) {
        List<Model.Body> bodies = evidence.model().bodies();
        double heaviest = bodies.stream().mapToDouble(Model.Body::mass).max().orElse(0);
        // What hangs within the trunk, unseen, cannot be told from it.
        boolean trunk = bodies.get(body).mass() > TRUNK * heaviest || bodies.get(body).sensor().isEmpty();
        return trunk && Math.min(bands.rms(), bands.even()) < ORDINARY && following.mayBeWeak();
    }

    /**
     * Whether it is known to be a cause of its own: its level does not follow the motion's, or it carries all where that does not tell.
     * Where a link could do the same, what lives in links has to be ruled out by the level alone.
     */
    public boolean independent() {
        if (lead < LEAD) {
            return lead > Double.NEGATIVE_INFINITY && following.isSurelyWeak();
        }
        return following.isTold() ? following.isWeak() : carried > ALL;
    }

    /** Whether it may be a cause of its own beside what it holds of the form of a law, which follows the ride. */
    public boolean mayBeIndependent() {
        return following.mayStandAlone();
    }

    /** Whether what moves the base explains a good part of it, so that it answers to the ride. */
    public boolean coherent() {
        return shared > LevelDependence.COHERENT;
    }

    /** Root mean square of what does not go with what moves the base [N]: of a force that nobody measured all else is an error. */
    public double apart() {
        return rms() * Math.sqrt(1 - shared);
    }

    /** The same force where all masses are greater by a factor. */
    public BodyForce scaled(double factor) {
        return new BodyForce(body, bands.scaled(factor), carried, following, lead, shared);
    }

    /** Root mean square [N], as far as the fit's window shows it. */
    public double rms() {
        return bands.rms();
    }

    /**
     * Variance of each part of a line of {@link Window#spectrum} at a frequency [N²].
     *
     * @param frequency [Hz]
     */
    public double power(double frequency) {
        return bands.power(frequency);
    }

    /**
     * The force on the one body above the base's own that carries most of what a fit leaves; empty where no body carries it better than
     * links and sensors do, with fewer than two outputs and on a rig. On a body on the base it could not be told from one in the base's
     * link, where friction lives, nor a weak one from noise of the base's sensor.
     */
    public static Optional<BodyForce> aboveBase(Evidence evidence, Fitter.State state) {
        return in(evidence, state, false);
    }

    /** The same on any body: for a force so strong, or so alone, that neither friction nor noise is in question. */
    public static Optional<BodyForce> onAnyBody(Evidence evidence, Fitter.State state) {
        return in(evidence, state, true);
    }

    /**
     * A force on a body that was found beside a law.
     *
     * @param evidence that knows of it
     * @param state as that sees it
     * @param force [N], by sample of the recording. Not modified.
     */
    public static BodyForce known(Evidence evidence, Fitter.State state, int body, double[] force) {
        Simulator simulator = new Simulator(evidence.excitation());
        Assembly assembly = simulator.equivalent(state.candidate().at(state.x()));
        Entering rest = Entering.along(evidence, state, simulator.linearised(assembly).ofBodyForce(body));
        boolean[] all = new boolean[force.length];
        Arrays.fill(all, true);
        double[] signal = state.frame().whitening().window().spectrum(force, all);
        Arrays.setAll(signal, i -> signal[i] + rest.signal()[i]);
        return of(evidence, state, assembly, body, new Entering(signal, rest.variance()), 1, 1);
    }

    /** Whether such a force may act, and more outputs than one could show on which body: a rig moves nothing by itself. */
    public static boolean mayAct(Evidence evidence) {
        return evidence.outputs().size() > 1 && !evidence.onRig();
    }

    private static Optional<BodyForce> in(Evidence evidence, Fitter.State state, boolean onBase) {
        if (!mayAct(evidence)) {
            return Optional.empty();
        }
        Simulator simulator = new Simulator(evidence.excitation());
        Assembly assembly = simulator.equivalent(state.candidate().at(state.x()));
        Simulator.Linearised linear = simulator.linearised(assembly);
        List<Model.Body> bodies = evidence.model().bodies();
        double[] left = new double[bodies.size()];
        for (int b = 0; b < left.length; b++) {
            left[b] = onBase || !onBase(assembly, b) ? Entering.left(evidence, state, linear.ofBodyForce(b)) : Double.POSITIVE_INFINITY;
        }
        double least = Arrays.stream(left).min().orElseThrow();
        if (least == Double.POSITIVE_INFINITY) {
            return Optional.empty();
        }
        // Where the link between two bodies is ignored, a force on one is as good as one on the other: then it acts on the heavier.
        int best = IntStream.range(0, left.length).filter(b -> left[b] - least <= ALIKE * Math.max(0, state.reduced() - least)).boxed()
                .max(Comparator.comparingDouble(b -> bodies.get(b).mass())).orElseThrow();
        double link = Double.POSITIVE_INFINITY;
        double answering = Double.POSITIVE_INFINITY;
        for (int l = 0; l < evidence.model().links().size(); l++) {
            double there = Entering.left(evidence, state, linear.ofLinkForce(l));
            // A law that was found answers to the force too, the more the farther it is from linear, and so seems to carry it.
            if (holdsLaw(state, l)) {
                answering = Math.min(answering, there);
            } else {
                link = Math.min(link, there);
            }
        }
        double lead = (link - least) / (state.reduced() - least);
        if (lead < -BETTER || least - 1 > (1 - CARRIED) * (state.reduced() - 1)) {
            return Optional.empty();
        }
        boolean form = answering - least < CLEAR * (state.reduced() - least);
        lead = form ? Double.NEGATIVE_INFINITY : lead;
        BodyForce found = of(evidence, state, assembly, best, Entering.along(evidence, state, linear.ofBodyForce(best)),
                (state.reduced() - least) / (state.reduced() - 1), lead);
        return found.following().isAnswer() ? Optional.empty() : Optional.of(found);
    }

    /** Whether a law that is not linear was added in a link. */
    private static boolean holdsLaw(Fitter.State state, int link) {
        return state.candidate().added().stream().flatMap(h -> h.additions().stream())
                .anyMatch(a -> a instanceof Addition.InLink in && in.link() == link && !in.law().isLinear());
    }

    private static boolean onBase(Assembly assembly, int body) {
        return IntStream.range(0, assembly.structure().links()).anyMatch(l -> assembly.structure().standsOnBase(l, body));
    }

    private static BodyForce of(Evidence evidence, Fitter.State state, Assembly assembly, int body, Entering entering, double carried,
            double lead) {
        Window window = state.frame().whitening().window();
        ForceBands bands = ForceBands.of(entering, window);
        LevelDependence following = LevelDependence.of(evidence, window, entering.signal(), bands.telling(entering, window),
                bands.noise(entering, window), carried(evidence, assembly, body));
        return new BodyForce(body, bands, carried, following, lead,
                LevelDependence.withBase(evidence, window, window.series(bands.counting(entering, window))));
    }

    /** Power of what the links of a body carry as the model moves [N²], by sample of the recording. */
    private static double[] carried(Evidence evidence, Assembly assembly, int body) {
        Excitation excitation = evidence.excitation();
        Motion motion = Motion.simulated(evidence, assembly);
        double[] out = new double[excitation.samples()];
        IntStream.range(0, assembly.structure().links())
                .filter(link -> Arrays.stream(assembly.structure().stretch(link).at()).anyMatch(at -> at == body)).forEach(link -> {
                    double[] load = excitation.series(excitation.spectrumOfFine(motion.load(link)));
                    Arrays.setAll(out, i -> out[i] + load[i] * load[i]);
                });
        return out;
    }
}
