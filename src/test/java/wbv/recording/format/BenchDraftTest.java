package wbv.recording.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Drafts whose columns say their unit at their end, and the command that is named next. */
class BenchDraftTest {

    @TempDir
    Path folder;

    private MapDraft draft(String names) throws IOException {
        StringBuilder text = new StringBuilder(names + "\n");
        for (int i = 0; i < 40; i++) {
            text.append(i / 100.0);
            for (int k = 1; k < names.split(",").length; k++) {
                text.append(',').append(Math.sin(i + k));
            }
            text.append('\n');
        }
        return MapDraft.of(Samples.file(folder, "table.csv", text.toString()));
    }

    @ParameterizedTest
    @CsvSource({"ram disp_m,ram.pos.z,m", "ram_x_um,ram.pos.x,um", "ram_speed_mm_s,ram.vel.z,mm/s", "ram_load_kN,ram.force.z,kN",
        "belt_load_lbf,belt.force.z,lbf", "lever_deg,lever.ang.z,deg", "lever_rpm,lever.gyr.z,rpm", "cart_cm,cart.pos.z,cm",
        "cart_acc_mps2,cart.acc.z,m/s2", "cart_acc_cm_s2,cart.acc.z,cm/s2"})
    void aUnitAtTheEndOfANameIsNotAskedFor(String name, String channel, String unit) throws IOException {
        MapDraft draft = draft("time_s," + name);
        assertTrue(draft.lines().contains(name + ": " + channel + " in " + unit), draft.lines()::toString);
        assertTrue(draft.questions().stream().noneMatch(question -> question.contains("unit")), draft.questions()::toString);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|',
            value = {"time_s,force_N,disp_m|diagnose --model model.json", "time_s,ram_load_kN,cart_acc_z_g|diagnose --model model.json",
                "time_s,acc_x_g,acc_y_g,acc_z_g|exposure", "time_s,seat_acc_z_g,seat_force_z_N|exposure",
                "time_s,seat_acc_z_g,head_acc_z_g|analyze",
                "time_s,gyr_x_dps|analyze"})
    void theCommandThatIsNamedFitsTheColumns(String names, String command) throws IOException {
        assertEquals(command, draft(names).command());
    }

    @Test
    void aBenchHasNoSeat() throws IOException {
        MapDraft draft = draft("time_s,force_z_N,disp_z_m");
        assertTrue(draft.lines().contains("force_z_N: mass.force.z in N"), draft.lines()::toString);
    }
}
