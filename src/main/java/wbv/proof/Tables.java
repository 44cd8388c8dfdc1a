package wbv.proof;

import static wbv.proof.MarkdownCells.head;
import static wbv.proof.MarkdownCells.median;
import static wbv.proof.MarkdownCells.number;
import static wbv.proof.MarkdownCells.plain;
import static wbv.proof.MarkdownCells.quantile;
import static wbv.proof.MarkdownCells.row;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import wbv.diagnosis.search.Calibration;
import wbv.proof.Marking.Mark;
import wbv.proof.Suite.Group;

/** What came of a proof, in tables. */
public final class Tables {

    private final Map<String, String> made;
    private final List<Marking> all;

    /** @param made how the proof was made, for whoever wants to repeat it */
    Tables(Map<String, String> made, List<Marking> all) {
        this.made = made;
        this.all = List.copyOf(all);
    }

    /** What the answers say of how well a right formula fits; empty where none does. */
    public Optional<Calibration> calibration() {
        return Calibrating.of(all, made.getOrDefault("command", ""), made.getOrDefault("wbv", ""));
    }

    /** Every table, as Markdown. */
    public String markdown() {
        if (!all.isEmpty() && group(Group.UNRELATED).size() == all.size()) {
            return origin() + summary() + failures();
        }
        boolean sitters = all.isEmpty() || all.stream().anyMatch(m -> !m.question().group().isMixed());
        return origin() + summary() + mixed()
                + (sitters ? mechanisms() + confusion() + others() + open() + reliability() + parameters() + failures() : "");
    }

    /** The figures that matter, as Markdown. */
    public String summary() {
        return new ProofFigures(all).markdown();
    }

    private String origin() {
        return made.entrySet().stream().map(e -> "- " + e.getKey() + ": " + e.getValue() + "\n").collect(Collectors.joining("",
                "", "\n"));
    }

    private String mechanisms() {
        StringBuilder out = new StringBuilder(head("By mechanism", "concealed", "cases", "right", "in a set", "elsewhere",
                "wrong", "unknown",
                "silent", "place", "linear χ²", "held-out χ² before → after", "excess removed"));
        for (double strength : new double[] {1, 0.3, 0.1}) {
            Map<String, List<Marking>> by = new TreeMap<>(where(group(Group.LISTED), m -> m.truth().strength() == strength).stream()
                    .collect(Collectors.groupingBy(m -> m.truth().concealed().get(0).mechanism())));
            by.forEach((mechanism, cases) -> {
                List<Marking> right = where(cases, m -> m.mark() == Mark.RIGHT);
                out.append(row(mechanism + " × " + plain(strength), String.valueOf(cases.size()), count(cases, Mark.RIGHT),
                        count(cases, Mark.IN_SET), count(cases, Mark.ELSEWHERE), count(cases, Mark.WRONG), count(cases,
                                Mark.UNKNOWN),
                        count(cases, Mark.SILENT), String.valueOf(where(cases, Marking::place).size()),
                        median(cases, m -> m.truth().linear()),
                        median(cases, m -> m.answer().heldBefore()) + " → " + median(cases, m -> m.answer().heldAfter()),
                        right.isEmpty() ? "" : median(right, m -> 100 * m.removed()) + " %"));
            });
        }
        return out.append('\n').toString();
    }

    /** What was answered for what. */
    private String confusion() {
        List<Marking> cases = where(all, m -> m.question().group() != Group.PAIR);
        Map<String, Map<String, Integer>> counts = new TreeMap<>();
        for (Marking m : cases) {
            String row = m.truth().concealed().isEmpty() ? "nothing" : m.question().group() == Group.OPEN
                    ? m.question().spec().words().get(0) : m.truth().concealed().get(0).mechanism();
            counts.computeIfAbsent(row, r -> new TreeMap<>()).merge(answered(m), 1, Integer::sum);
        }
        StringBuilder out = new StringBuilder(head("What was answered", "concealed", "answered first, with counts"));
        counts.forEach((row, answers) -> out.append(row(row, answers.entrySet().stream()
                .sorted(Map.Entry.<String, Integer>comparingByValue().reversed())
                .map(e -> e.getKey() + " " + e.getValue()).collect(Collectors.joining(", ")))));
        return out.append('\n').toString();
    }

    static String answered(Marking m) {
        return switch (m.mark()) {
            case FAILED -> "(failed)";
            default -> Marking.refused(m.answer()) ? "(unknown)" : m.answer().missing().isEmpty() ? "(silent)"
                    : m.answer().missing().stream().map(ProofAnswer.Name::mechanism).collect(Collectors.joining(" + "));
        };
    }

    private String others() {
        StringBuilder out = new StringBuilder(head("Not in the library, and pairs", "concealed", "answered", "mark", "place",
                "linear χ²"));
        for (Marking m : where(all, m -> m.question().group() == Group.UNLISTED || m.question().group() == Group.PAIR)) {
            String concealed = m.truth().concealed().stream().map(c -> (m.question().group() == Group.PAIR ? c.mechanism()
                    : c.form())
                    + " at " + c.where()).collect(Collectors.joining(" + "));
            out.append(row(concealed, said(m), m.mark().name().toLowerCase(Locale.ROOT), m.place() ? "yes" : "no",
                    number(m.truth().linear())));
        }
        return out.append('\n').toString();
    }

    /** Laws that were to be learned, each answer. */
    private String open() {
        if (group(Group.OPEN).isEmpty()) {
            return "";
        }
        StringBuilder out = new StringBuilder(head("Open laws", "concealed", "answered", "mark", "place", "linear χ²", "excess removed",
                "correlation of the force", "right terms"));
        for (Marking m : group(Group.OPEN)) {
            out.append(row(
                    m.question().spec().words().get(0) + " × " + plain(m.truth().strength()) + " at "
                            + m.truth().concealed().get(0).where(),
                    said(m), m.mark().name().toLowerCase(Locale.ROOT), m.place() ? "yes" : "no", number(m.truth().linear()),
                    Double.isFinite(m.removed()) ? number(100 * m.removed()) + " %" : "",
                    Double.isFinite(m.correlation()) ? number(m.correlation()) : "",
                    m.terms().map(right -> right ? "yes" : "no").orElse("")));
        }
        return out.append('\n').toString();
    }

    /** Benches, planar people and levels, each answer. */
    private String mixed() {
        StringBuilder out = new StringBuilder();
        for (Group group : Group.values()) {
            if (group.isMixed() && !group(group).isEmpty()) {
                out.append(head("Every " + group.name().toLowerCase(Locale.ROOT) + " case", "case", "concealed", "answered", "mark",
                        "place", "linear χ²", "seconds"));
                for (Marking m : group(group)) {
                    out.append(row(m.question().id(), concealed(m) + ", " + m.truth().setting(), said(m),
                            m.mark().name().toLowerCase(Locale.ROOT),
                            m.truth().concealed().isEmpty() ? "" : m.place() ? "yes" : "no", number(m.truth().linear()),
                            number(m.answer().seconds())));
                }
                out.append('\n');
            }
        }
        return out.toString();
    }

    private static String concealed(Marking m) {
        return m.question().group() == Group.UNRELATED ? m.question().spec().words().get(0)
                : m.truth().concealed().isEmpty()
                        ? m.question().group().isMixed() ? m.question().spec().exact() ? "nothing, values exact" : "nothing, values off"
                                : "nothing"
                        : m.truth().concealed().stream().map(c -> c.mechanism() + " at " + c.where() + " (" + c.form() + ")")
                                .collect(Collectors.joining(" + "));
    }

    private String reliability() {
        double[] edges = {0, 0.5, 0.8, 0.9, 0.97, 1.0001};
        StringBuilder out = new StringBuilder(head("Probabilities", "held at", "answers", "median", "right"));
        for (int i = 0; i + 1 < edges.length; i++) {
            double low = edges[i];
            double high = edges[i + 1];
            List<Marking> in = where(all, m -> m.question().group() != Group.PAIR && m.held() >= low && m.held() < high);
            long right = in.stream().filter(m -> m.question().group() != Group.NOTHING && m.parts() > 0).count();
            out.append(row(plain(low) + " to " + plain(Math.min(1, high)), String.valueOf(in.size()), median(in, Marking::held),
                    in.isEmpty() ? "" : String.format(Locale.ROOT, "%.0f %%", 100.0 * right / in.size())));
        }
        return out.append('\n').toString();
    }

    /** Errors of parameters that truth and answer mean alike. */
    private String parameters() {
        Map<String, List<double[]>> errors = new TreeMap<>();
        for (Marking m : where(group(Group.LISTED), m -> m.mark() == Mark.RIGHT)) {
            Truth.Concealed truth = m.truth().concealed().get(0);
            ProofAnswer.Name name = m.answer().missing().get(0);
            Estimates.of(truth, name).forEach(e -> errors.computeIfAbsent(truth.mechanism() + " " + e.key(), k -> new ArrayList<>())
                    .add(new double[] {Math.abs(e.found() / e.truth() - 1), e.covers() ? 1 : 0}));
        }
        StringBuilder out = new StringBuilder(head("Parameters", "parameter", "answers", "median error", "worst", "inside the interval"));
        errors.forEach((key, list) -> {
            double[] error = list.stream().mapToDouble(e -> 100 * e[0]).toArray();
            out.append(row(key, String.valueOf(list.size()), number(quantile(error, 0.5)) + " %", number(quantile(error, 1))
                    + " %",
                    String.format(Locale.ROOT, "%.0f %%", 100 * list.stream().mapToDouble(e -> e[1]).average().orElse(0))));
        });
        return out.append('\n').toString();
    }

    private String failures() {
        StringBuilder out = new StringBuilder(head("Every answer that was not right", "case", "setting", "strength", "linear χ²",
                "concealed", "answered",
                "mark"));
        for (Marking m : where(all, m -> m.mark() != Mark.RIGHT && !m.question().group().isMixed())) {
            out.append(row(m.question().id(), m.truth().setting(), plain(m.truth().strength()), number(m.truth().linear()),
                    concealed(m), said(m),
                    m.mark().name().toLowerCase(Locale.ROOT)));
        }
        return out.append('\n').toString();
    }

    private static String said(Marking m) {
        String names = m.answer().missing().stream().map(n -> n.mechanism() + " at " + n.where() + " (" + number(n.probability())
                + ")")
                .collect(Collectors.joining(" + "));
        String latent = m.answer().latent().isEmpty() ? "" : " [" + m.answer().latent().get(0) + "]";
        String rival = m.answer().alternatives().isEmpty() ? "" : "; next " + m.answer().alternatives().get(0).mechanism()
                + " at "
                + m.answer().alternatives().get(0).where();
        return m.mark() == Mark.FAILED ? "failed: " + m.answer().sentence() : m.answer().verdict() + " " + names + latent + rival
                + String.format(Locale.ROOT, "; held-out %.3g → %.3g", m.answer().heldBefore(), m.answer().heldAfter());
    }

    /** The marks and figures of every case, as JSON. */
    public String json() {
        ObjectNode root = new ObjectMapper().createObjectNode();
        ObjectNode origin = root.putObject("made");
        made.forEach(origin::put);
        ArrayNode cases = root.putArray("cases");
        for (Marking m : all) {
            ObjectNode one = cases.addObject();
            one.put("case", m.question().id()).put("group", m.question().group().name().toLowerCase(Locale.ROOT))
                    .put("setting", m.truth().setting()).put("strength", m.truth().strength()).put("linear_chi2",
                            m.truth().linear())
                    .put("mark", m.mark().name().toLowerCase(Locale.ROOT)).put("place", m.place()).put("held", m.held())
                    .put("verdict", m.answer().verdict()).put("before", m.answer().before()).put("after", m.answer().after())
                    .put("held_before", m.answer().heldBefore()).put("held_after", m.answer().heldAfter()).put("seconds",
                            m.answer().seconds());
            if (m.question().kind() == Group.OPEN) {
                one.put("law", m.question().spec().words().get(0)).put("removed", m.removed()).put("correlation", m.correlation());
                m.terms().ifPresent(right -> one.put("right_terms", right));
            }
            ArrayNode concealed = one.putArray("concealed");
            m.truth().concealed().forEach(c -> concealed.add(c.mechanism() + "@" + c.where()));
            ArrayNode named = one.putArray("named");
            m.answer().missing().forEach(n -> named.add(n.mechanism() + "@" + n.where()));
        }
        return root.toPrettyString() + "\n";
    }

    private List<Marking> group(Group group) {
        return where(all, m -> m.question().group() == group);
    }

    private static List<Marking> where(List<Marking> of, Predicate<Marking> test) {
        return of.stream().filter(test).toList();
    }

    private static String count(List<Marking> of, Mark mark) {
        long count = of.stream().filter(m -> m.mark() == mark).count();
        return count == 0 ? "" : String.valueOf(count);
    }
}
