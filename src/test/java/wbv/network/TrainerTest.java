package wbv.network;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.recording.DataFault;

/** Training, in small: the full size stands in docs/thesis.md. */
class TrainerTest {

    @TempDir
    private Path folder;

    @BeforeAll
    static void needsTheEngine() {
        WithEngine.orSkip();
    }

    /** The loss on bodies that were not learned from falls to a fifth, with 400 images and 12 epochs. */
    @Tag("slow")
    @Test
    void aReducedRunLearns() throws IOException {
        TrainingOrder order = new TrainingOrder(Bodies.ONE_DOF, 400, 3, Architecture.POOLED,
                new Settings(12, 32, Settings.Method.ADAM, 3e-3, 6,
                        0.3, 0, 1),
                1);
        Trainer.Result result = new Trainer(order, Optional.empty(), (step, share) -> {}).train();
        List<Losses> losses = result.losses().get(0);
        double first = losses.get(0).rmse();
        double last = losses.get(losses.size() - 1).rmse();
        assertTrue(last * last < first * first / 5, first + " to " + last);
        assertTrue(last < 0.45, "an answer without looking would err by 1: " + last);
        assertTrue(result.model().bytes().length < 5 << 20);
    }

    /** The thesis' networks' loss falls to less than two thirds with 150 images and five epochs. */
    @Tag("slow")
    @Test
    void theThesisNetworkLearnsToo() throws IOException {
        TrainingOrder order = new TrainingOrder(Bodies.ONE_DOF, 150, 3, Architecture.CNN,
                new Settings(5, 16, Settings.Method.MOMENTUM, 0.001, 20,
                        0.1, 0.2, 1),
                1);
        List<Losses> losses = new Trainer(order, Optional.empty(), (step, share) -> {}).train().losses().get(0);
        assertTrue(losses.get(4).train() < 0.66 * losses.get(0).train(), losses.toString());
    }

    @Tag("slow")
    @Test
    void aTrainingThatWasInterruptedEndsAsOneThatWasNot() throws IOException {
        TrainingOrder order = new TrainingOrder(Bodies.ONE_DOF, 60, 2, Architecture.POOLED, new Settings(3, 16, Settings.Method.ADAM, 1e-3,
                2, 0.5, 0.3, 1), 2);
        Trainer.Result whole = new Trainer(order, Optional.empty(), (step, share) -> {}).train();
        assertArrayEquals(whole.model().bytes(), new Trainer(order, Optional.empty(), (step, share) -> {}).train().model().bytes());
        Path checkpoint = folder.resolve("state.safetensors");
        for (double stop : new double[] {0.3, 0.8}) {
            assertThrows(IllegalStateException.class, () -> new Trainer(order, Optional.of(checkpoint), (step, share) -> {
                if (step.equals("training") && share > stop) {
                    throw new IllegalStateException("the lights went out");
                }
            }).train());
            assertTrue(Files.exists(checkpoint));
        }
        TrainingOrder other = new TrainingOrder(Bodies.ONE_DOF, 60, 9, order.architecture(), order.settings(), 2);
        DataFault refused = assertThrows(DataFault.class, () -> new Trainer(other, Optional.of(checkpoint), (step, share) -> {
        }).train());
        assertTrue(refused.getMessage().contains("another training"), refused.getMessage());
        for (int again = 0; again < 2; again++) {   // the second time from a training that was done, its model not yet written
            Trainer goesOn = new Trainer(order, Optional.of(checkpoint), (step, share) -> {});
            Trainer.Result resumed = goesOn.train();
            assertArrayEquals(whole.model().bytes(), resumed.model().bytes());
            assertEquals(whole.losses(), resumed.losses());
            assertTrue(Files.exists(checkpoint), "the training would be lost with the model");
            if (again == 1) {
                goesOn.forget();
            }
        }
        assertFalse(Files.exists(checkpoint));
    }

    @Test
    void everyTrialHasABodyOfItsOwnAndComesBackForItsSeed() {
        List<LabelledMotion> trials = RigTrials.of(Bodies.TWO_DOF, 40, 7, share -> {});
        assertEquals(40, trials.stream().map(LabelledMotion::rig).distinct().count());
        assertEquals(40, trials.stream().map(trial -> trial.truth()[0] + " " + trial.truth()[3]).distinct().count());
        List<LabelledMotion> again = RigTrials.of(Bodies.TWO_DOF, 40, 7, share -> {});
        assertArrayEquals(trials.get(39).motion()[1], again.get(39).motion()[1]);
        assertTrue(trials.stream().allMatch(trial -> trial.truth()[1] <= trial.truth()[3]));
    }
}
