package wbv.proof;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import wbv.proof.Marking.Mark;
import wbv.proof.Suite.Group;

/** What came of a proof, in tables. */
public final class Tables {

    private final List<Marking> all;

    Tables(List<Marking> all) {
        this.all = List.copyOf(all);
    }

    /** Every table, as Markdown. */
    public String markdown() {
        return summary() + mechanisms() + confusion() + others() + calibration() + parameters() + failures();
    }

    /** The figures that matter, as Markdown. */
    public String summary() {
        StringBuilder out = new StringBuilder("## Figures\n\n| what | reached | of |\n|---|---|---|\n");
        List<Marking> listed = group(Group.LISTED);
        rate(out, "mechanism and place, linear χ² ≥ 1.5", where(listed, m -> m.truth().linear() >= 1.5), m -> m.mark() == Mark.RIGHT);
        rate(out, "mechanism and place or a set with it, linear χ² ≥ 1.5", where(listed, m -> m.truth().linear() >= 1.5), Tables::good);
        rate(out, "mechanism and place or a set with it, linear χ² 1.05 to 1.5",
                where(listed, m -> m.truth().linear() >= 1.05 && m.truth().linear() < 1.5), Tables::good);
        rate(out, "right family at the right place, linear χ² ≥ 1.5", where(listed, m -> m.truth().linear() >= 1.5), Marking::family);
        rate(out, "right place, linear χ² ≥ 1.5", where(listed, m -> m.truth().linear() >= 1.5), Marking::place);
        rate(out, "wrong name held at 0.8 or more", listed, m -> m.mark() != Mark.RIGHT && m.mark() != Mark.IN_SET && m.held() >= 0.8);
        for (String setting : List.of("rig", "rotation", "field")) {
            rate(out, "mechanism and place or a set with it, linear χ² ≥ 1.5, " + setting,
                    where(listed, m -> m.truth().linear() >= 1.5 && m.truth().setting().equals(setting)), Tables::good);
        }
        rate(out, "false alarms on nulls (any name)", group(Group.NOTHING), m -> m.mark() == Mark.WRONG);
        rate(out, "nulls called unexplained", group(Group.NOTHING), m -> m.mark() == Mark.UNKNOWN);
        rate(out, "not in the library: called unknown, linear χ² ≥ 2", where(group(Group.UNLISTED), m -> m.truth().linear() >= 2),
                m -> m.mark() == Mark.RIGHT);
        rate(out, "not in the library: right place, linear χ² ≥ 2", where(group(Group.UNLISTED), m -> m.truth().linear() >= 2), Marking::place);
        rate(out, "pairs exact", group(Group.PAIR), m -> m.mark() == Mark.RIGHT);
        rate(out, "pairs with a spurious part", group(Group.PAIR), m -> m.spurious() > 0);
        List<Marking> right = where(listed, m -> m.mark() == Mark.RIGHT);
        rate(out, "held-out χ² ≤ 1.10 or ≥ 98 % of the excess removed, of those right", right,
                m -> m.answer().heldAfter() <= 1.1 || removed(m) >= 0.98);
        rate(out, "no answer", all, m -> m.mark() == Mark.FAILED);
        double[] seconds = all.stream().mapToDouble(m -> m.answer().seconds()).toArray();
        out.append(row("seconds for a diagnosis, median / 90 % / longest", String.format(Locale.ROOT, "%.1f / %.1f / %.1f",
                quantile(seconds, 0.5), quantile(seconds, 0.9), quantile(seconds, 1)), String.valueOf(all.size())));
        return out.append('\n').toString();
    }

    private String mechanisms() {
        StringBuilder out = new StringBuilder("## By mechanism\n\n| concealed | cases | right | in a set | elsewhere | wrong | unknown | silent "
                + "| place | linear χ² | held-out χ² before → after | excess removed |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
        for (double strength : new double[] {1, 0.3, 0.1}) {
            Map<String, List<Marking>> by = new TreeMap<>(where(group(Group.LISTED), m -> m.truth().strength() == strength).stream()
                    .collect(Collectors.groupingBy(m -> m.truth().concealed().get(0).mechanism())));
            by.forEach((mechanism, cases) -> {
                List<Marking> right = where(cases, m -> m.mark() == Mark.RIGHT);
                out.append(row(mechanism + " × " + plain(strength), String.valueOf(cases.size()), count(cases, Mark.RIGHT),
                        count(cases, Mark.IN_SET), count(cases, Mark.ELSEWHERE), count(cases, Mark.WRONG), count(cases, Mark.UNKNOWN),
                        count(cases, Mark.SILENT), String.valueOf(where(cases, Marking::place).size()), median(cases, m -> m.truth().linear()),
                        median(cases, m -> m.answer().heldBefore()) + " → " + median(cases, m -> m.answer().heldAfter()),
                        right.isEmpty() ? "" : median(right, m -> 100 * removed(m)) + " %"));
            });
        }
        return out.append('\n').toString();
    }

    /** What was answered for what. */
    private String confusion() {
        List<Marking> cases = where(all, m -> m.question().group() != Group.PAIR);
        Map<String, Map<String, Integer>> counts = new TreeMap<>();
        for (Marking m : cases) {
            String row = m.truth().concealed().isEmpty() ? "nothing" : m.truth().concealed().get(0).mechanism();
            counts.computeIfAbsent(row, r -> new TreeMap<>()).merge(answered(m), 1, Integer::sum);
        }
        StringBuilder out = new StringBuilder("## What was answered\n\n| concealed | answered first, with counts |\n|---|---|\n");
        counts.forEach((row, answers) -> out.append(row(row, answers.entrySet().stream()
                .sorted(Map.Entry.<String, Integer>comparingByValue().reversed())
                .map(e -> e.getKey() + " " + e.getValue()).collect(Collectors.joining(", ")))));
        return out.append('\n').toString();
    }

    static String answered(Marking m) {
        return switch (m.mark()) {
            case FAILED -> "(failed)";
            default -> m.answer().verdict().equals("unexplained") ? "(unknown)" : m.answer().missing().isEmpty() ? "(silent)"
                    : m.answer().missing().stream().map(Answer.Name::mechanism).collect(Collectors.joining(" + "));
        };
    }

    private String others() {
        StringBuilder out = new StringBuilder("## Not in the library, and pairs\n\n| concealed | answered | right | place | linear χ² |\n|---|---|---|---|---|\n");
        for (Marking m : where(all, m -> m.question().group() == Group.UNLISTED || m.question().group() == Group.PAIR)) {
            String concealed = m.truth().concealed().stream().map(c -> (m.question().group() == Group.PAIR ? c.mechanism() : c.form())
                    + " at " + c.where()).collect(Collectors.joining(" + "));
            out.append(row(concealed, said(m), m.mark().name().toLowerCase(Locale.ROOT), m.place() ? "yes" : "no", number(m.truth().linear())));
        }
        return out.append('\n').toString();
    }

    private String calibration() {
        double[] edges = {0, 0.5, 0.8, 0.9, 0.97, 1.0001};
        StringBuilder out = new StringBuilder("## Probabilities\n\n| held at | answers | mean | right |\n|---|---|---|---|\n");
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
            Answer.Name name = m.answer().missing().get(0);
            Estimates.of(truth, name).forEach(e -> errors.computeIfAbsent(truth.mechanism() + " " + e.key(), k -> new ArrayList<>())
                    .add(new double[] {Math.abs(e.found() / e.truth() - 1), Math.abs(e.found() - e.truth()) <= 2 * e.std() ? 1 : 0}));
        }
        StringBuilder out = new StringBuilder("## Parameters\n\n| parameter | answers | median error | worst | within 2 σ |\n|---|---|---|---|---|\n");
        errors.forEach((key, list) -> {
            double[] error = list.stream().mapToDouble(e -> 100 * e[0]).toArray();
            out.append(row(key, String.valueOf(list.size()), number(quantile(error, 0.5)) + " %", number(quantile(error, 1)) + " %",
                    String.format(Locale.ROOT, "%.0f %%", 100 * list.stream().mapToDouble(e -> e[1]).average().orElse(0))));
        });
        return out.append('\n').toString();
    }

    private String failures() {
        StringBuilder out = new StringBuilder("## Every answer that was not right\n\n"
                + "| case | setting | strength | linear χ² | concealed | answered | mark |\n|---|---|---|---|---|---|---|\n");
        for (Marking m : where(all, m -> m.mark() != Mark.RIGHT)) {
            String concealed = m.truth().concealed().isEmpty() ? "nothing" : m.truth().concealed().stream()
                    .map(c -> c.mechanism() + " at " + c.where() + " (" + c.form() + ")").collect(Collectors.joining(" + "));
            out.append(row(m.question().id(), m.truth().setting(), plain(m.truth().strength()), number(m.truth().linear()), concealed, said(m),
                    m.mark().name().toLowerCase(Locale.ROOT)));
        }
        return out.append('\n').toString();
    }

    private static String said(Marking m) {
        String names = m.answer().missing().stream().map(n -> n.mechanism() + " at " + n.where() + " (" + number(n.probability()) + ")")
                .collect(Collectors.joining(" + "));
        String latent = m.answer().latent().isEmpty() ? "" : " [" + m.answer().latent().get(0) + "]";
        String rival = m.answer().alternatives().isEmpty() ? "" : "; next " + m.answer().alternatives().get(0).mechanism() + " at "
                + m.answer().alternatives().get(0).where();
        return m.mark() == Mark.FAILED ? "failed: " + m.answer().sentence() : m.answer().verdict() + " " + names + latent + rival
                + String.format(Locale.ROOT, "; held-out %.3g → %.3g", m.answer().heldBefore(), m.answer().heldAfter());
    }

    /** The marks and figures of every case, as JSON. */
    public String json() {
        ObjectNode root = new ObjectMapper().createObjectNode();
        ArrayNode cases = root.putArray("cases");
        for (Marking m : all) {
            ObjectNode one = cases.addObject();
            one.put("case", m.question().id()).put("group", m.question().group().name().toLowerCase(Locale.ROOT))
                    .put("setting", m.truth().setting()).put("strength", m.truth().strength()).put("linear_chi2", m.truth().linear())
                    .put("mark", m.mark().name().toLowerCase(Locale.ROOT)).put("place", m.place()).put("held", m.held())
                    .put("verdict", m.answer().verdict()).put("before", m.answer().before()).put("after", m.answer().after())
                    .put("held_before", m.answer().heldBefore()).put("held_after", m.answer().heldAfter()).put("seconds", m.answer().seconds());
            ArrayNode concealed = one.putArray("concealed");
            m.truth().concealed().forEach(c -> concealed.add(c.mechanism() + "@" + c.where()));
            ArrayNode named = one.putArray("named");
            m.answer().missing().forEach(n -> named.add(n.mechanism() + "@" + n.where()));
        }
        return root.toPrettyString() + "\n";
    }

    /** A time for a person. */
    static String time(double seconds) {
        return seconds < 100 ? Math.round(seconds) + " s" : seconds < 6000 ? Math.round(seconds / 60) + " min"
                : String.format(Locale.ROOT, "%.1f h", seconds / 3600);
    }

    private static boolean good(Marking m) {
        return m.mark() == Mark.RIGHT || m.mark() == Mark.IN_SET;
    }

    private static double removed(Marking m) {
        return (m.answer().heldBefore() - m.answer().heldAfter()) / Math.max(1e-9, m.answer().heldBefore() - 1);
    }

    private List<Marking> group(Group group) {
        return where(all, m -> m.question().group() == group);
    }

    private static List<Marking> where(List<Marking> of, Predicate<Marking> test) {
        return of.stream().filter(test).toList();
    }

    private static void rate(StringBuilder out, String what, List<Marking> of, Predicate<Marking> test) {
        int good = where(of, test).size();
        out.append(row(what, of.isEmpty() ? "" : String.format(Locale.ROOT, "%d (%.0f %%)", good, 100.0 * good / of.size()),
                String.valueOf(of.size())));
    }

    private static String count(List<Marking> of, Mark mark) {
        long count = of.stream().filter(m -> m.mark() == mark).count();
        return count == 0 ? "" : String.valueOf(count);
    }

    private static String median(List<Marking> of, Function<Marking, Double> value) {
        double[] x = of.stream().mapToDouble(value::apply).filter(Double::isFinite).toArray();
        return x.length == 0 ? "" : number(quantile(x, 0.5));
    }

    private static double quantile(double[] x, double share) {
        double[] sorted = x.clone();
        Arrays.sort(sorted);
        return sorted.length == 0 ? Double.NaN : sorted[(int) Math.min(sorted.length - 1, share * sorted.length)];
    }

    private static String number(double x) {
        return String.format(Locale.ROOT, Math.abs(x) >= 1000 ? "%.0f" : "%.3g", x);
    }

    private static String plain(double x) {
        return new java.math.BigDecimal(String.format(Locale.ROOT, "%.2f", x)).stripTrailingZeros().toPlainString();
    }

    private static String row(String... cells) {
        return "| " + String.join(" | ", cells) + " |\n";
    }
}
