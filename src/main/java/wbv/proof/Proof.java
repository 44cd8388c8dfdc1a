package wbv.proof;

import com.fasterxml.jackson.core.JsonProcessingException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiConsumer;
import wbv.recording.AtomicFile;
import wbv.recording.DataFault;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.Concealer;

/**
 * The whole proof in one folder: {@code cases/} is all that the diagnosis is shown, {@code keys/} are sealed under the seed,
 * {@code ledger.csv} holds the SHA-256 of every key before the first diagnosis begins. What was done already is kept.
 */
public final class Proof {

    private static final long LIMIT = 180;
    /** Of several recordings, many rows or a simulation [s], on a machine that others use as well. */
    private static final long LONG_LIMIT = 600;

    private final Suite suite;
    private final Path folder;
    private final Vault vault;
    private final Map<String, String> made;
    private final BiConsumer<String, Double> progress;

    /**
     * A proof in which nothing is made yet.
     *
     * @param seed which seals the keys
     * @param made how it is made, for the tables
     * @param progress told what is being done, and the share of it that is done
     */
    public Proof(Suite suite, long seed, Path folder, Map<String, String> made, BiConsumer<String, Double> progress) {
        this.suite = suite;
        this.folder = folder;
        this.vault = new Vault("wbv prove " + seed);
        this.made = Collections.unmodifiableMap(new LinkedHashMap<>(made));
        this.progress = progress;
    }

    /** Conceals, diagnoses, opens and marks. */
    public Tables run() throws IOException {
        conceal();
        ledger();
        diagnose();
        return open();
    }

    /** Makes the cases that are not there yet. */
    void conceal() throws IOException {
        Files.createDirectories(folder.resolve("keys"));
        AtomicInteger done = new AtomicInteger();
        long start = System.nanoTime();
        try {
            suite.questions().parallelStream().forEach(question -> {
                try {
                    if (!concealed(question)) {
                        ConcealedCase made = Concealer.make(question.spec());
                        String key = vault.seal(made.key());
                        requireBeginning(sealed(question), key);
                        made.write(shown(question));
                        if (made.force().isPresent()) {
                            AtomicFile.write(force(question), vault.sealPacked(made.force().get()));
                        }
                        AtomicFile.write(sealed(question), key);
                    }
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
                tell("concealing", done.incrementAndGet(), start);
            });
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    /** Whether the case is there: its key is written last. */
    private boolean concealed(Suite.Question question) throws IOException {
        try {
            return Files.exists(sealed(question)) && Truth.parse(vault.open(
                    Files.readString(sealed(question), StandardCharsets.ISO_8859_1))).seed() == question.spec().seed()
                    && (!question.spec().hasForce() || match(question).isPresent());
        } catch (IllegalArgumentException cutOrOfAnotherProof) {
            return false;
        }
    }

    /**
     * A folder may be gone on with only by the proof that began it. A key that does not open is this proof's where it is the
     * beginning of the right one, as a failing disk leaves it: a case, and so its key, follows from the seed.
     */
    private void requireBeginning(Path sealed, String key) throws IOException {
        if (Files.exists(sealed) && !key.startsWith(Files.readString(sealed, StandardCharsets.ISO_8859_1))) {
            throw DataFault.in(folder.toString(),
                    "holds the cases of another proof (another --seed, --quick or version); choose another folder");
        }
    }

    /** Writes down what the keys are before anything is diagnosed. */
    private void ledger() throws IOException {
        StringBuilder text = new StringBuilder("case,sha256\n");
        for (Suite.Question question : suite.questions()) {
            text.append(question.id()).append(',').append(Vault.sha256(vault.open(Files.readString(sealed(question))))).append('\n');
        }
        AtomicFile.write(folder.resolve("ledger.csv"), text);
    }

    private void diagnose() throws IOException {
        long start = System.nanoTime();
        List<Suite.Question> open = new ArrayList<>();
        for (Suite.Question question : suite.questions()) {
            if (answered(question).isEmpty()) {
                open.add(question);
            }
        }
        int done = suite.questions().size() - open.size();
        try (Examinee examinee = new Examinee(folder.resolve("cases"))) {
            int asked = 0;
            for (Suite.Question question : open) {
                examinee.ask(shown(question), question.group().isMixed() ? LONG_LIMIT : LIMIT);
                asked++;
                double left = (System.nanoTime() - start) / 1e9 / asked * (open.size() - asked);
                progress.accept("diagnosing " + (done + asked) + " of " + suite.questions().size() + ", " + MarkdownCells.time(left)
                        + " left",
                        (double) (done + asked) / suite.questions().size());
            }
        }
    }

    /** Opens the keys and marks what is answered so far. */
    Tables open() throws IOException {
        List<Marking> markings = new ArrayList<>();
        for (Suite.Question question : suite.questions()) {
            Optional<ProofAnswer> answer = answered(question);
            if (answer.isPresent()) {
                Truth truth = Truth.parse(vault.open(Files.readString(sealed(question))));
                markings.add(Marking.of(question, truth, answer.get(), match(question)));
            }
        }
        Tables tables = new Tables(made, markings);
        AtomicFile.write(folder.resolve("proof.md"), tables.markdown());
        AtomicFile.write(folder.resolve("proof.json"), tables.json());
        return tables;
    }

    private void tell(String what, int done, long start) {
        double left = (System.nanoTime() - start) / 1e9 / done * (suite.questions().size() - done);
        progress.accept(what + " " + done + " of " + suite.questions().size() + ", " + MarkdownCells.time(left) + " left",
                (double) done / suite.questions().size());
    }

    /** What was answered; empty where nothing was yet, or an answer was cut off. */
    private Optional<ProofAnswer> answered(Suite.Question question) throws IOException {
        String text = Files.exists(answer(question)) ? Files.readString(answer(question)) : "";
        try {
            return text.isBlank() ? Optional.empty() : Optional.of(ProofAnswer.parse(text));
        } catch (JsonProcessingException cut) {
            return Optional.empty();
        }
    }

    /**
     * The force that was concealed; empty where none is to be learned.
     *
     * @throws IllegalArgumentException if it was cut short or changed
     */
    private Optional<ForceMatch> match(Suite.Question question) throws IOException {
        return Files.exists(force(question)) ? Optional.of(ForceMatch.parse(vault.openPacked(
                Files.readString(force(question), StandardCharsets.ISO_8859_1)))) : Optional.empty();
    }

    private Path force(Suite.Question question) {
        return folder.resolve("keys").resolve(question.id() + ".force.sealed");
    }

    private Path shown(Suite.Question question) {
        return folder.resolve("cases").resolve(question.id());
    }

    private Path sealed(Suite.Question question) {
        return folder.resolve("keys").resolve(question.id() + ".sealed");
    }

    private Path answer(Suite.Question question) {
        return shown(question).resolve("answer.json");
    }
}
