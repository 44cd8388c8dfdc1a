package wbv.proof;

import static wbv.proof.MarkdownCells.quantile;
import static wbv.proof.MarkdownCells.row;

import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import wbv.proof.Marking.Mark;
import wbv.proof.Suite.Group;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Setting;

/** The figures by which the diagnosis is judged. */
final class ProofFigures {

    /** From here on a mismatch is plain, measured as mean square over the noise. */
    private static final double PLAIN = 1.5;
    /** From here on it could be seen. */
    private static final double SEEN = 1.05;
    private static final double UNLISTED = 2;
    private static final double SURE = 0.8;
    private static final double AT_NOISE = 1.1;
    private static final double REMOVED = 0.98;
    private static final double MOST_REMOVED = 0.9;
    /** From here on two forces are one, as a correlation. */
    private static final double ALIKE = 0.95;

    private final List<Marking> all;
    private final StringBuilder out = new StringBuilder(MarkdownCells.head("Figures", "what", "reached", "of"));

    ProofFigures(List<Marking> all) {
        this.all = all;
    }

    String markdown() {
        return all.isEmpty() || group(Group.UNRELATED).size() < all.size() ? found() : control();
    }

    /** What was said of recordings whose outputs have nothing to do with their input. */
    private String control() {
        for (String kind : ConcealedSpec.UNRELATED.stream().distinct().toList()) {
            List<Marking> of = where(all, m -> m.question().spec().words().contains(kind));
            line(kind + ": nothing is missing, or only values", of, m -> m.mark() == Mark.SILENT);
            line(kind + ": any mechanism named", of, m -> m.mark() == Mark.WRONG);
            line(kind + ": refused, with the reason, before any diagnosis", of, m -> m.answer().verdict().equals(ProofAnswer.REFUSED));
            line(kind + ": cannot tell, with the reason", of, m -> m.answer().verdict().equals("cannot-tell"));
            line(kind + ": unexplained", of, m -> m.answer().verdict().equals("unexplained"));
        }
        line("all: nothing is missing, or only values", all, m -> m.mark() == Mark.SILENT);
        line("all: any mechanism named", all, m -> m.mark() == Mark.WRONG);
        line("no answer", all, m -> m.mark() == Mark.FAILED);
        return out.append('\n').toString();
    }

    private String found() {
        if (all.isEmpty() || all.stream().anyMatch(m -> !m.question().group().isMixed())) {
            sitters();
        }
        for (Group group : Group.values()) {
            if (group.isMixed() && !group(group).isEmpty()) {
                mixed(group.name().toLowerCase(Locale.ROOT), group(group));
            }
        }
        line("no answer", all, m -> m.mark() == Mark.FAILED);
        double[] seconds = all.stream().mapToDouble(m -> m.answer().seconds()).toArray();
        out.append(row("seconds for a diagnosis, median / 90 % / longest", String.format(Locale.ROOT, "%.1f / %.1f / %.1f",
                quantile(seconds, 0.5), quantile(seconds, 0.9), quantile(seconds, 1)), String.valueOf(all.size())));
        return out.append('\n').toString();
    }

    /** What was said of benches, of planar people or of levels. */
    private void mixed(String name, List<Marking> of) {
        List<Marking> listed = where(of, m -> m.question().kind() == Group.LISTED);
        List<Marking> laws = where(listed, m -> !m.question().spec().words().get(0).startsWith("sensor."));
        List<Marking> faults = where(listed, m -> m.question().spec().words().get(0).startsWith("sensor."));
        List<Marking> nulls = where(of, m -> m.question().kind() == Group.NOTHING);
        List<Marking> open = where(of, m -> m.question().kind() == Group.OPEN);
        line(name + ": mechanism and place", listed, m -> m.mark() == Mark.RIGHT);
        line(name + ": mechanism and place or a set with it", listed, Marking::good);
        line(name + ": mechanism and place or a set with it, laws", laws, Marking::good);
        line(name + ": mechanism and place or a set with it, sensors", faults, Marking::good);
        line(name + ": right place", listed, Marking::place);
        line(name + ": wrong name held at 0.8 or more", listed, m -> !m.good() && m.held() >= SURE);
        line(name + ": held-out χ² ≤ 1.10 or ≥ 98 % of the excess removed, of those right", where(listed, m -> m.mark() == Mark.RIGHT),
                m -> m.answer().heldAfter() <= AT_NOISE || m.removed() >= REMOVED);
        for (boolean exact : List.of(true, false)) {
            List<Marking> some = where(nulls, m -> m.question().spec().exact() == exact);
            line(name + ": alarms on nulls, values " + (exact ? "exact" : "off"), some, m -> m.mark() == Mark.WRONG);
            line(name + ": quiet nulls, values " + (exact ? "exact" : "off"), some, m -> m.mark() == Mark.RIGHT);
        }
        if (!open.isEmpty()) {
            line(name + ": not in the library, called so", open, m -> m.mark() == Mark.RIGHT);
            line(name + ": not in the library, a law was learned", open, m -> Marking.learned(m.answer()));
            line(name + ": not in the library, right place", open, Marking::place);
            line(name + ": not in the library, 90 % or more of the held-out excess removed", open, m -> m.removed() >= MOST_REMOVED);
        }
        List<Marking> forces = where(open, m -> m.question().spec().hasForce());
        if (!forces.isEmpty()) {
            line(name + ": not in the library, force correlated with the concealed one by 0.95 or more", forces,
                    m -> m.correlation() >= ALIKE);
        }
        line(name + ": refused or no answer", of, m -> m.mark() == Mark.FAILED);
    }

    private void sitters() {
        List<Marking> listed = group(Group.LISTED);
        List<Marking> plain = where(listed, m -> m.truth().linear() >= PLAIN);
        List<Marking> faint = where(listed, m -> m.truth().linear() >= SEEN && m.truth().linear() < PLAIN);
        line("mechanism and place, linear χ² ≥ 1.5", plain, m -> m.mark() == Mark.RIGHT);
        line("mechanism and place or a set with it, linear χ² ≥ 1.5", plain, Marking::good);
        line("mechanism and place or a set with it, linear χ² 1.05 to 1.5", faint, Marking::good);
        line("right family at the right place, linear χ² ≥ 1.5", plain, Marking::family);
        line("right place, linear χ² ≥ 1.5", plain, Marking::place);
        line("mechanism and place, held-out χ² of the linear model ≥ 1.5", where(listed, m -> m.answer().heldBefore() >= PLAIN),
                m -> m.mark() == Mark.RIGHT);
        line("mechanism and place or a set with it, held-out χ² of the linear model 1.05 to 1.5",
                where(listed, m -> m.answer().heldBefore() >= SEEN && m.answer().heldBefore() < PLAIN), Marking::good);
        line("wrong name held at 0.8 or more", listed, m -> !m.good() && m.held() >= SURE);
        for (Setting setting : List.of(Setting.RIG, Setting.ROTATION, Setting.FIELD)) {
            line("mechanism and place or a set with it, linear χ² ≥ 1.5, " + setting.word(),
                    where(plain, m -> m.truth().setting().equals(setting.word())), Marking::good);
        }
        line("false alarms on nulls (any name)", group(Group.NOTHING), m -> m.mark() == Mark.WRONG);
        line("nulls called unexplained", group(Group.NOTHING), m -> m.mark() == Mark.UNKNOWN);
        line("nulls told apart: values wrong, or not even they", group(Group.NOTHING),
                m -> m.answer().verdict().equals(m.question().spec().exact() ? "nothing-missing" : "parameters-only"));
        List<Marking> unlisted = where(group(Group.UNLISTED), m -> m.truth().linear() >= UNLISTED);
        line("not in the library: called unknown, linear χ² ≥ 2", unlisted, m -> m.mark() == Mark.RIGHT);
        line("not in the library: right place, linear χ² ≥ 2", unlisted, Marking::place);
        line("not in the library: called unknown, held-out χ² of the linear model ≥ 2",
                where(group(Group.UNLISTED), m -> m.answer().heldBefore() >= UNLISTED), m -> m.mark() == Mark.RIGHT);
        open(group(Group.OPEN));
        line("pairs exact", group(Group.PAIR), m -> m.mark() == Mark.RIGHT);
        line("pairs exact, linear χ² ≥ 1.5 for each of the two", where(group(Group.PAIR),
                m -> m.truth().concealed().stream().allMatch(c -> c.linear() >= PLAIN)), m -> m.mark() == Mark.RIGHT);
        line("pairs with a spurious part", group(Group.PAIR), m -> m.spurious() > 0);
        line("held-out χ² ≤ 1.10 or ≥ 98 % of the excess removed, of those right", where(listed, m -> m.mark() == Mark.RIGHT),
                m -> m.answer().heldAfter() <= AT_NOISE || m.removed() >= REMOVED);
        List<Estimates.Estimate> estimates = where(listed, m -> m.mark() == Mark.RIGHT).stream()
                .flatMap(m -> Estimates.of(m.truth().concealed().get(0), m.answer().missing().get(0)).stream()).toList();
        covered("parameter inside its 95 % interval, formula as in the library",
                estimates.stream().filter(Estimates.Estimate::form).toList());
        covered("parameter inside its 95 % interval, another formula of the same name", estimates.stream().filter(e -> !e.form())
                .toList());
    }

    /** Laws that were to be learned. */
    private void open(List<Marking> open) {
        if (open.isEmpty()) {
            return;
        }
        line("open laws: called not in the library", open, m -> m.mark() == Mark.RIGHT);
        line("open laws: called not in the library, held-out χ² of the linear model ≥ 2",
                where(open, m -> m.answer().heldBefore() >= UNLISTED), m -> m.mark() == Mark.RIGHT);
        line("open laws: a law was learned", open, m -> Marking.learned(m.answer()));
        line("open laws: right place", open, Marking::place);
        out.append(row("open laws: held-out excess removed, median", MarkdownCells.median(open, m -> 100 * m.removed()) + " %",
                String.valueOf(open.size())));
        line("open laws: 90 % or more of the held-out excess removed", open, m -> m.removed() >= MOST_REMOVED);
        line("open laws: force correlated with the concealed one by 0.95 or more", open, m -> m.correlation() >= ALIKE);
        line("open laws: held under a name of the library at 0.8 or more", open, m -> m.held() >= SURE);
        line("open laws: right terms, where both sides say them", where(open, m -> m.terms().isPresent()), m -> m.terms().orElse(false));
    }

    private void line(String what, List<Marking> of, Predicate<Marking> test) {
        out.append(row(what, MarkdownCells.rate(of, test), String.valueOf(of.size())));
    }

    private void covered(String what, List<Estimates.Estimate> of) {
        out.append(row(what, MarkdownCells.rate(of, Estimates.Estimate::covers), String.valueOf(of.size())));
    }

    private List<Marking> group(Group group) {
        return where(all, m -> m.question().group() == group);
    }

    private static List<Marking> where(List<Marking> of, Predicate<Marking> test) {
        return of.stream().filter(test).toList();
    }
}
