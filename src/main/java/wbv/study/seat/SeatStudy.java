package wbv.study.seat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.DoubleConsumer;
import java.util.stream.Collectors;
import wbv.control.trial.Comparison;
import wbv.control.trial.ControllerFamily;
import wbv.control.trial.EarthMover;
import wbv.control.trial.Front;
import wbv.control.trial.Knowledge;
import wbv.result.Digits;
import wbv.result.OutputFolder;
import wbv.result.ResultsJson;

/** Controllers of a suspension seat compared, for people and machines. */
public final class SeatStudy {

    private final Comparison comparison;
    private final SeatResults results;

    private SeatStudy(Comparison comparison, SeatResults results) {
        this.comparison = comparison;
        this.results = results;
    }

    /** Runs a comparison and writes {@code seat.json}. */
    public static SeatStudy run(Comparison.Request request, Map<String, String> provenance, OutputFolder out, DoubleConsumer progress)
            throws IOException {
        Comparison comparison = Comparison.run(request, progress);
        SeatStudy study = new SeatStudy(comparison, SeatResults.of(comparison, provenance));
        ResultsJson.write(study.results, out.file("seat.json"));
        return study;
    }

    /** What was ridden. */
    public Comparison comparison() {
        return comparison;
    }

    /** The same for machines. */
    public SeatResults results() {
        return results;
    }

    /** The limit of SEAT of a floor as words, empty for one that has none. */
    public static String limit(Comparison.OnFloor on) {
        return on.floor() instanceof EarthMover mover ? Digits.significant(mover.limit(), 2) : "";
    }

    /** One line on what the comparison says. */
    public String sentence() {
        Comparison.OnFloor first = comparison.floors().get(0);
        Comparison.Entrant best = comparison.entrants().stream()
                .filter(entrant -> entrant.knowledge() != Knowledge.ORACLE && first.mean(entrant).isPresent())
                .min(Comparator.comparingDouble(entrant -> first.mean(entrant).orElseThrow().seat())).orElseThrow();
        double skyhook = first.mean(Comparison.SKYHOOK).orElseThrow().seat();
        return String.format(Locale.ROOT,
                "On %s, with the stroke that a skyhook takes, the least SEAT is %.2f (%s); the skyhook's is %.2f. Simulated.",
                first.floor().word(), first.mean(best).orElseThrow().seat(), best.words(), skyhook);
    }

    /** One line on which controller to give a damper; none where there is no choice. */
    public Optional<String> dampers() {
        if (comparison.entrants().stream().map(Comparison.Entrant::family).filter(ControllerFamily::setsDamper).distinct().count() < 2) {
            return Optional.empty();
        }
        Map<String, List<String>> floors = new TreeMap<>();
        comparison.floors().forEach(on -> floors.computeIfAbsent(on.damper().word(), word -> new ArrayList<>()).add(on.floor().word()));
        return Optional.of("A damper does best under the middle sitter with "
                + floors.entrySet().stream().map(entry -> entry.getKey() + " (" + String.join(", ", entry.getValue()) + ")")
                        .collect(Collectors.joining(", "))
                + "; chosen so: " + comparison.dampersBesideSkyhook().words());
    }

    /** A table for the terminal. */
    public String summary() {
        StringBuilder text = new StringBuilder();
        for (Comparison.OnFloor on : comparison.floors()) {
            String limit = limit(on);
            text.append(String.format(Locale.ROOT, "%s, %s: %.2f m/s² r.m.s.; %d sitter%s, %.0f s each, simulated%s%n", on.floor().word(),
                    on.floor().description(), on.floor().rms(), on.sitters().size(), on.sitters().size() == 1 ? "" : "s",
                    comparison.request().seconds(), limit.isEmpty() ? "" : "; SEAT must be below " + limit + " (assumed)"));
            text.append(
                    String.format(Locale.ROOT, "  %-26s %6s %6s %9s %9s %6s %6s%n", "at equal stroke, means", "SEAT", "head", "r.m.s. mm",
                            "most mm", "stops",
                            "W"));
            for (Comparison.Entrant entrant : comparison.entrants()) {
                Optional<Front.AtStroke> mean = on.mean(entrant);
                text.append(mean.isEmpty() ? String.format(Locale.ROOT, "  %-26s needs more stroke%n", entrant.words())
                        : String.format(Locale.ROOT, "  %-26s %6.3f %6.3f %9.1f %9.1f %6.1f %6.1f%s%n", entrant.words(), mean.get().seat(),
                                mean.get().head(),
                                1e3 * mean.get().strokeRms(), 1e3 * mean.get().strokeMost(), mean.get().stopHits(), mean.get().power(),
                                on.within(entrant) == on.sitters().size() ? ""
                                        : "  for " + on.within(entrant) + " of " + on.sitters().size() + " sitters"));
            }
        }
        for (ControllerFamily family : ControllerFamily.values()) {
            comparison.gain(family).ifPresent(gain -> text.append(gain.words(family)).append(System.lineSeparator()));
            if (family != ControllerFamily.SKYHOOK && comparison.entrants().stream().anyMatch(entrant -> entrant.family() == family)) {
                text.append(family.word()).append(": ").append(comparison.besideSkyhook(family).words()).append(System.lineSeparator());
            }
        }
        dampers().ifPresent(words -> text.append(words).append(System.lineSeparator()));
        return text.toString().replace(System.lineSeparator(), "\n");
    }
}
