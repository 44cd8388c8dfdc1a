package wbv.diagnosis.fit;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;

/**
 * What was found out about some evidence and is asked for again: answers are a matter of the evidence alone, whoever asks. Threads may
 * share it; two that ask at once both work, and find the same.
 */
public final class Known {

    private final Map<Question<?>, Object> answers = new ConcurrentHashMap<>();

    /**
     * What may be asked more than once, told by being equal.
     *
     * @param <A> what the answer is; it holds no {@code null}
     */
    public interface Question<A> {}

    /**
     * What is left while whatever enters at some places is ignored.
     *
     * @param places ignored
     * @param x where the model fits then: coordinates [1], one a knob
     * @param reduced mean square of the whitened residual that is left, of what still shows
     */
    public record Ignoring(List<Place> places, double[] x, double reduced) {}

    /**
     * Whatever is asked for more than once.
     *
     * @param <A> what the answer is
     * @param find works it out if nobody asked
     */
    @SuppressWarnings("unchecked")   // a question is kept with nothing but an answer to it
    public <A> A once(Question<A> question, Supplier<A> find) {
        Object found = answers.containsKey(question) ? answers.get(question) : find.get();
        answers.put(question, found);
        return (A) found;
    }
}
