package wbv.report.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Quantity;
import wbv.recording.inspect.Finding;
import wbv.recording.inspect.Inspection;
import wbv.recording.inspect.Severity;
import wbv.recording.inspect.Summary;
import wbv.recording.inspect.Timing;
import wbv.report.page.SensorFigure;
import wbv.report.page.Tiles;
import wbv.study.FoldedFindings;

class FoldedFindingsTest {

    private static final List<String> PLACES = List.of("platform", "seat", "pelvis", "lumbar", "sternum", "head", "left_thigh",
            "right_thigh", "left_shoulder", "right_shoulder");

    private static Inspection inspection(List<Finding> findings) {
        Map<Channel, Summary> summaries = new LinkedHashMap<>();
        PLACES.forEach(place -> summaries.put(Channel.parse(place + ".acc.z"), new Summary(8900, 100, 0, 1, -3, 3)));
        return new Inspection("ride", 9000, 9000, new Clock(0, 60), new Timing(0, 1 / 60.0, 0, 1e-6, 0, false), summaries, findings);
    }

    private static List<Finding> lost(int... each) {
        List<Finding> findings = new ArrayList<>();
        for (int i = 0; i < each.length; i++) {
            String place = PLACES.get(i);
            findings.add(new Finding.Missing(List.of(Channel.parse(place + ".acc.x"), Channel.parse(place + ".acc.z")), each[i], 9000));
        }
        return findings;
    }

    @Test
    void tenSensorsThatLoseAPercentAreOneLine() {
        List<FoldedFindings.Line> folded = FoldedFindings.of(inspection(lost(90, 91, 89, 90, 90, 90, 90, 90, 90, 90)), Set.copyOf(PLACES));
        assertEquals(1, folded.size());
        assertEquals("10 sensors lack 1 % of their samples", folded.get(0).message());
        assertEquals(Severity.NOTE, folded.get(0).severity());
        assertEquals(10, FoldedFindings.each(inspection(lost(90, 91, 89, 90, 90, 90, 90, 90, 90, 90))).size());
    }

    @Test
    void aKindAndASeverityAreALineAndTheGravestComesFirst() {
        List<Finding> findings = lost(90, 90, 3000, 9000);
        findings.add(new Finding.Stuck(Channel.parse("head.acc.z"), 0, 9000, 2, 9000));
        findings.add(new Finding.Stuck(Channel.parse("seat.acc.z"), 0, 9000, 2, 9000));
        List<FoldedFindings.Line> folded = FoldedFindings.of(inspection(findings), Set.copyOf(PLACES));
        assertEquals(List.of(Severity.FAULT, Severity.WARNING, Severity.WARNING, Severity.NOTE),
                folded.stream().map(FoldedFindings.Line::severity).toList());
        assertEquals(findings.get(3).message(), folded.get(0).message(), "what is alone is said as it is");
        assertTrue(folded.stream().anyMatch(each -> each.message().equals("2 channels never move: head.acc.z, seat.acc.z")),
                folded.toString());
    }

    @Test
    void sensorsInAnotherUnitAreToldWhichWhereItIsOne() {
        List<Finding> findings = new ArrayList<>(List.of(unit("seat", "mm/s² read as m/s²"), unit("head", "mm/s² read as m/s²")));
        assertEquals("2 sensors look like mm/s² read as m/s²: seat, head",
                FoldedFindings.of(inspection(findings), Set.copyOf(PLACES)).get(0).message());
        findings.add(unit("pelvis", "g read as m/s²"));
        assertEquals("3 sensors seem to be in another unit: seat, head, pelvis",
                FoldedFindings.of(inspection(findings), Set.copyOf(PLACES)).get(0).message());
    }

    private static Finding unit(String place, String likely) {
        return new Finding.ImplausibleUnit(place, Quantity.ACCELERATION, 900, "m/s²", likely);
    }

    @Test
    void onlyPlacesInUseCountAndTheWholeRecordingAlways() {
        List<Finding> findings = lost(90, 90, 90, 90, 90, 90);
        findings.add(new Finding.Jitter(0.001, 1 / 60.0, false));
        List<FoldedFindings.Line> folded = FoldedFindings.of(inspection(findings), Set.of("platform", "head"));
        assertEquals(2, folded.size());
        assertTrue(folded.get(0).message().startsWith("2 sensors lack"), folded.toString());
        assertTrue(folded.get(1).message().contains("jitter"));
    }

    @Test
    void aChannelThatSuffersTwiceSaysBoth() {
        List<Finding> findings = List.of(new Finding.Clipped(Channel.parse("head.acc.z"), 3, 7, 10),
                new Finding.Clipped(Channel.parse("head.acc.z"), -3, 5, 12));
        assertEquals(findings.get(0).message() + "; " + findings.get(1).message(),
                FoldedFindings.of(inspection(findings), Set.of("head")).get(0).message());
    }

    @Test
    void manyNamesAreShortened() {
        List<Finding> findings = new ArrayList<>();
        PLACES.forEach(place -> findings.add(new Finding.GravityLeftIn(place, 9.8)));
        assertEquals("10 sensors have gravity left in: platform, seat, pelvis, lumbar and 6 more",
                FoldedFindings.of(inspection(findings), Set.copyOf(PLACES)).get(0).message());
    }

    @Test
    void theFigureNamesEverySensorAndWhatIsWrongWithIt() {
        List<Finding> findings = lost(90);
        findings.add(new Finding.Spikes(Channel.parse("head.acc.z"), 3, 20, 5));
        SensorFigure figure = SensorsSeen.of(inspection(findings));
        assertEquals(PLACES, figure.sensors().stream().map(SensorFigure.Sensor::place).toList());
        assertEquals("1 % lost", figure.sensors().get(0).words());
        assertEquals("acc.z spikes (3)", figure.sensors().get(5).words());
        assertEquals(Tiles.Tone.WARNING, figure.sensors().get(5).tone());
        assertEquals(Tiles.Tone.GOOD, figure.sensors().get(1).tone());
        assertEquals(PLACES.size(), figure.svg(text -> text).split("<g class=\"(good|plain|warning|fault)\">", -1).length - 1);
        assertEquals("", new SensorFigure(List.of(new SensorFigure.Sensor("axle", "acc z", Tiles.Tone.GOOD, ""))).svg(text -> text));
    }
}
