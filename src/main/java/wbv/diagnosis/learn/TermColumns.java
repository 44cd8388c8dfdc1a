package wbv.diagnosis.learn;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.search.Effort;
import wbv.diagnosis.search.PartialledOut;
import wbv.diagnosis.search.Screening;

/** What terms of a link do to the residual, to first order, each at its starts, beside the link's own deflection and speed. */
final class TermColumns {

    /** Columns of the link's own, which come before those of terms. */
    static final int LINEAR = 2;
    /** Times that a number is moved to where its term gains more. */
    private static final int ROUNDS = 4;
    /** Terms that are looked at before those are left out that gain less than others. */
    private static final int AT_ONCE = 32;

    private final Screening screening;
    private final Candidate on;
    private final List<PartialledOut.Rest> linear;

    /**
     * Of a link.
     *
     * @param on     what terms are to stand on
     * @param motion measured
     */
    TermColumns(Screening screening, Candidate on, Motion motion, int link) {
        this.screening = screening;
        this.on = on;
        this.linear = List.of(screening.left().of(screening.direction(link, motion.displacement(link))),
                screening.left().of(screening.direction(link, motion.velocity(link))));
    }

    /**
     * A term at a start.
     *
     * @param columns what its amplitudes do
     * @param gain    of it alone, beside the link's own stiffness and damping [1]
     */
    record Column(Hypothesis term, Hypothesis.Start start, List<PartialledOut.Rest> columns, double gain) {

        int numbers() {
            return columns.stream().mapToInt(column -> column.direction().length).sum();
        }
    }

    /**
     * Terms that gain anything worth mentioning, most first, each at its starts, of which the one that gains most is the first. Of a long
     * recording no more are kept than memory holds.
     */
    List<List<Column>> likeliest(List<Hypothesis> terms) {
        List<List<Column>> kept = new ArrayList<>();
        for (int from = 0; from < terms.size(); from += AT_ONCE) {
            Parallel.map(terms.subList(from, Math.min(from + AT_ONCE, terms.size())), this::columns).stream()
                    .filter(starts -> !starts.isEmpty() && starts.get(0).gain() > 0).forEach(kept::add);
            kept.sort(Comparator.comparingDouble((List<Column> starts) -> starts.get(0).gain()).reversed());
            int numbers = 0;
            int most = 0;
            while (most < Math.min(Effort.NEXT_TERMS, kept.size()) && numbers <= Effort.NUMBERS) {
                numbers += kept.get(most).stream().mapToInt(Column::numbers).sum();
                most++;
            }
            kept.subList(most, kept.size()).clear();
        }
        return kept;
    }

    /** A term at each of its starts, the one that gains most first. */
    private List<Column> columns(Hypothesis term) {
        List<Column> out = new ArrayList<>();
        for (Hypothesis.Start start : term.starts()) {
            column(term, start).ifPresent(out::add);
        }
        out.sort(Comparator.comparingDouble(Column::gain).reversed());
        return out;
    }

    private Optional<Column> column(Hypothesis term, Hypothesis.Start start) {
        List<PartialledOut.Rest> rests = start.columns().stream()
                .map(column -> screening.left().of(screening.direction(term, on.with(term),
                        only(start, column))))
                .toList();
        if (rests.stream().anyMatch(PartialledOut.Rest::isOld)) {
            return Optional.empty();
        }
        return Optional.of(new Column(term, start, rests, gain(List.of(new Column(term, start, rests, 0))) - gain(List.of())));
    }

    /** A term, or the form of it that gains more. */
    Column varied(Column column, Function<Hypothesis, Optional<Hypothesis>> variant) {
        return Stream.concat(Stream.of(column), variant.apply(column.term()).stream().flatMap(term -> columns(term).stream()))
                .max(Comparator.comparingDouble(Column::gain)).orElseThrow();
    }

    /** A term whose last number, a frequency, a moment or a knee, is moved from its start to where it gains most. */
    Column refined(Column column) {
        double[] starts = column.term().starts().stream().mapToDouble(start -> start.values()[start.values().length - 1]).sorted()
                .toArray();
        if (starts.length < 2) {
            return column;
        }
        Column best = column;
        double reach = (starts[starts.length - 1] - starts[0]) / (starts.length - 1);
        for (int round = 0; round < ROUNDS; round++, reach /= 2) {
            for (double by : new double[] {-reach / 2, reach / 2}) {
                double[] values = best.start().values().clone();
                values[values.length - 1] += by;
                Hypothesis.Start there = new Hypothesis.Start(values, best.start().columns());
                Hypothesis term = column.term();
                Hypothesis.Number number = term.numbers().get(values.length - 1);
                if (values[values.length - 1] > number.low() && values[values.length - 1] < number.high()) {
                    Column known = best;
                    best = column(term, there).filter(tried -> tried.gain() > known.gain()).orElse(known);
                }
            }
        }
        return best;
    }

    private static double[] only(Hypothesis.Start start, int[] column) {
        double[] values = start.values().clone();
        start.columns().stream().filter(other -> other != column).forEach(other -> Arrays.stream(other).forEach(i -> values[i] = 0));
        return values;
    }

    /** Of the best combination of them, beside the link's own stiffness and damping [1]. */
    double gain(List<Column> chosen) {
        List<PartialledOut.Rest> rests = rests(chosen);
        return PartialledOut.combined(rests, new double[rests.size()]);
    }

    /** What is left of the link's own stiffness and damping, and then of their amplitudes. */
    List<PartialledOut.Rest> rests(List<Column> chosen) {
        List<PartialledOut.Rest> out = new ArrayList<>(linear);
        chosen.forEach(column -> out.addAll(column.columns()));
        return out;
    }
}
