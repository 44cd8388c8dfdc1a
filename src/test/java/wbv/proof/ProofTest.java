package wbv.proof;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.recording.DataFault;
import wbv.recording.format.RecordingWriter;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;

class ProofTest {

    private static final Path SHIPPED = Path.of("data/arff/concealed");

    @Test
    void aSealedKeyOpensUnderItsPasswordOnly() {
        String sealed = new Vault("one").seal("friction, 5 N");
        assertFalse(sealed.contains("friction"));
        assertEquals("friction, 5 N", new Vault("one").open(sealed));
        assertThrows(IllegalArgumentException.class, () -> new Vault("two").open(sealed));
        // FIPS 180-4, the digest of "abc".
        assertEquals("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad", Vault.sha256("abc"));
    }

    @Test
    void theKeysThatComeWithWbvAreThoseWhoseHashesWerePublished() throws IOException {
        for (int i = 1; i <= 10; i++) {
            String key = SealedCase.open(SHIPPED.resolve(String.format("%03d", i)));
            assertTrue(key.contains("\"mechanisms\""));
        }
    }

    @Test
    void aKeyThatWasChangedIsNotOpened(@TempDir Path folder) throws IOException {
        Path given = Files.createDirectories(folder.resolve("001"));
        String hash = SealedCase.seal(given, "{}");
        Files.writeString(folder.resolve("README.md"), "| 001 | `" + hash + "` |");
        assertEquals("{}", SealedCase.open(given));
        SealedCase.seal(given, "{\"mechanisms\": []}");
        DataFault fault = assertThrows(DataFault.class, () -> SealedCase.open(given));
        assertTrue(fault.getMessage().contains("not the key that was published"), fault.getMessage());
        assertThrows(DataFault.class, () -> SealedCase.open(folder));
    }

    @Test
    void theFullProofAsksAllThatItPromises() {
        List<Suite.Question> all = Suite.full(1).questions();
        for (String mechanism : ConcealedSpec.MECHANISMS) {
            for (double strength : new double[] {1, 0.3, 0.1}) {
                assertEquals(5, all.stream().filter(q -> q.group() == Suite.Group.LISTED && q.spec().words().contains(mechanism)
                        && q.spec().strength() == strength).count());
            }
        }
        assertEquals(100, all.stream().filter(q -> q.group() == Suite.Group.NOTHING).count());
        assertEquals(40, all.stream().filter(q -> q.group() == Suite.Group.UNLISTED).count());
        assertEquals(20, all.stream().filter(q -> q.group() == Suite.Group.PAIR).count());
        assertEquals(all.size(), all.stream().map(q -> q.spec().seed()).distinct().count());
        assertEquals(Suite.full(1), Suite.full(1));
        assertEquals(all.subList(2, 5), Suite.full(1).part(3, 5).questions());
        assertEquals(all, Suite.full(1).part(1, Integer.MAX_VALUE).questions());
        assertEquals(List.of(), Suite.full(1).part(709, 800).questions());
    }

    /** Open laws are asked after all others, which are what they were: the digests are of the 520 questions before there were open ones. */
    @Test
    void openLawsAreAskedLast() {
        for (Map.Entry<Long, String> old : Map.of(7L, "9768727bbbae7a4cf0e2afa1309c575fd740fb967dec212ea83a30dd7026e5f1",
                97L, "3b1ccf619b3ff6e05593bec70fd8107d171c362122bdbde57db67a43c329fdb0").entrySet()) {
            assertEquals(old.getValue(), Vault.sha256(new ArrayList<>(Suite.full(old.getKey()).questions().subList(0, 520)).toString()));
        }
        List<Suite.Question> open = Suite.full(1).only("open").questions();
        assertEquals(Suite.full(1).part(521, 574).questions(), open);
        assertEquals(54, open.size());
        assertEquals("521", open.get(0).id());
        for (String law : ConcealedSpec.OPEN) {
            List<Suite.Question> draws = Suite.full(1).only(law).questions();
            assertEquals(List.of(0.3, 1.0, 1.0), draws.stream().map(q -> q.spec().strength()).sorted().toList());
        }
    }

    /** Benches, planar people and levels come after the open laws, with nulls of both kinds, and are named together with commas. */
    @Test
    void benchesPlanarPeopleAndLevelsAreAskedAfterOpenLaws() {
        List<Suite.Question> mixed = Suite.full(1).part(1, 692).only("rig,planar,levels").questions();
        assertEquals(Suite.full(1).part(575, 665).questions(), mixed);
        assertEquals("575", mixed.get(0).id());
        for (Map.Entry<Suite.Group, Integer> each : Map.of(Suite.Group.RIG, 36, Suite.Group.PLANAR, 33, Suite.Group.LEVELS, 22)
                .entrySet()) {
            List<Suite.Question> group = Suite.full(1).part(1, 692).only(each.getKey().name().toLowerCase()).questions();
            assertEquals(each.getValue(), group.size());
            for (boolean exact : new boolean[] {true, false}) {
                assertEquals(4, group.stream().filter(q -> q.kind() == Suite.Group.NOTHING && q.spec().exact() == exact).count());
            }
        }
        assertEquals(5 * 3, Suite.full(1).only("friction.coulomb").questions().size(), "sitters alone");
    }

    /** Benches that change in time come last, so that all others are what they were: the digest is of the 692 before there were any. */
    @Test
    void benchesThatChangeAreAskedLast() {
        assertEquals("30f60d84fd998e23dc69b25c680bc808f912e4cd104ec713a92d51d134fca210",
                Vault.sha256(new ArrayList<>(Suite.full(7).questions().subList(0, 692)).toString()));
        List<Suite.Question> changing = Suite.full(1).part(693, 708).questions();
        assertEquals(52, Suite.full(1).only("rig").questions().size());
        assertEquals(changing, Suite.full(1).only("rig").part(37, 52).questions());
        for (String word : List.of("drift.step", "drift.slow")) {
            assertEquals(List.of(0.3, 0.3, 0.3, 0.3, 1.0, 1.0, 1.0, 1.0), changing.stream()
                    .filter(q -> q.spec().words().equals(List.of(word)) && q.kind() == Suite.Group.LISTED).map(q -> q.spec().strength())
                    .sorted().toList());
        }
    }

    /**
     * What perfect sensors would send of a bench, the simulator of models makes of the exact model and the same input, to less than the
     * sensors' noise; they share no code.
     */
    @ParameterizedTest
    @ValueSource(longs = {2, 11, 13, 26})
    void theSimulatorOfModelsMovesAnExactBenchAsTheGeneratorDid(long seed) throws IOException {
        ConcealedCase made = Concealer.make(new ConcealedSpec("575", List.of(), 1, Setting.BENCH, true, seed));
        Model model = ModelFile.parse(made.model(), "model.json");
        double noise = new ObjectMapper().readTree(made.key()).get("noise_over_signal").asDouble();
        double[][] simulated = new Simulator(Excitation.of(model, made.clean(), made.clean().length())).outputs(model.assembly());
        for (int o = 0; o < simulated.length; o++) {
            double[] sent = made.clean().values(model.outputs().get(o));
            double missed = 0;
            double all = 0;
            for (int i = 0; i < sent.length; i++) {
                missed += (simulated[o][i] - sent[i]) * (simulated[o][i] - sent[i]);
                all += sent[i] * sent[i];
            }
            assertTrue(Math.sqrt(missed / all) < noise,
                    model.outputs().get(o) + " misses " + Math.sqrt(missed / all) + " of " + made.key());
        }
    }

    /** Three recordings of a bench from their spec to their marks. */
    @Tag("slow")
    @Test
    void levelsAreFittedTogetherAndProvenOnTheThird(@TempDir Path folder) throws IOException {
        Suite suite = new Suite(List.of(empty("576", Suite.Group.LEVELS, Setting.BENCH_LEVELS, 30)));
        Tables tables = new Proof(suite, 6, folder, Map.of(), (what, share) -> {}).run();
        try (Stream<Path> files = Files.list(folder.resolve("cases/576"))) {
            assertEquals(List.of("proof.csv.gz", "recording.csv.gz", "with.csv.gz"), files.map(file -> file.getFileName().toString())
                    .filter(name -> name.endsWith(".gz")).sorted().toList());
        }
        assertTrue(tables.summary().contains("| levels: quiet nulls, values exact | 1 (100 %) | 1 |"), tables.markdown());
        assertTrue(tables.markdown().contains("nothing, values exact, bench levels"), tables.markdown());
    }

    /**
     * Where a simulation lies beside the recording, that is what it is held against, whatever the model: here what perfect sensors would
     * have sent.
     */
    @Tag("slow")
    @Test
    void aSimulationBesideTheRecordingIsAskedOf(@TempDir Path folder) throws IOException {
        ConcealedCase made = Concealer.make(new ConcealedSpec("577", List.of(), 1, Setting.FIELD, true, 6));
        made.write(folder);
        Files.writeString(folder.resolve("model.json"), "{}");
        assertEquals(ProofAnswer.REFUSED, Worker.answer(folder).verdict());
        RecordingWriter.write(folder.resolve(ConcealedCase.SIMULATION), made.clean());
        assertEquals("nothing-missing", Worker.answer(folder).verdict());
    }

    private static Suite.Question empty(String id, Suite.Group group, Setting setting, long seed) {
        return new Suite.Question(id, group, new ConcealedSpec(id, List.of(), 1, setting, true, seed));
    }

    /** The force lies beside the key, sealed like it, and nowhere else; a cut one is made again. */
    @Tag("slow")
    @Test
    void theForceOfAnOpenLawIsSealedBesideItsKey(@TempDir Path folder) throws IOException {
        Suite suite = new Suite(List.of(new Suite.Question("521", Suite.Group.OPEN,
                new ConcealedSpec("521", List.of("open.stiffness.bolster"), 1, Setting.FIELD, false, 6))));
        Proof proof = new Proof(suite, 6, folder, Map.of(), (what, share) -> {});
        proof.conceal();
        try (Stream<Path> files = Files.walk(folder)) {
            assertEquals(List.of("521.force.sealed", "521.sealed"), files.map(file -> file.getFileName().toString())
                    .filter(name -> name.contains("force") || name.contains("sealed")).sorted().toList());
        }
        Path force = folder.resolve("keys/521.force.sealed");
        String sealed = Files.readString(force);
        String text = new Vault("wbv prove 6").openPacked(sealed);
        assertTrue(new Vault("wbv prove 6").open(Files.readString(folder.resolve("keys/521.sealed"))).contains(Vault.sha256(text)));
        assertThrows(IllegalArgumentException.class, () -> new Vault("wbv prove 7").openPacked(sealed));
        Files.writeString(force, sealed.substring(0, 5000));
        proof.conceal();
        assertEquals(sealed, Files.readString(force));
    }

    /** One ride under the outputs of another, and of a sitter at rest, through the whole proof. */
    @Tag("slow")
    @Test
    void unrelatedRecordingsAreAskedWithAReasonForAnAnswer(@TempDir Path folder) throws IOException {
        Suite suite = new Suite(List.of("unrelated.ride", "unrelated.rest").stream().map(kind -> new Suite.Question(kind,
                Suite.Group.UNRELATED, new ConcealedSpec(kind, List.of(kind), 1, Setting.FIELD, true, 11))).toList());
        Tables tables = new Proof(suite, 6, folder, Map.of(), (what, share) -> {}).run();
        assertTrue(tables.summary().contains("| all: nothing is missing, or only values | 0 (0 %) | 2 |"), tables.summary());
        assertTrue(tables.summary().contains("| all: any mechanism named | 0 (0 %) | 2 |"), tables.summary());
        assertEquals(100, Suite.unrelated(1).questions().size());
        assertEquals(Suite.unrelated(1), Suite.unrelated(1));
    }

    /**
     * One null from the ledger to the marks: nothing readable but the case, a hash written before, work kept when asked again.
     */
    @Tag("slow")
    @Test
    void aProofOfOneCaseRunsThroughAndIsKept(@TempDir Path folder) throws IOException {
        Suite suite = new Suite(List.of(new Suite.Question("001", Suite.Group.NOTHING,
                new ConcealedSpec("001", List.of(), 1, Setting.FIELD, true, 6))));
        Proof proof = new Proof(suite, 6, folder, Map.of(), (what, share) -> {});
        String first = proof.run().json();
        assertTrue(first.contains("\"mark\""), first);
        try (Stream<Path> files = Files.walk(folder.resolve("cases"))) {
            for (Path file : files.filter(f -> f.toString().endsWith(".json")).toList()) {
                assertFalse(Files.readString(file).contains("linear_chi2"), file + " holds the key");
            }
        }
        String key = new Vault("wbv prove 6").open(Files.readString(folder.resolve("keys/001.sealed")));
        assertTrue(Files.readString(folder.resolve("ledger.csv")).contains("001," + Vault.sha256(key)));
        Path answer = folder.resolve("cases/001/answer.json");
        String before = Files.readString(answer);
        assertEquals(first, new Proof(suite, 6, folder, Map.of(), (what, share) -> {}).run().json());
        assertEquals(before, Files.readString(answer));
        // What a failing disk leaves: an empty key and a cut answer are made again, the same.
        String sealed = Files.readString(folder.resolve("keys/001.sealed"));
        for (String cut : List.of("", sealed.substring(0, 150))) {
            Files.writeString(folder.resolve("keys/001.sealed"), cut);
            proof.conceal();
            assertEquals(sealed, Files.readString(folder.resolve("keys/001.sealed")));
        }
        assertTrue(proof.open().json().contains("\"mark\""));
        for (String cut : List.of("", before.substring(0, 100))) {
            Files.writeString(answer, cut);
            assertFalse(proof.open().json().contains("\"mark\""));
        }
        Files.writeString(answer, before);
        DataFault other = assertThrows(DataFault.class, () -> new Proof(suite, 7, folder, Map.of(), (what, share) -> {}).run());
        assertTrue(other.getMessage().contains("another proof"), other.getMessage());
    }

    @Test
    void anExamineeThatDiesFailsItsCaseAndNoOther(@TempDir Path folder) throws IOException {
        Path empty = Files.createDirectories(folder.resolve("001"));
        try (Examinee examinee = new Examinee(folder)) {
            examinee.ask(empty, 60);
        }
        ProofAnswer answer = ProofAnswer.parse(Files.readString(empty.resolve("answer.json")));
        assertEquals(ProofAnswer.FAILED, answer.verdict());
    }
}
