package wbv.diagnosis.learn;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Start;
import wbv.diagnosis.search.Combination;
import wbv.diagnosis.search.Effort;
import wbv.diagnosis.search.PartialledOut;
import wbv.diagnosis.search.Screening;

/** What terms of a link do to the residual, to first order, each at its starts, beside the link's own deflection and speed. */
final class TermColumns {

    /** Columns of the link's own, which come before those of terms. */
    static final int LINEAR = 2;
    /** Times that a number is moved to where its term gains more. */
    private static final int ROUNDS = 4;
    /** Terms that are looked at before those are left out that gain less than others: an effort, so many parts as keep processors busy. */
    private static final int AT_ONCE = 64;
    /** Of those, terms whose directions are multiplied with the errors' at once, so many that it pays: an effort. */
    private static final int TOGETHER = 4;

    private final Screening screening;
    private final Candidate on;
    private final Combination linear;

    /**
     * Of a link.
     *
     * @param on     what terms are to stand on
     * @param motion measured
     */
    TermColumns(Screening screening, Candidate on, Motion motion, int link) {
        this.screening = screening;
        this.on = on;
        this.linear = Combination.of(screening.left()
                .of(List.of(screening.directions().of(link, motion.displacement(link)),
                        screening.directions().of(link, motion.velocity(link)))));
    }

    /**
     * A term at a start.
     *
     * @param beside what its amplitudes do, after the link's own stiffness and damping
     * @param gain   of it alone, beside these [1]
     */
    record Column(Hypothesis term, Start start, Combination beside, double gain) {

        int numbers() {
            return beside.numbersAfter(LINEAR);
        }
    }

    /**
     * Terms that gain anything worth mentioning, most first, each at its starts, of which the one that gains most is the first. Of a long
     * recording no more are kept than memory holds.
     */
    List<List<Column>> likeliest(List<Hypothesis> terms) {
        List<List<Column>> kept = new ArrayList<>();
        for (List<Hypothesis> some : parts(terms, AT_ONCE)) {
            Parallel.map(parts(some, TOGETHER), this::columns).stream().flatMap(List::stream)
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

    private static List<List<Hypothesis>> parts(List<Hypothesis> terms, int length) {
        return IntStream.iterate(0, from -> from < terms.size(), from -> from + length)
                .mapToObj(from -> terms.subList(from, Math.min(from + length, terms.size()))).toList();
    }

    /** Each of some terms at each of its starts, the one that gains most first. */
    private List<List<Column>> columns(List<Hypothesis> terms) {
        List<double[]> directions = terms.stream().flatMap(term -> term.starts().stream().flatMap(start -> directions(term, start)))
                .toList();
        Iterator<PartialledOut.Rest> rests = screening.left().of(directions).iterator();
        return terms.stream().map(term -> term.starts().stream().flatMap(start -> column(term, start, rests).stream())
                .sorted(Comparator.comparingDouble(Column::gain).reversed()).toList()).toList();
    }

    private Stream<double[]> directions(Hypothesis term, Start start) {
        return IntStream.range(0, start.columns().size())
                .mapToObj(column -> screening.directions().of(term, on.with(term), Screening.alone(term, start, column)));
    }

    /** @param next what is left of its directions, and then of others'. Modified. */
    private Optional<Column> column(Hypothesis term, Start start, Iterator<PartialledOut.Rest> next) {
        List<PartialledOut.Rest> rests = start.columns().stream().map(column -> next.next()).toList();
        return rests.stream().anyMatch(PartialledOut.Rest::isOld) ? Optional.empty()
                : Optional.of(linear.with(Combination.of(rests), 0)).map(all -> new Column(term, start, all, all.gain() - linear.gain()));
    }

    private Optional<Column> column(Hypothesis term, Start start) {
        return column(term, start, screening.left().of(directions(term, start).toList()).iterator());
    }

    /** A term, or the form of it that gains more. */
    Column varied(Column column, Function<Hypothesis, Optional<Hypothesis>> variant) {
        return Stream
                .concat(Stream.of(column), variant.apply(column.term()).stream().flatMap(term -> columns(List.of(term)).get(0).stream()))
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
                Start there = new Start(values, best.start().columns());
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

    /** What the amplitudes of some terms do, at least one, after the link's own stiffness and damping. */
    static Combination combined(List<Column> chosen) {
        Combination all = chosen.get(0).beside();
        for (Column more : chosen.subList(1, chosen.size())) {
            all = with(all, more);
        }
        return all;
    }

    /** A combination that begins with the link's own stiffness and damping, with what a term's amplitudes do after it. */
    static Combination with(Combination chosen, Column more) {
        return chosen.with(more.beside(), LINEAR);
    }
}
