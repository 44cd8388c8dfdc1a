package wbv.diagnosis.learn;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.IntStream;
import wbv.body.simulate.ModulatorSeries;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.fit.Slot;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.search.Combination;
import wbv.diagnosis.search.Effort;
import wbv.diagnosis.search.Screening;

/**
 * Proposes laws for a link: which terms of a grammar, along the motion as measured, add up to what a model leaves of a recording
 * (orthogonal matching pursuit: Pati, Rezaiifar and Krishnaprasad 1993). Beside every term go the deflection and the speed of the link
 * themselves, since its stiffness and its damping are known no better than the law.
 */
final class Sentences {

    private final Fitter.State state;
    private final TermColumns columns;
    private final int link;
    private final Vocabulary words;
    private final List<Hypothesis> likely = new ArrayList<>();

    /**
     * @param state where terms are scored, with its derivatives
     * @param motion measured, of the model there
     * @param modulators along it
     * @param words among which terms are chosen
     */
    Sentences(Evidence evidence, Fitter.State state, Motion motion, ModulatorSeries modulators, int link, Vocabulary words) {
        this.state = state;
        this.words = words;
        this.link = link;
        this.columns = new TermColumns(new Screening(evidence, state, motion, modulators), state.candidate(), motion, link);
    }

    /**
     * A law as it is proposed.
     *
     * @param terms   of which it is the sum
     * @param values of their numbers, by term
     * @param stiffness by how much the link's own changes beside it [N/m]
     * @param damping likewise [N s/m]
     * @param worth   by how much it gains more than chance may make it gain, to first order [nat]
     * @param left    mean square of the whitened residual that it leaves to first order [1]
     */
    record Proposal(List<Hypothesis> terms, List<double[]> values, double stiffness, double damping, double worth, double left) {

        String kind() {
            return terms.stream().map(Hypothesis::form).sorted().toList().toString();
        }
    }

    /**
     * Proposals, most worth first, no two of the same kinds of terms.
     *
     * @param most terms of each at most
     * @param variant another form of a term, tried where it is among the first
     */
    List<Proposal> of(List<Hypothesis> terms, int most, Function<Hypothesis, Optional<Hypothesis>> variant) {
        likely.clear();
        List<TermColumns.Column> all = new ArrayList<>();
        List<TermColumns.Column> firsts = new ArrayList<>();
        columns.likeliest(terms).forEach(starts -> {
            firsts.add(starts.get(0));
            all.addAll(starts);   // beside another term a term may begin elsewhere
            likely.add(starts.get(0).term());
        });
        List<Proposal> out = new ArrayList<>(firsts.stream().skip(Effort.FIRST_TERMS).map(first -> proposal(List.of(first))).toList());
        for (TermColumns.Column first : Parallel.map(firsts.subList(0, Math.min(Effort.FIRST_TERMS, firsts.size())),
                first -> columns.varied(columns.refined(first), variant))) {
            List<TermColumns.Column> chosen = new ArrayList<>(List.of(first));
            out.add(proposal(chosen));
            while (chosen.size() < most) {
                Combination known = TermColumns.combined(chosen);
                TermColumns.Column found = all.stream()
                        .filter(column -> chosen.stream().noneMatch(other -> other.term() == column.term()))
                        .max(Comparator.comparingDouble(column -> TermColumns.with(known, column).gain())).orElse(first);
                if (found == first) {
                    break;
                }
                chosen.add(found);
                out.add(proposal(chosen));
            }
        }
        out.sort(Comparator.comparingDouble(Proposal::worth).reversed());
        Set<String> kinds = new HashSet<>();
        return out.stream().filter(proposal -> kinds.add(proposal.kind())).toList();
    }

    /** Terms that gain anything worth mentioning, most first, of those last asked for. */
    List<Hypothesis> likely() {
        return List.copyOf(likely);
    }

    private Proposal proposal(List<TermColumns.Column> chosen) {
        Combination combination = TermColumns.combined(chosen);
        double[] strength = combination.strengths();
        double gain = combination.gain();
        List<double[]> values = new ArrayList<>();
        int next = TermColumns.LINEAR;
        for (TermColumns.Column column : chosen) {
            int from = next;
            next += column.start().columns().size();
            values.add(Screening.sized(column.term(), column.start(), Arrays.copyOfRange(strength, from, next)));
        }
        List<Hypothesis> terms = chosen.stream().map(TermColumns.Column::term).toList();
        double degrees = state.frame().whitening().degrees();
        double left = (state.square() - gain) / degrees;
        return new Proposal(terms, values, strength[0], strength[1],
                gain / (2 * Math.max(1, left)) - Sentence.chance(words, terms, degrees), left);
    }

    /**
     * Coordinates of a candidate that holds the terms of a proposal, from which it is fitted: those of the state where terms were scored,
     * and their own.
     */
    double[] start(Proposal proposal, Candidate with) {
        Candidate own = state.candidate();
        double[] x = Arrays.copyOf(state.x(), with.knobs().size());
        move(own, x, Slot.of(Slot.Kind.STIFFNESS, link), proposal.stiffness());
        move(own, x, Slot.of(Slot.Kind.DAMPING, link), proposal.damping());
        for (int t = 0; t < proposal.terms().size(); t++) {
            int[] at = with.positions(proposal.terms().get(t));
            for (int i = 0; i < at.length; i++) {
                x[at[i]] = with.knobs().get(at[i]).coordinate(proposal.values().get(t)[i]);
            }
        }
        return x;
    }

    private static void move(Candidate candidate, double[] x, Slot slot, double by) {
        IntStream.range(0, candidate.knobs().size()).filter(i -> candidate.knobs().get(i).slot().equals(slot)).forEach(i -> {
            Knob knob = candidate.knobs().get(i);
            double value = knob.value(x[i]) + by;
            // A link that would push where it was held keeps a little of what it had.
            x[i] = knob.coordinate(knob.unit() == 0 ? Math.max(value, 0.1 * knob.value(x[i])) : value);
        });
    }
}
