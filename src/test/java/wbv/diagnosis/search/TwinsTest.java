package wbv.diagnosis.search;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.body.ModelFile;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Place;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;

/** What no output tells apart follows from who hangs on whom, and from who has a sensor. */
class TwinsTest {

    private static final String CHAIN = """
            {"name": "chain", "axis": "z", "base": {"name": "platform", "sensor": "platform.acc.z"},
             "bodies": [{"name": "pelvis", "mass_kg": 12, "sensor": "pelvis.acc.z"},
                        {"name": "torso", "mass_kg": 30, "sensor": "sternum.acc.z"},
                        {"name": "viscera", "mass_kg": 8, "sensor": null}, {"name": "head", "mass_kg": 5, "sensor": "head.acc.z"}],
             "links": [{"from": "platform", "to": "pelvis", "stiffness_N_per_m": 90000, "damping_Ns_per_m": 1800},
                       {"from": "pelvis", "to": "torso", "stiffness_N_per_m": 80000, "damping_Ns_per_m": 1500},
                       {"from": "torso", "to": "viscera", "stiffness_N_per_m": 16000, "damping_Ns_per_m": 100},
                       {"from": "torso", "to": "head", "stiffness_N_per_m": 20000, "damping_Ns_per_m": 130}]}
            """;

    @TempDir
    private Path folder;

    @Test
    void whatHangsOnABodyAndHasNoSensorIsSeenAtThatBodyAlone() throws Exception {
        assertEquals(Set.of("pelvis platform-pelvis", "torso viscera torso-viscera", "head", "pelvis-torso", "torso-head", "pelvis.acc.z",
                "sternum.acc.z", "head.acc.z"), sets());
    }

    private Set<String> sets() throws Exception {
        ConcealedCase made = Concealer.make(new ConcealedSpec("twins", List.of(), 1, Setting.RIG, false, 1));
        Path file = Files.writeString(folder.resolve("model.json"), CHAIN, StandardCharsets.UTF_8);
        Evidence evidence = new Evidence(ModelFile.read(file), made.recording());
        Candidate baseline = Baseline.of(evidence);
        List<Place> places = Place.all(evidence);
        Twins twins = new Twins(evidence, baseline, places);
        return places.stream().map(twins::of).map(set -> set.stream().map(place -> place.name(evidence)).collect(Collectors.joining(" ")))
                .collect(Collectors.toSet());
    }
}
