package wbv.exposure;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.recording.inspect.Finding;
import wbv.recording.inspect.Inspection;
import wbv.recording.inspect.Severity;

/** What makes a measurement less than it looks. */
final class Remarks {

    private static final double SHORT = 180;
    /** Share of samples lost that is worth a word: of a simulated ride a tenth at random lowers a_w by 1 %, a fifth by 3 %. */
    private static final double MANY_LOST = 0.1;
    private static final double TOO_MANY_LOST = 0.3;
    private static final double FAST_ENOUGH = 200;

    private Remarks() {}

    /** Refuses channels that look to be in another unit: a verdict would be wrong by 9.81. */
    static void requireUnits(Inspection inspection, List<Channel> used) {
        for (Finding finding : inspection.findings()) {
            if (finding instanceof Finding.ImplausibleUnit unit && used.stream()
                    .anyMatch(channel -> channel.location().equals(unit.location()) && channel.quantity() == unit.quantity())) {
                throw DataFault.in(inspection.name(), unit.message() + "; " + unit.advice());
            }
        }
    }

    static List<Remark> of(Inspection inspection, String place, Map<SeatAxis, Vibration> axes, boolean boxcar,
            List<Channel> used, Optional<Remark> unit) {
        List<Remark> remarks = new ArrayList<>();
        unit.ifPresent(remarks::add);
        missingAxes(remarks, place, axes);
        place(remarks, place);
        lost(remarks, inspection, place, used);
        shocks(remarks, axes);
        inspection.findings().forEach(finding -> finding(remarks, finding, used));
        rate(remarks, inspection.clock().rate(), boxcar);
        if (inspection.duration() < SHORT) {
            remarks.add(new Remark(Severity.NOTE, "the recording lasts " + RoundedNumber.text(inspection.duration(), 3) + " s",
                    "short for a task of hours: measure three minutes or more, all that the task consists of"));
        }
        remarks.sort(Comparator.comparing(Remark::severity).reversed());
        return remarks;
    }

    private static void missingAxes(List<Remark> remarks, String place, Map<SeatAxis, Vibration> axes) {
        List<String> absent = Arrays.stream(SeatAxis.values()).filter(axis -> !axes.containsKey(axis))
                .map(axis -> String.valueOf(axis.letter())).toList();
        if (!absent.isEmpty()) {
            remarks.add(new Remark(axes.containsKey(SeatAxis.Z) ? Severity.WARNING : Severity.FAULT,
                    place + " was not measured along " + String.join(" and ", absent),
                    "the verdict is of the axes that were measured; the worst may be missing"));
        }
    }

    private static void place(List<Remark> remarks, String place) {
        if (!place.equals("seat")) {
            remarks.add(new Remark(Severity.WARNING, "measured at " + place + ", not on the seat",
                    "the exposure is that of one who sits there without a cushion"));
        }
    }

    private static void lost(List<Remark> remarks, Inspection inspection, String place, List<Channel> used) {
        long present = used.stream().filter(channel -> channel.location().equals(place))
                .mapToLong(channel -> inspection.summaries().get(channel).count()).min().orElse(0);
        double share = 1 - present / (double) inspection.samples();
        if (share > MANY_LOST) {
            boolean hopeless = share > TOO_MANY_LOST;
            remarks.add(new Remark(hopeless ? Severity.FAULT : Severity.WARNING,
                    RoundedNumber.text(100 * share, 2) + " % of the samples of " + place + " are missing",
                    hopeless ? "too many to be bridged: no value here can be relied on" : "the values are some percent too low"));
        }
    }

    private static void shocks(List<Remark> remarks, Map<SeatAxis, Vibration> axes) {
        String named = axes.entrySet().stream().filter(entry -> entry.getValue().shocks())
                .map(entry -> entry.getKey().letter() + " (crest factor " + RoundedNumber.text(entry.getValue().crestFactor(), 3)
                        + ", MTVV/a_w " + RoundedNumber.text(entry.getValue().mtvvRatio(), 3) + ", VDV/(a_w T^¼) "
                        + RoundedNumber.text(entry.getValue().vdvRatio(), 3) + ")")
                .collect(Collectors.joining(", "));
        if (!named.isEmpty()) {
            remarks.add(new Remark(Severity.WARNING, "shocks or changes of level along " + named
                    + "; limits 9, 1.5 and 1.75", "the r.m.s. belittles them (ISO 2631-1 6.3): judge by the dose too"));
        }
    }

    private static void rate(List<Remark> remarks, double rate, boolean boxcar) {
        CoveredBand band = CoveredBand.of(Weighting.WK, rate);
        if (band.lowerBound()) {
            remarks.add(new Remark(Severity.WARNING, "sampled at " + RoundedNumber.text(rate, 4) + " Hz: band " + band.words(),
                    "true values are as high or higher"));
        }
        if (rate < FAST_ENOUGH && !boxcar) {
            double third = Math.PI / 3;
            remarks.add(new Remark(Severity.NOTE,
                    "a sensor whose samples are means over the sampling period (Xsens MTw, DOT) lacks "
                            + RoundedNumber.text(100 * (1 - Math.sin(third) / third), 2) + " % at " + RoundedNumber.text(rate / 3, 3)
                            + " Hz",
                    "if yours is one, --boxcar undoes it"));
        }
    }

    /** Takes on a finding that concerns a channel that was used. */
    private static void finding(List<Remark> remarks, Finding finding, List<Channel> used) {
        Set<String> locations = used.stream().map(Channel::location).collect(Collectors.toSet());
        if (finding instanceof Finding.Clipped clipped) {
            if (used.contains(clipped.channel())) {
                remarks.add(new Remark(Severity.WARNING, clipped.message(),
                        "peaks are cut off: a_w, dose and crest factor are lower bounds"));
            }
        } else if (finding instanceof Finding.Spikes spikes) {
            if (used.contains(spikes.channel())) {
                remarks.add(new Remark(Severity.WARNING, spikes.message(), "not motion, yet they count: "
                        + (spikes.channel().quantity() == Quantity.ANGULAR_RATE ? "the rotation's part of comfort is too high"
                                : "dose, crest factor and MTVV are too high")));
            }
        } else if (finding instanceof Finding.GravityLeftIn gravity) {
            if (locations.contains(gravity.location())) {
                remarks.add(new Remark(Severity.NOTE, gravity.message(),
                        "it was taken out; what tilting leaves below 0.4 Hz hardly counts"));
            }
        } else if (finding instanceof Finding.ZeroRows zeroes) {
            if (locations.contains(zeroes.location())) {
                remarks.add(new Remark(zeroes.severity(), zeroes.message(), zeroes.leading() ? zeroes.advice()
                        : "they were treated as missing"));
            }
        } else if (concerns(finding, used, locations)) {
            remarks.add(new Remark(finding.severity(), finding.message(), finding.advice()));
        }
    }

    private static boolean concerns(Finding finding, List<Channel> used, Set<String> locations) {
        if (finding instanceof Finding.Missing missing) {
            return missing.channels().stream().anyMatch(used::contains);
        } else if (finding instanceof Finding.Stuck stuck) {
            return used.contains(stuck.channel());
        } else if (finding instanceof Finding.GrossBias bias) {
            return locations.contains(bias.location());
        } else if (finding instanceof Finding.GravityMissing gravity) {
            return locations.contains(gravity.location());
        } else if (finding instanceof Finding.ImplausibleUnit unit) {
            return locations.contains(unit.location());
        }
        return true; // of the recording as a whole
    }
}
