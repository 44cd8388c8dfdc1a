package wbv.diagnosis;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.law.Learned;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Slot;
import wbv.diagnosis.fit.Window;
import wbv.diagnosis.measured.SmallError;
import wbv.diagnosis.mechanism.ParameterError;
import wbv.diagnosis.search.Fits;
import wbv.diagnosis.search.MassScale;
import wbv.diagnosis.search.Priors;
import wbv.diagnosis.search.Refinement;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/** What is said of a verdict, in a sentence. */
final class VerdictWords {

    /** Others that are told beside what was found. */
    static final int RIVALS = 5;
    private static final Set<Slot.Kind> NUMBERS = Set.of(Slot.Kind.STIFFNESS, Slot.Kind.DAMPING, Slot.Kind.MASS);

    /** What is told as more than 0 %. */
    static final double LEAST_SHOWN = 0.005;

    private final Evidence evidence;
    private final Fitter.State given;
    private final Fitter.State base;
    private final double heldBefore;
    private final MassScale scale;

    /**
     * @param heldBefore what the fitted model leaves on data not used
     * @param scale of its masses
     */
    VerdictWords(Fits fits, double heldBefore, MassScale scale) {
        this.evidence = fits.evidence();
        this.given = fits.given();
        this.base = fits.base();
        this.heldBefore = heldBefore;
        this.scale = scale;
    }

    /**
     * How a sentence ends that names something.
     *
     * @param share of the mismatch that it explains
     * @param numbers how likely the model's own numbers are with it [nat]
     */
    String ending(double share, double numbers, List<Diagnosis.Named> rivals) {
        return "; explains " + Phrases.percent(share) + " of the mismatch"
                + shown(rivals).findFirst().map(rival -> nextBest(rival, numbers)).orElse("") + ".";
    }

    /** Those that explain something of a mismatch, if there is one: the others are told nowhere, and nothing need settle them. */
    Stream<Diagnosis.Named> shown(List<Diagnosis.Named> rivals) {
        return rivals.stream()
                .filter(rival -> base.reduced() <= Priors.SILENT || Refinement.explained(base, rival.reduced()) >= LEAST_SHOWN);
    }

    /** A rival, and why it is one no longer, or one at all, where only the model's own numbers speak against it or for it. */
    private String nextBest(Diagnosis.Named rival, double numbers) {
        double odds = rival.numbers() - numbers;
        boolean open = rival.probability() > 1 - Priors.HELD;
        String own = odds < Math.log(Priors.ODDS) ? ", with stiffness or damping far from what was given"
                : open && odds > -Math.log(Priors.ODDS) ? ", with stiffness or damping nearer to what was given" : "";
        String name = rival.mechanism().equals(Learned.MECHANISM) ? "a law of no library" : rival.mechanism();
        return "; next best " + name + " at " + rival.where() + ", "
                + Phrases.percent(Refinement.explained(base, rival.reduced())) + own;
    }

    /**
     * How a sentence ends that names what the model's numbers imitate.
     *
     * @param numbers those that do
     */
    String imitating(Diagnosis.Named numbers) {
        String key = numbers.parameters().keySet().iterator().next();
        return String.format(Locale.ROOT, "; with values alone, %s of %s at %.3g, data that were not used are less likely.", key,
                numbers.where(), numbers.parameters().get(key));
    }

    /** @param rivals what else it may be, likeliest first */
    String sentence(Diagnosis.Verdict verdict, List<Diagnosis.Named> missing, List<Diagnosis.Named> rivals, String ending, boolean untold) {
        String found = found(missing);
        return switch (verdict) {
            case NOTHING_MISSING -> String.format(Locale.ROOT,
                    "Nothing is missing: the model as given leaves %.2f times the noise%s", given.reduced(), ending);
            case PARAMETERS_ONLY -> String.format(Locale.ROOT,
                    "No physics is missing; with fitted values the model leaves %.2f times the noise instead of %.3g times%s",
                    base.reduced(), given.reduced(), ending)
                    + (alike().isEmpty() ? new WrongNumbers(evidence, base, scale).words() : alike());
            case CANNOT_TELL -> "Cannot tell whether anything is missing: " + ending;
            case UNEXPLAINED -> String.format(Locale.ROOT,
                    "Something is missing (%.3g times the noise), and nothing in the library explains it%s", base.reduced(), ending);
            case LEARNED_LAW -> throw new IllegalStateException("a law that was learned has a sentence of its own");
            case AMBIGUOUS -> found + ending + apart(missing, rivals) + pushed();
            case MISSING_PHYSICS -> found + (untold ? ". Whether more is missing cannot be told: " : "") + ending + pushed();
        };
    }

    /** What errors hold where models are simulated with a force that nobody measured. */
    private String pushed() {
        return evidence.excitation().isPushed()
                ? " Errors are those of the model with that force, as this recording shows it: the model alone foretells none." : "";
    }

    private String found(List<Diagnosis.Named> missing) {
        return missing.stream().map(named -> Phrases.of(evidence.library(), named))
                .reduce((first, next) -> first + " and " + next.substring(0, 1).toLowerCase(Locale.ROOT) + next.substring(1)).orElse("");
    }

    /**
     * What the recording does not tell from what was found: of the names that are not told apart by their odds the one that explains most,
     * as far as it explains any; where noise is all that is left in any case, the likeliest.
     */
    private String apart(List<Diagnosis.Named> missing, List<Diagnosis.Named> rivals) {
        double least = Priors.ODDS * missing.stream().mapToDouble(Diagnosis.Named::probability).min().orElse(1);
        boolean quiet = base.reduced() <= Priors.SILENT;
        Optional<Diagnosis.Named> nearest = shown(rivals).filter(rival -> rival.probability() > least)
                .max(Comparator.comparingDouble(
                        rival -> quiet ? rival.probability() : Refinement.explained(base, rival.reduced())));
        return nearest.map(rival -> rival.mechanism().equals(new ParameterError().word())
                ? " The recording does not tell it from wrong values alone." : rival.equals(rivals.get(0))
                        ? " The recording does not tell the two apart."
                        : " The recording does not tell it from " + rival.mechanism() + " at "
                                + rival.where()
                                + (quiet ? "." : ", which explains " + Phrases.percent(Refinement.explained(base, rival.reduced())) + "."))
                .orElse(" No other name explains any of it, and this one leaves too much to be sure.");
    }

    /**
     * Where one measured force pushes and all numbers are off alike, the force's channel may as well be: the motion knows a force only over
     * them.
     */
    private String alike() {
        double[] off = IntStream.range(0, base.x().length).filter(i -> NUMBERS.contains(base.candidate().knobs().get(i).slot().kind()))
                .mapToDouble(i -> base.x()[i]).toArray();
        double mean = Arrays.stream(off).average().orElse(0);
        double usual = SmallError.MOST * SmallError.Kind.GAIN.deviation();
        boolean all = off.length > 1 && Math.abs(mean) > usual && Arrays.stream(off).allMatch(each -> Math.abs(each - mean) < usual);
        return evidence.model().inputs().size() == 1 && all
                && evidence.outputs().stream().noneMatch(output -> output.quantity() == Quantity.FORCE)
                        ? String.format(Locale.ROOT,
                                " All its numbers are %1$.3g times as given: they may as well be right as given, and %2$s read %1$.3g "
                                        + "times the force; the recording cannot tell.",
                                Math.exp(mean), evidence.model().inputs().get(0).sensor())
                        : "";
    }

    String cannotTell(String why) {
        double rate = evidence.recording().clock().rate();
        Window fit = evidence.fit();
        Window held = evidence.heldOut();
        return String.format(Locale.ROOT,
                "the model leaves %.3g times the noise from %.0f to %.0f s, to which it was fitted, and %.3g times from %.0f to %.0f s: "
                        + "%s.",
                base.reduced(),
                fit.start() / rate, (fit.start() + fit.length()) / rate, heldBefore, held.start() / rate,
                (held.start() + held.length()) / rate, why);
    }

    /**
     * Where the input does not move what was measured, neither what fits nor what does not says anything of the model.
     *
     * @param caused part of the best output
     */
    String notCaused(double caused) {
        return String.format(Locale.ROOT,
                "on data not used, %s explains %s of what the best of the sensors measured, whatever the model's numbers; at least "
                        + "%.0f %% is needed.",
                evidence.model().excitations().get(0), caused > 0 ? Phrases.percent(caused) : "nothing", 100 * Priors.MAJORITY);
    }

    /**
     * Where whatever is missing enters, to end a sentence.
     *
     * @param places best first; none where outputs do not tell
     */
    String entering(List<Diagnosis.Latent> places) {
        return places.isEmpty() ? "."
                : String.format(Locale.ROOT, "; an arbitrary signal at the %s %s would leave %.3g times.", places.get(0).kind(),
                        places.get(0).where(), places.get(0).reduced());
    }

    /**
     * What comes nearest where no name is the answer, a sentence of its own.
     *
     * @param explained part of the mismatch [1]
     * @param after what it leaves on data not used
     */
    String nearest(List<Diagnosis.Named> named, double explained, double after) {
        return nearest(named, explained) + ", " + Phrases.percent(Math.max(0, (heldBefore - after) / Math.max(heldBefore - 1, 1e-9)))
                + " on data not used.";
    }

    private String nearest(List<Diagnosis.Named> named, double explained) {
        return " Nearest in the library: " + found(named) + "; explains " + Phrases.percent(explained) + " of the mismatch";
    }

    /** What nearly says the same as a law that was learned, a sentence of its own; empty where nothing in the library does. */
    String resembling(List<Diagnosis.Named> named) {
        double explained = named.stream().mapToDouble(one -> Refinement.explained(base, one.reduced())).min().orElse(0);
        return explained > Priors.NEARLY_ALL ? nearest(named, explained) + "." : "";
    }

    /** What the noise holds beside that of sensors, to end a sentence. */
    String counting() {
        if (!evidence.heard().isEmpty()) {
            return " (" + evidence.heard().entrySet().stream().sorted(Map.Entry.comparingByKey(Comparator.comparing(Channel::toString)))
                    .map(noise -> String.format(Locale.ROOT, "%.2g %s of %s", noise.getValue(), noise.getKey().quantity().unit(),
                            noise.getKey()))
                    .collect(Collectors.joining(", ")) + " count as noise).";
        }
        return evidence.acting().own()
                .map(force -> String.format(Locale.ROOT, " (%.2g N rms of the sitter's own force on %s count as noise).",
                        scale.factor() * force.rms(), evidence.model().bodies().get(force.body()).name()))
                .orElse(".");
    }
}
