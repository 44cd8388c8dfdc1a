package wbv.proof;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import wbv.proof.Marking.Mark;
import wbv.proof.Suite.Group;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Setting;

/** Marks on answers written by hand. */
class MarkingTest {

    private static Truth truth(String... mechanismsAt) {
        return new Truth(Arrays.stream(mechanismsAt).map(text -> {
            String[] part = text.split("@");
            return new Truth.Concealed(part[0], part[1], part.length > 2 ? part[2] : "", Map.of(), 9);
        }).toList(), "rig", 1, 10, "seat", 1);
    }

    private static List<ProofAnswer.Name> names(String... mechanismsAt) {
        return Arrays.stream(mechanismsAt).map(text -> text.split("@"))
                .map(part -> new ProofAnswer.Name(part[0], part[1], 0.9, Map.of(), Map.of(), Map.of(), 1.5, 0)).toList();
    }

    private static ProofAnswer answer(String verdict, List<ProofAnswer.Name> missing, List<ProofAnswer.Name> rivals, String... latent) {
        return new ProofAnswer(verdict, "", missing, rivals, List.of(latent), 10, 1, 12, 1, 3);
    }

    /** An answer to a case in which one mechanism was concealed in the link that {@link CalibratingTest} names. */
    static Marking marked(String concealed, ProofAnswer answer) {
        return mark(Group.LISTED, truth(concealed + "@seat-torso"), answer);
    }

    private static Marking mark(Group group, Truth truth, ProofAnswer answer) {
        return Marking.of(new Suite.Question("001", group, new ConcealedSpec("001", List.of(), 1, Setting.RIG, false, 1)), truth,
                answer);
    }

    @Test
    void rightIsMechanismAndPlace() {
        Truth truth = truth("friction.coulomb@seat-torso");
        assertEquals(Mark.RIGHT, mark(Group.LISTED, truth, answer("missing-physics", names("friction.coulomb@seat-torso"),
                List.of())).mark());
        assertEquals(Mark.ELSEWHERE, mark(Group.LISTED, truth, answer("missing-physics", names("friction.coulomb@torso-head"),
                List.of())).mark());
        assertEquals(Mark.WRONG, mark(Group.LISTED, truth, answer("missing-physics", names("contact.loss@seat-torso"),
                List.of())).mark());
        assertEquals(Mark.SILENT, mark(Group.LISTED, truth, answer("parameters-only", List.of(), List.of())).mark());
        assertEquals(Mark.UNKNOWN, mark(Group.LISTED, truth, answer("unexplained", names("friction.coulomb@seat-torso"),
                List.of())).mark());
        assertEquals(Mark.FAILED, mark(Group.LISTED, truth, ProofAnswer.failed("fell over", 1)).mark());
    }

    /** A pair of which one cannot show counts among all pairs, not among those of which both could be found. */
    @Test
    void pairsAreCountedWithAndWithoutThoseThatCannotShow() {
        Truth plain = truth("friction.coulomb@seat-torso", "sensor.gain@head.acc.z");
        Truth.Concealed faint = new Truth.Concealed("memory.viscoelastic", "torso-head", "", Map.of(), 1.01);
        Truth half = new Truth(List.of(plain.concealed().get(0), faint), "rig", 1, 10, "seat", 1);
        Marking found = mark(Group.PAIR, plain, answer("missing-physics", names("friction.coulomb@seat-torso", "sensor.gain@head.acc.z"),
                List.of()));
        Marking missed = mark(Group.PAIR, half, answer("missing-physics", names("friction.coulomb@seat-torso"), List.of()));
        List<String> lines = new ProofFigures(List.of(found, missed)).markdown().lines().filter(line -> line.contains("pairs exact"))
                .toList();
        assertEquals(List.of("| pairs exact | 1 (50 %) | 2 |", "| pairs exact, linear χ² ≥ 1.5 for each of the two | 1 (100 %) | 1 |"),
                lines);
    }

    @Test
    void aSecondNameThatIsNotThereSpoilsTheFirst() {
        Marking m = mark(Group.LISTED, truth("friction.coulomb@seat-torso"),
                answer("missing-physics", names("friction.coulomb@seat-torso", "sensor.bias@head.acc.z"), List.of()));
        assertEquals(Mark.WRONG, m.mark());
        assertEquals(1, m.spurious());
        assertTrue(m.family());
    }

    @Test
    void anAmbiguousAnswerIsASetOfTwo() {
        Truth truth = truth("friction.coulomb@seat-torso");
        assertEquals(Mark.IN_SET, mark(Group.LISTED, truth,
                answer("ambiguous", names("hysteresis@seat-torso"), names("friction.coulomb@seat-torso"))).mark());
        Marking third = mark(Group.LISTED, truth,
                answer("ambiguous", names("hysteresis@seat-torso"), names("contact.loss@seat-torso",
                        "friction.coulomb@seat-torso")));
        assertEquals(Mark.WRONG, third.mark());
        assertTrue(third.family(), "dry friction and hysteresis are one family");
    }

    @Test
    void aForceOnTheFirstBodyIsOneInItsLinkAndAFaultOfThePlatformsSensor() {
        Truth truth = truth("input.unmeasured@seat");
        assertEquals(Mark.RIGHT, mark(Group.LISTED, truth, answer("missing-physics", names("input.unmeasured@platform-seat"),
                List.of())).mark());
        assertTrue(truth.samePlace("platform.acc.z", "platform-seat"));
        assertFalse(truth.samePlace("torso", "seat-torso"));
        // A law is at its link and nowhere else.
        assertEquals(Mark.ELSEWHERE, mark(Group.LISTED, truth("mode.hidden@torso"),
                answer("missing-physics", names("mode.hidden@seat"), List.of())).mark());
    }

    /** Of bodies in a plane an answer says along which axis; the key of a person beside his simulation says which joint. */
    @Test
    void aJointIsOneAlongAllItsAxes() {
        Truth truth = new Truth(List.of(), "planar", 1, 2, "pelvis", 1);
        assertTrue(truth.samePlace("sternum-head", "sternum.pitch-head.pitch"));
        assertTrue(truth.samePlace("platform-sternum", "platform-sternum.x"));
        assertFalse(truth.samePlace("pelvis-sternum", "sternum.pitch-head.pitch"));
    }

    @Test
    void nothingIsRightOnlyWhenNothingIsSaid() {
        assertEquals(Mark.RIGHT, mark(Group.NOTHING, truth(), answer("nothing-missing", List.of(), List.of())).mark());
        assertEquals(Mark.RIGHT, mark(Group.NOTHING, truth(), answer("parameters-only", List.of(), List.of())).mark());
        assertEquals(Mark.WRONG, mark(Group.NOTHING, truth(), answer("ambiguous", names("hysteresis@seat-torso"),
                List.of())).mark());
        assertEquals(Mark.UNKNOWN, mark(Group.NOTHING, truth(), answer("unexplained", List.of(), List.of())).mark());
    }

    /** Neither silence nor a name, in whatever words; a refusal of the data is an answer there, and nowhere else. */
    @Test
    void ofWhatIsUnrelatedNothingMayBeSaid() {
        assertEquals(Mark.RIGHT, mark(Group.UNRELATED, truth(), answer("cannot-tell", List.of(), List.of())).mark());
        assertEquals(Mark.RIGHT, mark(Group.UNRELATED, truth(), ProofAnswer.refused("head.acc.z is not caused by it", 1)).mark());
        assertEquals(Mark.SILENT, mark(Group.UNRELATED, truth(), answer("parameters-only", List.of(), List.of())).mark());
        assertEquals(Mark.WRONG, mark(Group.UNRELATED, truth(), answer("unexplained", names("hysteresis@seat-torso"), List.of())).mark());
        assertEquals(Mark.FAILED, mark(Group.UNRELATED, truth(), ProofAnswer.failed("fell over", 1)).mark());
        assertEquals(Mark.FAILED, mark(Group.NOTHING, truth(), ProofAnswer.refused("head.acc.z is not caused by it", 1)).mark());
    }

    @Test
    void whoCannotTellRefuses() {
        assertEquals(Mark.UNKNOWN, mark(Group.NOTHING, truth(), answer("cannot-tell", List.of(), List.of())).mark());
        assertEquals(Mark.UNKNOWN,
                mark(Group.LISTED, truth("friction.coulomb@seat-torso"), answer("cannot-tell", List.of(), List.of())).mark());
    }

    @Test
    void whatIsInNoLibraryMustBeRefusedAndLocated() {
        Truth breath = truth("unknown@seat-torso@stiffness breathes at 0.25 Hz");
        Marking refused = mark(Group.UNLISTED, breath, answer("unexplained", List.of(), List.of(), "seat-torso", "head"));
        assertEquals(Mark.RIGHT, refused.mark());
        assertTrue(refused.place());
        assertEquals(Mark.WRONG, mark(Group.UNLISTED, breath, answer("missing-physics", names("drift.slow@seat-torso"),
                List.of())).mark());
        assertEquals(Mark.RIGHT, mark(Group.UNLISTED, truth("unknown@torso@hand that pushes now and then"),
                answer("missing-physics", names("input.unmeasured@torso"), List.of())).mark());
    }

    private static final Truth BREATH = truth("unknown@seat-torso@damping that breathes");

    private static ProofAnswer learned(String where) {
        return answer("learned-law", names("learned@" + where), List.of());
    }

    /** A refusal in words or a law that was learned; a name of the library is wrong, whatever it is. */
    @Test
    void anOpenLawMustBeCalledInNoLibraryAndLocated() {
        assertEquals(Mark.RIGHT, mark(Group.OPEN, BREATH, learned("seat-torso")).mark());
        assertTrue(mark(Group.OPEN, BREATH, learned("seat-torso")).place());
        assertFalse(mark(Group.OPEN, BREATH, learned("torso-head")).place());
        assertTrue(Double.isNaN(mark(Group.OPEN, BREATH, learned("seat-torso")).held()), "what was learned is no name of the library");
        assertEquals(Mark.RIGHT, mark(Group.OPEN, BREATH, answer("unexplained", List.of(), List.of(), "seat-torso")).mark());
        assertEquals(Mark.UNKNOWN, mark(Group.OPEN, BREATH, answer("cannot-tell", List.of(), List.of())).mark());
        assertEquals(Mark.SILENT, mark(Group.OPEN, BREATH, answer("parameters-only", List.of(), List.of())).mark());
        Marking named = mark(Group.OPEN, BREATH, answer("missing-physics", names("drift.slow@seat-torso"), List.of()));
        assertEquals(Mark.WRONG, named.mark());
        assertEquals(0.9, named.held());
        assertEquals(Mark.WRONG, mark(Group.OPEN, BREATH, answer("learned-law", names("hysteresis@seat-torso"), List.of())).mark());
    }

    /** Learning what the library has is a refusal; learning from a null is an alarm. */
    @Test
    void aLawThatIsLearnedIsNoNameElsewhere() {
        assertEquals(Mark.UNKNOWN, mark(Group.LISTED, truth("hysteresis@seat-torso"), learned("seat-torso")).mark());
        assertEquals(Mark.RIGHT, mark(Group.UNLISTED, BREATH, learned("seat-torso")).mark());
        assertEquals(Mark.WRONG, mark(Group.NOTHING, truth(), learned("seat-torso")).mark());
    }

    @Test
    void forcesAreComparedInOneLinkAndTermsWhereBothSidesSayThem() throws IOException {
        List<ComparedTerm> law = ComparedTerm.parse(new ObjectMapper()
                .readTree("[{\"factors\": [{\"of\": \"time\", \"as\": \"sine\"}, {\"of\": \"speed\", \"as\": \"itself\"}]}]"));
        List<ComparedTerm> turned = ComparedTerm.parse(new ObjectMapper()
                .readTree("[{\"factors\": [{\"of\": \"speed\", \"as\": \"itself\"}, {\"of\": \"time\", \"as\": \"sine\"}]}]"));
        List<ComparedTerm> late = ComparedTerm
                .parse(new ObjectMapper().readTree("[{\"factors\": [{\"of\": \"speed\", \"as\": \"itself\"}], \"memory_s\": 2}]"));
        Truth truth = new Truth(List.of(new Truth.Concealed("unknown", "seat-torso", "", Map.of(), 9, law)), "rig", 1, 10, "seat", 1);
        double[] force = IntStream.range(0, 600).mapToDouble(i -> Math.sin(0.5 * i)).toArray();
        ForceMatch match = new ForceMatch(60, force, IntStream.range(0, 600).mapToDouble(i -> Math.sin(0.3 * i)).toArray(),
                IntStream.range(0, 600).mapToDouble(i -> Math.cos(0.3 * i)).toArray());
        List<Marking> all = new ArrayList<>();
        for (String where : List.of("seat-torso", "torso-head")) {
            for (List<ComparedTerm> terms : List.of(turned, late, List.<ComparedTerm>of())) {
                ProofAnswer answer = new ProofAnswer("learned-law", "", names("learned@" + where), List.of(), List.of(), 10, 1, 12, 1.2, 3,
                        Optional.of(new LawForce(where, 60, 2, 8, Arrays.stream(force).boxed().toList(), terms)));
                assertEquals(answer, ProofAnswer.parse(answer.json()));
                all.add(Marking.of(
                        new Suite.Question("521", Group.OPEN, new ConcealedSpec("521", List.of("open.damping.breathing"), 1, Setting.RIG,
                                false, 1)),
                        truth, answer, Optional.of(match)));
            }
        }
        assertEquals(List.of(Optional.of(true), Optional.of(false), Optional.empty()),
                all.subList(0, 3).stream().map(Marking::terms).toList());
        assertEquals(1, all.get(0).correlation(), 1e-6);
        assertTrue(Double.isNaN(all.get(3).correlation()), "elsewhere");
        String text = new Tables(Map.of("command", "wbv prove"), all).markdown();
        for (String line : List.of("| open laws: called not in the library | 6 (100 %) | 6 |", "| open laws: right place | 3 (50 %) | 6 |",
                "| open laws: held-out excess removed, median | 98.2 % | 6 |",
                "| open laws: force correlated with the concealed one by 0.95 or more | 3 (50 %) | 6 |",
                "| open laws: held under a name of the library at 0.8 or more | 0 (0 %) | 6 |",
                "| open laws: right terms, where both sides say them | 2 (50 %) | 4 |")) {
            assertTrue(text.contains(line), line + "\nnot in\n" + text);
        }
    }

    /** A bench is asked of everything: its answers are marked by what was concealed, and counted apart. */
    @Test
    void benchesPlanarPeopleAndLevelsAreMarkedByWhatWasConcealed() {
        Truth law = truth("friction.coulomb@ground-mass");
        Truth open = truth("unknown@ground-mass");
        List<Marking> all = List.of(
                mixed(Group.RIG, "friction.coulomb", false, law,
                        answer("missing-physics", names("friction.coulomb@ground-mass"), List.of())),
                mixed(Group.RIG, "sensor.gain", false, truth("sensor.gain@mass.acc.z"), answer("unexplained", List.of(), List.of())),
                mixed(Group.RIG, "", true, truth(), answer("missing-physics", names("sensor.gain@mass.acc.z"), List.of())),
                mixed(Group.RIG, "", false, truth(), answer("parameters-only", List.of(), List.of())),
                mixed(Group.RIG, "open.damping.eddy", false, open, learned("ground-mass")),
                mixed(Group.LEVELS, "hysteresis", false, truth("hysteresis@seat-torso"), ProofAnswer.refused("too short", 1)));
        assertEquals(List.of(Mark.RIGHT, Mark.UNKNOWN, Mark.WRONG, Mark.RIGHT, Mark.RIGHT, Mark.FAILED),
                all.stream().map(Marking::mark).toList());
        String text = new Tables(Map.of("command", "wbv prove"), all).markdown();
        for (String line : List.of("| rig: mechanism and place | 1 (50 %) | 2 |",
                "| rig: mechanism and place or a set with it, laws | 1 (100 %) | 1 |",
                "| rig: mechanism and place or a set with it, sensors | 0 (0 %) | 1 |",
                "| rig: alarms on nulls, values exact | 1 (100 %) | 1 |",
                "| rig: alarms on nulls, values off | 0 (0 %) | 1 |", "| rig: not in the library, a law was learned | 1 (100 %) | 1 |",
                "| levels: mechanism and place | 0 (0 %) | 1 |", "| levels: refused or no answer | 1 (100 %) | 1 |")) {
            assertTrue(text.contains(line), line + "\nnot in\n" + text);
        }
        assertFalse(text.contains("pairs exact"), text);
        assertTrue(text.contains("nothing, values exact, rig"), text);
    }

    private static Marking mixed(Group group, String word, boolean exact, Truth truth, ProofAnswer answer) {
        return Marking.of(
                new Suite.Question("575", group,
                        new ConcealedSpec("575", word.isEmpty() ? List.of() : List.of(word), 1, Setting.BENCH, exact, 1)),
                truth,
                answer);
    }

    /**
     * Joints of a person in a plane have no direction, a sensor there is one, and the sternum is the torso's; elsewhere words are words.
     */
    @Test
    void placesInAPlaneHaveSeveralNames() {
        Truth plane = new Truth(List.of(), "planar", 1, 10, "pelvis", 1);
        assertTrue(plane.sameWords("pelvis-sternum", "pelvis-torso"));
        assertTrue(plane.sameWords("pelvis-sternum", "sternum-pelvis"));
        assertTrue(plane.sameWords("head.acc.z", "head.gyr.y"));
        assertFalse(plane.sameWords("platform-sternum", "pelvis-sternum"));
        assertFalse(plane.sameWords("head.acc.z", "sternum-head"));
        assertFalse(truth().sameWords("pelvis-sternum", "pelvis-torso"));
        assertFalse(truth().sameWords("head.acc.z", "head.acc.x"));
    }

    @Test
    void aPairNeedsBoth() {
        Truth truth = truth("contact.loss@seat-torso", "sensor.gain@head.acc.z");
        Marking both = mark(Group.PAIR, truth, answer("missing-physics", names("sensor.gain@head.acc.z",
                "contact.loss@seat-torso"), List.of()));
        assertEquals(Mark.RIGHT, both.mark());
        Marking one = mark(Group.PAIR, truth, answer("missing-physics", names("contact.loss@seat-torso"), List.of()));
        assertEquals(Mark.WRONG, one.mark());
        assertEquals(1, one.parts());
    }

    @Test
    void tablesCountWhatWasMarked() {
        List<Marking> all = List.of(
                mark(Group.LISTED, truth("hysteresis@seat-torso"), answer("missing-physics", names("hysteresis@seat-torso"),
                        List.of())),
                mark(Group.LISTED, truth("hysteresis@seat-torso"), answer("missing-physics", names("drift.slow@seat-torso"),
                        List.of())),
                mark(Group.NOTHING, truth(), answer("nothing-missing", List.of(), List.of())),
                mark(Group.NOTHING, truth(), answer("missing-physics", names("drift.slow@seat-torso"), List.of())));
        String text = new Tables(Map.of("command", "wbv prove"), all).markdown();
        assertTrue(text.contains("| mechanism and place, linear χ² ≥ 1.5 | 1 (50 %) | 2 |"), text);
        assertTrue(text.contains("| wrong name held at 0.8 or more | 1 (50 %) | 2 |"), text);
        assertTrue(text.contains("| false alarms on nulls (any name) | 1 (50 %) | 2 |"), text);
        assertTrue(text.contains("| 0.9 to 0.97 | 3 | 0.900 | 33 % |"), text);
    }

    @Test
    void anAnswerReadsBackAsItWasWritten() throws IOException {
        ProofAnswer answer = new ProofAnswer("ambiguous", "One \"of\" two.", List.of(new ProofAnswer.Name("hysteresis", "seat-torso", 0.4,
                Map.of("share", 0.3), Map.of("share", 0.2), Map.of("share", Double.POSITIVE_INFINITY), 1.7, -2.5)),
                names("friction.coulomb@seat-torso"), List.of("seat"), 2.5, 1.1, Double.NaN, 1.2, 3.5);
        // Records compare doubles by their bits, so NaN equals NaN.
        assertEquals(answer, ProofAnswer.parse(answer.json()));
    }
}
