package wbv.diagnosis.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Every piece of work is done once, and answers stand where their questions stood. */
class ParallelTest {

    private static final int MANY = 1000;

    @Test
    void answersStandInTheOrderOfTheQuestions() {
        List<Integer> questions = IntStream.range(0, MANY).boxed().toList();
        assertEquals(IntStream.range(0, MANY).mapToObj(i -> "no " + i).toList(), Parallel.map(questions, i -> "no " + i));
        assertEquals(List.of(), Parallel.map(List.of(), i -> i));
    }

    @Test
    void eachIsDoneOnceWithinOthersToo() {
        AtomicIntegerArray done = new AtomicIntegerArray(MANY);
        Parallel.each(10, i -> Parallel.each(MANY / 10, j -> done.incrementAndGet(MANY / 10 * i + j)));
        for (int i = 0; i < MANY; i++) {
            assertEquals(1, done.get(i), "piece " + i);
        }
    }

    @Test
    void whatFailsIsNotLost() {
        assertThrows(IllegalStateException.class, () -> Parallel.each(MANY, i -> {
            if (i == MANY / 2) {
                throw new IllegalStateException("no");
            }
        }));
    }
}
