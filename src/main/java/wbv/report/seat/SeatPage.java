package wbv.report.seat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import wbv.control.SeatHardware;
import wbv.control.trial.Comparison;
import wbv.control.trial.ControllerFamily;
import wbv.control.trial.EarthMover;
import wbv.control.trial.Front;
import wbv.control.trial.Knowledge;
import wbv.control.trial.TrialResult;
import wbv.report.page.BarChart;
import wbv.report.page.Block;
import wbv.report.page.ChartAxis;
import wbv.report.page.HtmlWriter;
import wbv.report.page.Lead;
import wbv.report.page.LineChart;
import wbv.report.page.Page;
import wbv.report.page.Section;
import wbv.report.page.Series;
import wbv.report.page.Table;
import wbv.report.page.Text;
import wbv.report.page.XyChart;
import wbv.report.page.XySeries;
import wbv.result.Digits;
import wbv.result.OutputFolder;
import wbv.study.seat.SeatStudy;

/** What controllers make of a suspension seat: comfort over stroke, by floor, by sitter. */
public final class SeatPage {

    /** Sitters whose fronts are drawn on each floor. */
    private static final int DRAWN = 2;
    private static final String GROUP = "fronts";

    private final SeatStudy study;
    private final Comparison comparison;
    private final List<Comparison.Entrant> entrants;
    private final Map<String, String> provenance;

    private SeatPage(SeatStudy study, Map<String, String> provenance) {
        this.study = study;
        this.comparison = study.comparison();
        this.entrants = comparison.entrants();
        this.provenance = provenance;
    }

    /** Writes {@code report.html}. */
    public static void write(SeatStudy study, Map<String, String> provenance, OutputFolder out) throws IOException {
        HtmlWriter.write(new SeatPage(study, provenance).page(), out.file("report.html"));
    }

    private Page page() {
        List<Section> sections = new ArrayList<>(List.of(byFloor()));
        comparison.floors().forEach(on -> sections.add(floor(on)));
        sections.add(believed());
        sections.add(assumed());
        sections.add(new Section("Provenance", "The same options and version give the same results.", new Table("",
                List.of(Table.Column.words("What"), Table.Column.words("Value")),
                provenance.entrySet().stream().map(entry -> List.of(entry.getKey(), entry.getValue())).toList())));
        String riders = comparison.floors().get(0).sitters().size() == 1 ? comparison.floors().get(0).sitters().get(0).words()
                : comparison.floors().get(0).sitters().size() + " sitters";
        return new Page("Suspension seat", "simulated; " + riders, sections);
    }

    /** As many as colours can tell apart: those that know nobody, and the scheduled ones; the tables hold all. */
    private List<Comparison.Entrant> drawn() {
        return entrants.stream().filter(entrant -> entrant.knowledge() == Knowledge.SCHEDULED || entrant.family().knowledge().size() == 1)
                .toList();
    }

    private Section byFloor() {
        List<Block> blocks = new ArrayList<>(List.of(new Lead(study.sentence())));
        List<String> floors = comparison.floors().stream().map(on -> on.floor().word()).toList();
        List<BarChart.Bars> bars = new ArrayList<>();
        for (Comparison.Entrant entrant : drawn()) {
            bars.add(new BarChart.Bars(entrant.words(), comparison.floors().stream()
                    .mapToDouble(on -> on.mean(entrant).map(Front.AtStroke::seat).orElse(Double.NaN)).toArray(), bars.size() % 8));
        }
        blocks.add(
                new BarChart("SEAT at equal stroke, mean of all sitters", ChartAxis.linear("SEAT", "").within(0, Double.NaN), floors, bars,
                        "No bar: the controller needs more stroke than the skyhook at all its tunings. Fixed ones and oracles: below."));
        List<List<String>> rows = new ArrayList<>();
        for (Comparison.OnFloor on : comparison.floors()) {
            for (Comparison.Entrant entrant : entrants) {
                on.mean(entrant).ifPresent(
                        mean -> rows.add(List.of(on.floor().word(), SeatStudy.limit(on).isEmpty() ? "–" : "< " + SeatStudy.limit(on),
                                entrant.words(), Digits.rounded(mean.seat(), 3), Digits.rounded(mean.head(), 3),
                                Digits.rounded(1e3 * mean.strokeRms(), 1),
                                Digits.rounded(1e3 * mean.strokeMost(), 1), Digits.rounded(mean.stopHits(), 1),
                                Digits.rounded(mean.force(), 0), Digits.rounded(mean.power(), 1))));
            }
        }
        blocks.add(new Table("At equal stroke, r.m.s. of stroke and force; greatest stroke of all sitters, means of all else",
                List.of(Table.Column.words("Floor"),
                        Table.Column.numbers("Limit"), Table.Column.words("Controller"), Table.Column.numbers("SEAT"),
                        Table.Column.numbers("Head / floor"),
                        Table.Column.numbers("Stroke [mm]"), Table.Column.numbers("Greatest [mm]"), Table.Column.numbers("Stops"),
                        Table.Column.numbers("Force [N]"), Table.Column.numbers("Power [W]")),
                rows));
        for (ControllerFamily family : ControllerFamily.values()) {
            comparison.gain(family).ifPresent(gain -> blocks.add(new Text(gain.words(family) + ".")));
        }
        study.dampers().ifPresent(words -> blocks.add(new Text(words + ".")));
        return new Section("At equal stroke",
                "SEAT is the weighted r.m.s. acceleration (Wk) of the seat pan over that of the floor. More stroke buys comfort from "
                        + "any controller; so each is tuned to the stroke that a continuous skyhook needs which the middle sitter finds "
                        + "best.",
                blocks);
    }

    private Section floor(Comparison.OnFloor on) {
        List<Block> blocks = new ArrayList<>();
        for (Comparison.OnSitter sitter : on.sitters().subList(0, Math.min(DRAWN, on.sitters().size()))) {
            List<XySeries> series = new ArrayList<>();
            for (Comparison.Entrant entrant : drawn()) {
                List<TrialResult> points = sitter.front(entrant).points().stream().map(Front.Point::result)
                        .sorted(Comparator.comparingDouble(TrialResult::strokeRms)).toList();
                series.add(new XySeries(entrant.words(), points.stream().mapToDouble(r -> 1e3 * r.strokeRms()).toArray(),
                        points.stream().mapToDouble(TrialResult::seat).toArray(), XySeries.Style.LINE));
            }
            double most = series.stream().flatMapToDouble(each -> Arrays.stream(each.y())).max().orElse(1);
            series.add(
                    new XySeries("stroke given to all", new double[] {1e3 * sitter.stroke(), 1e3 * sitter.stroke()}, new double[] {0, most},
                            XySeries.Style.DASHED));
            blocks.add(new XyChart("SEAT over stroke: " + sitter.words(), ChartAxis.linear("stroke r.m.s.", "mm").within(0, Double.NaN),
                    ChartAxis.linear("SEAT", "").within(0, Double.NaN), series).grouped(GROUP + on.floor().word()));
        }
        blocks.add(new LineChart("Transmissibility, floor to seat pan, first sitter", ChartAxis.linear("frequency", "Hz"),
                ChartAxis.linear("|H1|", "").within(0, Double.NaN),
                on.transmissibility().stream().filter(each -> drawn().contains(each.entrant()))
                        .map(each -> Series.line(each.entrant().words(), each.frequency(), each.modulus())).toList())
                .noted("Each at the tuning that gives its least SEAT without reaching a stop. Gaps: frequencies at which the floor "
                        + "hardly shakes."));
        Optional<String> limit = on.floor() instanceof EarthMover mover ? Optional.of(Digits.significant(mover.limit(), 2))
                : Optional.empty();
        return new Section(on.floor().word(), on.floor().description() + ", " + Digits.rounded(on.floor().rms(), 2) + " m/s² r.m.s."
                + limit.map(value -> " A seat for it must stay below a SEAT of " + value + " (assumed).").orElse(""), blocks);
    }

    /** What scheduled controllers believed at the end of each ride, beside what is true. */
    private Section believed() {
        List<List<String>> rows = new ArrayList<>();
        for (Comparison.Entrant entrant : entrants) {
            if (entrant.knowledge() == Knowledge.SCHEDULED) {
                for (Comparison.OnFloor on : comparison.floors()) {
                    for (Comparison.OnSitter sitter : on.sitters()) {
                        TrialResult found = middle(sitter.front(entrant));
                        TrialResult fixed = middle(sitter.front(new Comparison.Entrant(entrant.family(), Knowledge.FIXED)));
                        TrialResult truth = middle(sitter.front(new Comparison.Entrant(entrant.family(), Knowledge.ORACLE)));
                        rows.add(List.of(on.floor().word(), sitter.words(), entrant.family().word(),
                                beside(found.mass(), truth.mass(), fixed.mass(), 1),
                                beside(found.frequency(), truth.frequency(), fixed.frequency(), 2),
                                beside(found.damping(), truth.damping(), fixed.damping(), 2)));
                    }
                }
            }
        }
        return new Section("What the estimators said",
                "Each cell: believed at the end of a ride at the middle tuning (as one mass on a spring it is; the "
                        + "middle sitter). Beliefs are drawn towards the middle sitter by how unsure they are.",
                rows.isEmpty() ? new Text("No controller that estimates took part.") : new Table("", List.of(Table.Column.words("Floor"),
                        Table.Column.words("Sitter"), Table.Column.words("Controller"), Table.Column.numbers("Carried mass [kg]"),
                        Table.Column.numbers("Natural frequency [Hz]"), Table.Column.numbers("Damping ratio")), rows));
    }

    private static TrialResult middle(Front front) {
        return front.points().get(front.points().size() / 2).result();
    }

    private static String beside(double found, double truth, double fixed, int decimals) {
        return Digits.rounded(found, decimals) + " (" + Digits.rounded(truth, decimals) + "; " + Digits.rounded(fixed, decimals) + ")";
    }

    private Section assumed() {
        SeatHardware seat = comparison.request().hardware();
        return new Section("What is assumed", "", new Text("Nobody was shaken for this. The seat: "
                + Digits.significant(seat.frameMass(), 3) + " kg on "
                + Digits.significant(seat.stiffness() / 1e3, 3) + " kN/m, friction of 40 N, stops at ± "
                + Digits.significant(1e3 * seat.stop(), 3)
                + " mm, a damper of " + Digits.significant(seat.leastDamping(), 3) + " to " + Digits.significant(seat.mostDamping(), 4)
                + " N·s/m or an actuator of ± " + Digits.significant(seat.mostForce(), 3) + " N, both "
                + Digits.significant(1e3 * seat.delay(), 2)
                + " ms late with a lag of " + Digits.significant(1e3 * seat.lag(), 2)
                + " ms. The person: the virtual rig's, seven bodies that soften, along z.\n\n"
                + "Spectra EM1 to EM9 are those of ISO 7096:2000 as a public implementation prints them (hvtestspectrum 1.1, HVLab HRV "
                + "Toolbox); the standard was not at hand, and its limits of SEAT are remembered, hence assumed. This is no test by ISO "
                + "7096 or ISO 10326-1, which ask for people on a shaker."));
    }
}
