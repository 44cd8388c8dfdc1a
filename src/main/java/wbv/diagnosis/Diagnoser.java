package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import wbv.body.Model;
import wbv.diagnosis.convention.ConventionCheck;
import wbv.diagnosis.measured.AccelerationUnit;
import wbv.diagnosis.measured.Excerpts;
import wbv.diagnosis.fit.BodyForce;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.search.Calibration;
import wbv.diagnosis.search.Effort;
import wbv.diagnosis.search.Priors;
import wbv.diagnosis.search.Refinement;
import wbv.diagnosis.search.Search;
import wbv.diagnosis.search.Whereabouts;
import wbv.recording.Recording;

/**
 * The whole way from a model and a recording to a diagnosis: fit what may be wrong without physics missing, screen every mechanism at
 * every place, refit the best by free run, add a second only if it must, decide, and prove on data not used.
 */
public final class Diagnoser {

    private final Inquiry inquiry;
    private final Evidence evidence;
    private final Search search;
    private final Fitter.State base;

    private Diagnoser(Inquiry inquiry) {
        this.inquiry = inquiry;
        this.evidence = inquiry.evidence();
        this.search = inquiry.search();
        this.base = inquiry.base();
    }

    /**
     * Diagnoses.
     *
     * @param progress told the step and the share of it that is done, 0 to 1 or NaN
     * @throws wbv.recording.DataFault if the recording lacks what the model needs
     */
    public static Diagnosis diagnose(Model model, Recording recording, BiConsumer<String, Double> progress) {
        return diagnose(Question.of(model, recording), progress);
    }

    /**
     * Diagnoses, with what else is known.
     *
     * @param progress as for the shorter form
     */
    public static Diagnosis diagnose(Question question, BiConsumer<String, Double> progress) {
        return examine(question, progress).diagnosis();
    }

    /** Diagnoses, and keeps what the pictures are drawn from. */
    public static Diagnosed examine(Question question, BiConsumer<String, Double> progress) {
        Optional<Excerpts> pieces = question.pieces();
        return admitted(question.of(pieces), progress).saying(pieces.map(Excerpts::sentence));
    }

    private static Diagnosed admitted(Question question, BiConsumer<String, Double> progress) {
        Model model = question.asked();
        // A person's accelerations in another unit are refused at once; how long a bench must be recorded goes by its numbers' units.
        Optional<Evidence> admitted = model.isRig() ? Optional.empty() : Optional.of(asked(question, model));
        return ConventionCheck.of(model, question.recording(), !question.unitsKnown(), question.isOfGivenNumbers())
                .map(meant -> examine(question.meant(meant), progress).saying(meant.sentence()))
                .orElseGet(() -> examine(question, admitted.orElseGet(() -> asked(question, model)), progress));
    }

    private static Diagnosed examine(Question question, Evidence evidence, BiConsumer<String, Double> progress) {
        return ForceSign.in(question, evidence).map(turned -> examine(turned.question(), progress).saying(turned.sentence()))
                .orElseGet(() -> {
                    Diagnosed found = run(Inquiry.of(evidence, progress));
                    return Learning.completed(found, progress);
                });
    }

    /** The diagnosis where sensors and a person who sits still do all that a model as it is given leaves; else empty, and not searched. */
    public static Optional<Diagnosed> silent(Question question, BiConsumer<String, Double> progress) {
        Optional<Excerpts> pieces = question.pieces();
        Question judged = question.of(pieces);
        Inquiry asked = Inquiry.of(asked(judged, judged.asked()), progress);
        Optional<Inquiry> quiet = asked.leaves(asked.base(), Priors.SILENT) ? Optional.of(asked) : asked.knowingWhoSitsStill();
        return quiet.filter(knowing -> Verdicts.mayBeRight(knowing.given())).map(knowing -> Conclusion.of(knowing, List.of()))
                .filter(found -> found.diagnosis().verdict() == Diagnosis.Verdict.NOTHING_MISSING)
                .map(found -> found.saying(pieces.map(Excerpts::sentence)));
    }

    private static Evidence asked(Question question, Model model) {
        Evidence evidence = new Evidence(model, question.recording(), question.noise(), question.provedFrom()).with(question.library());
        if (!question.unitsKnown()) {
            AccelerationUnit.check(evidence.measured());
        }
        return evidence;
    }

    private static Diagnosed run(Inquiry inquiry) {
        inquiry.progress().accept("fitting the model", 0.0);
        return new Diagnoser(inquiry).run();
    }

    private Diagnosed run() {
        double heldOut = inquiry.heldOut(base);
        boolean asked = evidence.isLate() || evidence.measured().isChosen() || evidence.acting().any();
        boolean louderLater = !asked && heldOut > Priors.STRANGE && heldOut > Priors.STRANGE * base.reduced();
        // What is plain is sought, whatever data that were not used show: a law may act little in a part that is shaken less.
        boolean loud = Math.min(base.reduced(), heldOut) > Priors.SILENT || base.reduced() > Priors.LOUD || heldOut > Priors.STRANGE;
        // The little that is left may be a person's own force, or noise of an input of which nobody knows it.
        boolean quiet = Math.max(base.reduced(), heldOut) < Priors.SILENT;
        return louderLater ? louderLater() : loud ? searched() : quiet ? Conclusion.of(inquiry, List.of())
                : noiseAlone().orElseGet(() -> Conclusion.of(inquiry.hearingInput(base), List.of()));
    }

    /** The diagnosis where data not used for the fit show much more than those that were: first of those that show it plainly. */
    private Diagnosed louderLater() {
        Optional<Diagnosed> here = base.reduced() > Priors.GLARING ? Optional.of(searched()) : Optional.empty();
        return here.filter(found -> found.isByHypothesis() || found.isOneLaw()).orElseGet(() -> {
            Diagnosed later = run(Inquiry.of(evidence.late(), inquiry.progress()));
            // Or the fit went astray, and what it was not made for shows that the most; or a change lies before the late part, which does
            // not show it.
            return later.isUnexplained() ? Optional.of(here.orElseGet(this::searched)).filter(found -> !found.isUnexplained()).orElse(later)
                    : later;
        });
    }

    /** The diagnosis where something is missing, if no more than a person's own force. */
    private Diagnosed searched() {
        return evidence.acting().own().isPresent() ? asKnown(Whereabouts.found(evidence, base))
                : noiseAlone().or(this::linear).orElseGet(() -> withOwnForce(Whereabouts.found(evidence, base)));
    }

    /** The diagnosis where all that is left is what a person does who sits still, or noise of a rig's input. */
    private Optional<Diagnosed> noiseAlone() {
        return inquiry.knowingWhoSitsStill().or(inquiry::hearingInputAlone).map(knowing -> Conclusion.of(knowing, List.of()));
    }

    /**
     * The diagnosis of a plain mismatch of which a linear mechanism leaves noise alone, or what a person does who sits still, on data not
     * used for it too: no law that is not linear does so little to the form of the motion, and where it enters need not be asked first.
     */
    private Optional<Diagnosed> linear() {
        List<Fitter.State> leaders = base.reduced() < Priors.GLARING ? List.of() : search.linear(base, Effort.LEADERS, Priors.MAJORITY);
        return leaders.stream().findFirst().filter(best -> !(Refinement.explained(base, best) < Priors.NEARLY_ALL))
                .flatMap(best -> inquiry.leaves(best, Priors.SILENT) ? Optional.of(Conclusion.of(inquiry, leaders))
                        : besideWhoSitsStill(best, leaders));
    }

    private Optional<Diagnosed> besideWhoSitsStill(Fitter.State best, List<Fitter.State> leaders) {
        return inquiry.own(best).flatMap(force -> {
            Inquiry knowing = inquiry.knowing(force);
            List<Fitter.State> again = knowing.again(leaders);
            return knowing.leaves(again.get(0), Priors.SILENT) ? Optional.of(Conclusion.of(knowing, again)) : Optional.empty();
        });
    }

    /** The diagnosis that knows of a person's own force, where there may be one; or not, where that names nothing or leaves more. */
    private Diagnosed withOwnForce(Whereabouts where) {
        Optional<Diagnosed> knowing = where.ownForce().map(own -> run(inquiry.knowing(own)));
        Optional<Diagnosed> named = knowing.filter(found -> !found.isOpen());
        return knowing.filter(Diagnosed::isOneLaw).or(() -> named.filter(found -> !inquiry.isMoreThanOwn(found.chosen))).orElseGet(() -> {
            // What was taken for a person's force is a part of what is missing: of a push that is all there is and goes by no law, or else.
            boolean pushed = knowing.isPresent() && named.isEmpty() && inquiry.push().isPresent();
            Diagnosed without = pushed ? Conclusion.of(inquiry, List.of()) : asKnown(where);
            return without.isUnexplained() ? knowing.orElse(without) : without;
        });
    }

    /** The diagnosis with no more known of a person's own force than the evidence says, until a hypothesis has explained the rest. */
    private Diagnosed asKnown(Whereabouts where) {
        return heard(leaders(where), where, Effort.ROUNDS);
    }

    /** With a rig's noise read, so many times at most, from what the best hypothesis leaves: what leaves less of one may not of another. */
    private Diagnosed heard(List<Fitter.State> leaders, Whereabouts where, int times) {
        Optional<Inquiry> quieter = times == 0 ? Optional.empty() : leaders.stream().findFirst().flatMap(inquiry::beside);
        return quieter.map(hearing -> new Diagnoser(hearing).heard(hearing.again(leaders), where, times - 1))
                .orElseGet(() -> asKnown(leaders, where));
    }

    private Diagnosed asKnown(List<Fitter.State> leaders, Whereabouts where) {
        Fitter.State best = leaders.stream().findFirst().orElse(base);   // what it leaves shows the person's own force
        Inquiry hearing = inquiry.hearingInput(best);
        return hearing != inquiry ? judged(hearing, leaders)
                : best.reduced() > Priors.STRANGE && inquiry.isOneLaw(best) ? Conclusion.of(inquiry, leaders)
                        : withForceLeft(leaders, best, where);
    }

    /** The diagnosis with the force in the noise that the best hypothesis leaves, if that is a person's own. */
    private Diagnosed withForceLeft(List<Fitter.State> leaders, Fitter.State best, Whereabouts where) {
        boolean quiet = best.reduced() < (evidence.acting().own().isEmpty() ? Priors.SILENT : Priors.NOISE);
        // Of two mechanisms the second may look like one, which explains whatever it does.
        boolean hidden = best.reduced() > Priors.STRANGE && inquiry.pairs().isEnough(best);
        Optional<BodyForce> own = quiet || hidden ? Optional.empty() : inquiry.own(best);
        return own.map(force -> judged(inquiry.knowing(force), leaders)).orElseGet(() -> withPush(leaders, where));
    }

    /** The diagnosis where a strong force may be all that is missing, or hide what else is. */
    private Diagnosed withPush(List<Fitter.State> leaders, Whereabouts where) {
        Fitter.State best = leaders.stream().findFirst().orElse(base);
        boolean strong = best.reduced() > Priors.STRANGE && evidence.acting().push().isEmpty();
        // A hidden mass looks like a push too, and so may a sitter's own force; so first they were asked for.
        if (strong && inquiry.isPush()) {
            return Conclusion.of(inquiry, List.of());
        }
        // A strong push hides what else is missing: what shows beside it?
        Optional<BodyForce> left = strong && best != base ? inquiry.pushBeside(best) : Optional.empty();
        return left.flatMap(push -> inquiry.besidePush(leaders)
                .or(() -> inquiry.besideKnown(push, knowing -> new Diagnoser(knowing).asKnown(knowing.again(leaders), where))))
                .orElseGet(() -> named(leaders, where));
    }

    /** The diagnosis of what was found, or with a push that shows beside a mechanism only, where that does not explain nearly all. */
    private Diagnosed named(List<Fitter.State> leaders, Whereabouts where) {
        Diagnosed found = Conclusion.of(inquiry, leaders);
        if (found.explainsNearlyAll() || evidence.acting().any() || evidence.onRig()) {   // nobody pushes a rig
            return found;
        }
        Optional<Diagnosed> together = inquiry.besidePush(leaders);
        return (found.isUnexplained() ? together.or(() -> where.push().flatMap(push -> inquiry.besideKnown(push, Diagnoser::run)))
                : together)
                .orElse(found);
    }

    private List<Fitter.State> leaders(Whereabouts where) {
        return inquiry.pairs().leaders(() -> oneByOne(where), inquiry::isOneLaw);
    }

    private List<Fitter.State> oneByOne(Whereabouts where) {
        List<Fitter.State> near = search.leaders(base, Effort.LEADERS, where);
        double unlisted = Calibration.unlisted(base.reduced() - 1);
        List<Fitter.State> all = new ArrayList<>(near);
        if (near.isEmpty() || near.get(0).reduced() - 1 > unlisted) {
            where.besideSensor(unlisted).ifPresent(farther -> all.addAll(search.leaders(base, Effort.LEADERS, farther)));
            all.sort(Comparator.comparingDouble(Fitter.State::reduced));
        }
        return all;
    }

    /** The diagnosis where more counts as noise, with hypotheses that were fitted without it fitted again. */
    private static Diagnosed judged(Inquiry knowing, List<Fitter.State> leaders) {
        return Conclusion.of(knowing, knowing.again(leaders));
    }
}
