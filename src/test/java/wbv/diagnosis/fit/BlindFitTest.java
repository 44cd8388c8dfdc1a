package wbv.diagnosis.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import wbv.body.ModelFile;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;

/** What is left beside ignored places, against the long way: the same recording whitened so that nothing shows along them. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class BlindFitTest {

    private Evidence evidence;
    /** The same recording, taken for one without errors of sensors. */
    private Evidence exact;
    private Candidate baseline;
    private BlindFit blind;
    private Fitter.State state;

    @BeforeAll
    void looked(@TempDir Path folder) throws Exception {
        ConcealedCase made = Concealer
                .make(new ConcealedSpec("blind", List.of("friction.coulomb", "sensor.delay"), 0.6, Setting.RIG, false, 21));
        Path file = Files.writeString(folder.resolve("model.json"), made.model(), StandardCharsets.UTF_8);
        evidence = new Evidence(ModelFile.read(file), made.recording());
        exact = Evidence.computed(ModelFile.read(file), made.recording(), OptionalDouble.of(0.02));
        baseline = Baseline.of(evidence);
        Fitter fitter = new Fitter(evidence);
        double[] x = baseline.start();
        state = fitter.lookWithSlopes(baseline, x, fitter.frame(baseline, x, evidence.fit()));
        blind = new BlindFit(evidence, fitter, state);
    }

    /** Without a step and without errors of sensors: one place, two, one of a force and one of a sensor. */
    @Test
    void ignoresWhatDeafeningIgnores() {
        Fitter fitter = new Fitter(exact);
        BlindFit from = new BlindFit(exact, fitter,
                fitter.lookWithSlopes(baseline, state.x(), fitter.frame(baseline, state.x(), exact.fit())));
        Place head = new Place(Place.Kind.BODY, 2);
        Place sensor = new Place(Place.Kind.SENSOR, 2);
        Place neck = new Place(Place.Kind.LINK, 2);
        for (List<Place> places : List.of(List.of(sensor), List.of(neck), List.of(head, sensor),
                List.of(neck, new Place(Place.Kind.LINK, 1)))) {
            Evidence seen = exact;
            for (Place place : places) {
                seen = seen.ignoring(place);
            }
            double expected = new Fitter(seen).look(baseline, state.x(), exact.fit()).reduced();
            assertEquals(expected, from.ignoring(places, 0).reduced(), 1e-4 * expected, places.toString());
        }
    }

    /** A direction that another holds already is none: two names of one place are that place, if for the numbers that count. */
    @Test
    void twoNamesOfAPlaceAreOnePlace() {
        int last = evidence.model().links().size() - 1;
        Place neck = new Place(Place.Kind.LINK, last);
        double lines = 2.0 * evidence.fit().lines();
        double all = lines * evidence.outputs().size();
        double once = blind.ignoring(List.of(neck), 0).reduced() * (all - lines);
        assertEquals(once, blind.ignoring(List.of(neck, neck), 0).reduced() * (all - 2 * lines), 1e-9 * once);
    }

    /** A few steps with the derivatives of the start lead nearly as low as a fit. */
    @Test
    void fewStepsLeadNearlyAsLowAsAFit() {
        for (Place place : Place.all(evidence)) {
            Fitter fitter = new Fitter(evidence.ignoring(place));
            double fitted = fitter.fit(baseline, state.x(), fitter.frame(baseline, state.x(), evidence.fit()), 8, 2e-3).reduced();
            Known.Ignoring found = blind.ignoring(List.of(place), 6);
            assertTrue(found.reduced() < blind.ignoring(List.of(place), 0).reduced(), place.toString());
            assertTrue(found.reduced() - 1 < 1.5 * Math.max(0.1, fitted - 1), place + ": " + found.reduced() + ", fitted " + fitted);
        }
    }
}
