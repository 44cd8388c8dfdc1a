package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.Test;
import wbv.body.Model;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.Recording;

class QuestionTest {

    private static final double RATE = 60;
    private static final int N = 3600;
    private static final Channel BASE = Channel.parse("platform.acc.z");
    private static final Channel SEAT = Channel.parse("seat.acc.z");
    private static final Channel SIMULATED = Channel.parse("simulation.acc.z");

    /** The model is 40 % off, what it simulated is not: nothing is missing in the simulation, and the model learns its values. */
    @Test
    void theSurrogateOfASimulationHasTheSimulationsValues() {
        Recording recording = recording(60000, 1500);
        Question question = new Question(model(36000, 2000), recording, Optional.of(SIMULATED), OptionalDouble.empty());
        Model.Link link = question.asked().links().get(0);
        assertEquals(60000, link.stiffness(), 600);
        assertEquals(1500, link.damping(), 30);
        assertEquals(Diagnosis.Verdict.NOTHING_MISSING, Diagnoser.diagnose(question, (step, share) -> {}).verdict());
        assertEquals(Diagnosis.Verdict.PARAMETERS_ONLY,
                Diagnoser.diagnose(Question.of(model(36000, 2000), recording), (step, share) -> {}).verdict());
    }

    /** The stiffness is 40 % off, the damping is right. */
    @Test
    void theNumbersThatAreWrongAreNamed() {
        String sentence = Diagnoser.diagnose(Question.of(model(36000, 1500), recording(60000, 1500)), (step, share) -> {}).sentence();
        assertTrue(sentence.contains(" Surely wrong: stiffness of platform-seat, given 36.00 kN/m, found "), sentence);
        double found = Double
                .parseDouble(sentence.replaceFirst(".*stiffness of platform-seat, given 36.00 kN/m, found ([0-9.]+) kN/m.*", "$1"));
        assertEquals(60, found, 1.5);
        assertFalse(sentence.contains("damping"), sentence);
    }

    @Test
    void aSimulationThatIsNotThereIsNamed() {
        DataFault fault = assertThrows(DataFault.class, () -> new Question(model(1, 1), recording(60000, 1500),
                Optional.of(Channel.parse("nowhere.acc.z")), OptionalDouble.empty()));
        assertTrue(fault.getMessage().contains("nowhere.acc.z"), fault.getMessage());
    }

    @Test
    void aSimulationOfAnotherQuantityStandsForNothing() {
        Question question = new Question(model(1, 1), recording(60000, 1500), Optional.of(Channel.parse("platform.gyr.y")),
                OptionalDouble.empty());
        assertTrue(assertThrows(DataFault.class, question::asked).getMessage().contains("could stand for 0"));
    }

    private static Model model(double stiffness, double damping) {
        return new Model("seat", Optional.empty(), 'z', new Model.Base("platform", Optional.of(BASE)),
                List.of(new Model.Body("seat", 50, Optional.of(SEAT), List.of(), Optional.empty(), List.of())),
                List.of(new Model.Link("platform", "seat", stiffness, damping, Optional.empty(), List.of(), List.of())));
    }

    private static Recording recording(double stiffness, double damping) {
        Random random = new Random(9);
        double[] phase = random.doubles(150, 0, 2 * Math.PI).toArray();
        double[] base = new double[N];
        for (int j = 0; j < N; j++) {
            for (int k = 0; k < phase.length; k++) {
                base[j] += 0.08 * Math.min(1, j / RATE / 2) * Math.sin(2 * Math.PI * (0.5 + 0.08 * k) * j / RATE + phase[k]);
            }
        }
        double[] seat = new Simulator(new Excitation(RATE, base, Map.of())).outputs(model(stiffness, damping).assembly())[0];
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        channels.put(BASE, noisy(base, random));
        channels.put(SEAT, noisy(seat, random));
        channels.put(SIMULATED, seat);
        channels.put(Channel.parse("platform.gyr.y"), new double[N]);
        return new Recording(new Clock(0, RATE), channels, Metadata.NONE);
    }

    private static double[] noisy(double[] x, Random random) {
        double[] out = x.clone();
        for (int i = 0; i < out.length; i++) {
            out[i] += 0.01 * random.nextGaussian();
        }
        return out;
    }
}
