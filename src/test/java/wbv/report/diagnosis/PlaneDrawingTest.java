package wbv.report.diagnosis;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.report.page.XyChart;
import wbv.report.page.XySeries;

class PlaneDrawingTest {

    private static final String MODEL = """
            {"name": "one", "plane": "xz", "axis": "z",
             "base": {"name": "platform", "at_m": [0, 0], "sensors": ["platform.acc.z", "platform.acc.x"]},
             "bodies": [{"name": "pelvis", "at_m": [0.02, 0.2], "mass_kg": 40, "inertia_kgm2": 1.2,
               "sensors": [{"sensor": "pelvis.acc.z", "at_m": [0.1, 0.25]}]}],
             "links": [
               {"from": "platform", "to": "pelvis", "along": "z", "at_m": [0, 0.02], "stiffness_N_per_m": 45000, "damping_Ns_per_m": 900},
               {"from": "platform", "to": "pelvis", "along": "x", "at_m": [-0.1, 0.3], "stiffness_N_per_m": 30000, "damping_Ns_per_m": 700},
               {"from": "platform", "to": "pelvis", "about": "y", "stiffness_Nm_per_rad": 2500, "damping_Nms_per_rad": 60}]}
            """;

    /** Everything stands where the model has it, and the place of what is missing is marked. */
    @Test
    void bodiesStandWhereTheyAre() {
        Model model = ModelFile.parse(MODEL, "one.json");
        XyChart chart = PlaneDrawing.of(model, List.of("platform-pelvis.x")).orElseThrow();
        assertArrayEquals(new double[] {0.02}, named(chart, "centres of mass").x());
        assertArrayEquals(new double[] {0.02, 0.3}, named(chart, "joints").y());
        assertArrayEquals(new double[] {0, 0.25}, named(chart, "sensors").y());
        assertArrayEquals(new double[] {-0.1}, named(chart, "what is missing acts here").x());
        assertEquals(3.6 * (chart.y().high() - chart.y().low()), chart.x().high() - chart.x().low(), 1e-12, "both axes to one scale");
        assertTrue(PlaneDrawing.of(model, List.of()).orElseThrow().series().stream()
                .noneMatch(series -> series.name().startsWith("what is missing")));
    }

    @Test
    void aChainIsNotDrawn() {
        Model chain = new Model("chain", Optional.empty(), 'z', new Model.Base("seat", Optional.empty()),
                List.of(new Model.Body("head", 5, Optional.empty(), List.of(), Optional.empty(), List.of())),
                List.of(new Model.Link("seat", "head", 100, 1, Optional.empty(), List.of(), List.of())));
        assertTrue(PlaneDrawing.of(chain, List.of()).isEmpty());
    }

    private static XySeries named(XyChart chart, String name) {
        return chart.series().stream().filter(series -> series.name().equals(name)).findFirst().orElseThrow();
    }
}
