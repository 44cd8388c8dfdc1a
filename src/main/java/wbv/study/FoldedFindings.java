package wbv.study;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.Unit;
import wbv.recording.inspect.Finding;
import wbv.recording.inspect.Inspection;
import wbv.recording.inspect.Severity;
import wbv.result.Digits;
import wbv.signal.FrequencyResponse;

/** What is wrong with a recording, folded: one line a kind, however many sensors it befell. */
public final class FoldedFindings {

    private static final int MOST_NAMES = 4;
    /** Shares that differ by less than a quarter are told as one. */
    private static final double ALIKE = 1.25;
    /** Up to here nothing on a base moves a ninth or nine times as much: a seat resonates at 1 Hz or more, a sitter at 4 Hz [Hz]. */
    private static final double SLOW = 2;
    /** Bins that have to show it. */
    private static final int LEAST_SLOW = 3;

    private FoldedFindings() {}

    /**
     * What was found of one kind.
     *
     * @param message what was found, with its numbers
     * @param advice  what the reader can do about it; may be empty
     */
    public record Line(Severity severity, String message, String advice) {}

    /**
     * The findings on the whole recording and on the places used, gravest first.
     *
     * @param used locations
     */
    public static List<Line> of(Inspection seen, Set<String> used) {
        Map<String, List<Finding>> kinds = new LinkedHashMap<>();
        seen.findings().stream().filter(finding -> place(finding).map(used::contains).orElse(true))
                .sorted(Comparator.comparing(Finding::severity).reversed())
                .forEach(finding -> kinds.computeIfAbsent(finding.severity() + " " + finding.getClass().getName(),
                        kind -> new ArrayList<>()).add(finding));
        return kinds.values().stream().map(FoldedFindings::folded).toList();
    }

    /** All findings, one by one. */
    public static List<Line> each(Inspection seen) {
        return seen.findings().stream().map(FoldedFindings::single).toList();
    }

    /**
     * What a recording lacks or holds falsely of these channels, one line a kind with every count: gaps, samples that are missing or zero,
     * clipping, spikes, channels that stand still.
     *
     * @param used channels
     */
    public static List<Line> damage(Inspection seen, Set<Channel> used) {
        Map<Class<?>, List<Finding>> kinds = new LinkedHashMap<>();
        seen.findings().stream().filter(finding -> isDamage(finding, used))
                .forEach(finding -> kinds.computeIfAbsent(finding.getClass(), kind -> new ArrayList<>()).add(finding));
        return kinds.values().stream().map(same -> new Line(same.get(0).severity(),
                same.stream().limit(MOST_NAMES).map(Finding::message).collect(Collectors.joining("; "))
                        + (same.size() > MOST_NAMES ? "; and " + (same.size() - MOST_NAMES) + " more" : ""),
                same.get(0).advice())).toList();
    }

    /**
     * That one of two accelerations looks to be in g and the other in m/s²: a body moves with its base where that moves slowly, below all
     * resonances, and one ninth or nine times as much as none does.
     *
     * @param h from input to output
     */
    public static Optional<Line> units(Channel input, Channel output, FrequencyResponse h) {
        boolean[] usable = h.usable();
        double[] slow = IntStream.range(0, usable.length).filter(k -> usable[k] && h.frequency()[k] <= SLOW).limit(LEAST_SLOW)
                .mapToDouble(k -> h.h1().magnitude(k)).toArray();
        double mean = Math.exp(Arrays.stream(slow).map(Math::log).average().orElse(0));
        boolean alike = input.quantity() == Quantity.ACCELERATION && output.quantity() == Quantity.ACCELERATION
                && output.axis() == input.axis();
        boolean ninth = Math.abs(Math.abs(Math.log(mean)) - Math.log(Unit.STANDARD_GRAVITY)) < Math.log(ALIKE);
        return alike && slow.length == LEAST_SLOW && ninth
                ? Optional.of(new Line(Severity.WARNING,
                        output + " moves " + Digits.significant(mean, 2) + " times as much as " + input + " below "
                                + Digits.significant(SLOW, 1)
                                + " Hz, where all moves alike: one of the two looks to be in g; state the unit",
                        "behind the name in the header, " + output + " [g], or as \"units\" in the sidecar"))
                : Optional.empty();
    }

    private static boolean isDamage(Finding finding, Set<Channel> used) {
        if (finding instanceof Finding.Missing missing) {
            return missing.channels().stream().anyMatch(used::contains);
        } else if (finding instanceof Finding.ZeroRows zero) {
            return !zero.leading() && used.stream().anyMatch(channel -> channel.location().equals(zero.location()));
        }
        return finding instanceof Finding.Gap || finding instanceof Finding.DroppedPackets || channel(finding).filter(used::contains)
                .isPresent();
    }

    /** Where something was found; empty if it concerns the whole recording. */
    public static Optional<String> place(Finding finding) {
        if (finding instanceof Finding.Missing missing) {
            return Optional.of(missing.channels().get(0).location());
        } else if (finding instanceof Finding.ZeroRows zero) {
            return Optional.of(zero.location());
        } else if (finding instanceof Finding.GravityLeftIn gravity) {
            return Optional.of(gravity.location());
        } else if (finding instanceof Finding.GravityMissing gravity) {
            return Optional.of(gravity.location());
        } else if (finding instanceof Finding.GrossBias bias) {
            return Optional.of(bias.location());
        } else if (finding instanceof Finding.ImplausibleUnit unit) {
            return Optional.of(unit.location());
        }
        return channel(finding).map(Channel::location);
    }

    private static Optional<Channel> channel(Finding finding) {
        return finding instanceof Finding.Stuck stuck ? Optional.of(stuck.channel())
                : finding instanceof Finding.Clipped clipped ? Optional.of(clipped.channel())
                        : finding instanceof Finding.Spikes spikes ? Optional.of(spikes.channel()) : Optional.empty();
    }

    /** A finding at a place in a few words, which do not name the place. */
    public static String brief(Finding finding) {
        String which = channel(finding).map(each -> each.quantity().symbol() + "." + each.axis()).orElse("");
        if (finding instanceof Finding.Missing missing) {
            String who = missing.channels().size() == 1 ? missing.channels().get(0).quantity().symbol() + "."
                    + missing.channels().get(0).axis() + " " : "";
            return who + (missing.missing() == missing.rows() ? "holds no number" : percent(missing) + " % lost");
        } else if (finding instanceof Finding.Stuck stuck) {
            return which + (stuck.longest() >= stuck.rows() ? " never moves" : " stood still");
        } else if (finding instanceof Finding.Clipped clipped) {
            return which + " clipped (" + clipped.count() + ")";
        } else if (finding instanceof Finding.Spikes spikes) {
            return which + " spikes (" + spikes.count() + ")";
        } else if (finding instanceof Finding.ZeroRows zero) {
            return zero.leading() ? "zero at the start" : "zero in " + zero.count() + " rows";
        } else if (finding instanceof Finding.GravityLeftIn) {
            return "gravity left in";
        } else if (finding instanceof Finding.GravityMissing) {
            return "gravity removed already";
        } else if (finding instanceof Finding.GrossBias bias) {
            return bias.quantity().symbol() + " off by " + Digits.significant(bias.magnitude(), 2) + " " + bias.quantity().unit();
        } else if (finding instanceof Finding.ImplausibleUnit unit) {
            return unit.quantity().symbol() + " looks like " + unit.likely();
        }
        return finding.message();
    }

    private static String percent(Finding.Missing missing) {
        return Digits.significant(100.0 * missing.missing() / missing.rows(), 2);
    }

    private static Line single(Finding finding) {
        return new Line(finding.severity(), finding.message(), finding.advice());
    }

    /** One line for findings of one kind. */
    private static Line folded(List<Finding> same) {
        Finding first = same.get(0);
        if (same.size() == 1) {
            return single(first);
        }
        String message;
        if (same.stream().map(FoldedFindings::who).distinct().count() == 1) {
            message = same.stream().map(Finding::message).collect(Collectors.joining("; "));
        } else if (first instanceof Finding.Missing missing) {
            message = missing.missing() == missing.rows() ? named(same, "hold no number at all") : lost(same);
        } else if (first instanceof Finding.Stuck) {
            boolean never = same.stream().map(Finding.Stuck.class::cast).allMatch(each -> each.longest() >= each.rows());
            message = named(same, never ? "never move" : "stand still");
        } else if (first instanceof Finding.Clipped) {
            message = named(same, "stay at an extreme value: clipped");
        } else if (first instanceof Finding.Spikes) {
            message = named(same, "jump out and back within one sample");
        } else if (first instanceof Finding.ZeroRows) {
            message = named(same, "are exactly zero in some rows");
        } else if (first instanceof Finding.GravityLeftIn) {
            message = named(same, "have gravity left in");
        } else if (first instanceof Finding.GravityMissing) {
            message = named(same, "have no gravity where it should be");
        } else if (first instanceof Finding.GrossBias) {
            message = named(same, "have a gross bias");
        } else if (first instanceof Finding.ImplausibleUnit) {
            List<String> likely = same.stream().map(each -> ((Finding.ImplausibleUnit) each).likely()).distinct().toList();
            message = named(same, likely.size() > 1 ? "seem to be in another unit" : "look like " + likely.get(0));
        } else {
            throw new IllegalStateException("of the whole recording: " + first);
        }
        return new Line(first.severity(), message, first.advice());
    }

    /** Several places that lack samples. */
    private static String lost(List<Finding> same) {
        List<Finding.Missing> all = same.stream().map(Finding.Missing.class::cast).toList();
        Comparator<Finding.Missing> share = Comparator.comparingDouble(each -> each.missing() / (double) each.rows());
        Finding.Missing least = all.stream().min(share).orElseThrow();
        Finding.Missing most = all.stream().max(share).orElseThrow();
        long places = all.stream().map(each -> each.channels().get(0).location()).distinct().count();
        double low = 100.0 * least.missing() / least.rows();
        double high = 100.0 * most.missing() / most.rows();
        boolean alike = high <= ALIKE * low;
        String who = places > 1 ? places + " sensors" : all.size() + " channels of " + most.channels().get(0).location();
        return who + " lack " + (alike ? Digits.significant((low + high) / 2, 2)
                : Digits.significant(low, 2) + " to " + Digits.significant(high, 2)) + " % of their samples"
                + (alike || places == 1 ? "" : ", " + most.channels().get(0).location() + " most");
    }

    /** Whom it befell: a channel where it is of one, else a place; empty if the whole recording. */
    private static String who(Finding finding) {
        if (finding instanceof Finding.Missing missing && missing.channels().size() == 1) {
            return missing.channels().get(0).toString();
        }
        return channel(finding).map(Channel::toString).or(() -> place(finding)).orElse("");
    }

    /** Whom the same befell, by channel where it is one of channels, else by place. */
    private static String named(List<Finding> same, String what) {
        Set<String> who = same.stream().map(FoldedFindings::who).collect(Collectors.toCollection(LinkedHashSet::new));
        String thing = channel(same.get(0)).isPresent() ? " channels " : " sensors ";
        List<String> shown = who.stream().limit(who.size() <= MOST_NAMES + 1 ? who.size() : MOST_NAMES).toList();
        return who.size() + thing + what + ": " + String.join(", ", shown)
                + (shown.size() < who.size() ? " and " + (who.size() - shown.size()) + " more" : "");
    }
}
