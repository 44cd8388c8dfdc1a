package wbv.diagnosis.fit;

import java.util.List;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.function.Function;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;

/**
 * Work for all cores, of which each takes the next piece as soon as it is free: pieces differ so much in length that shares dealt out
 * beforehand leave cores idle. Answers stand in the order of what was asked, and do not depend on how many cores there are.
 */
public final class Parallel {

    private Parallel() {}

    /** The answers to all questions. */
    public static <T, R> List<R> map(List<T> questions, Function<? super T, ? extends R> answer) {
        AtomicReferenceArray<R> answers = new AtomicReferenceArray<>(questions.size());
        each(questions.size(), i -> answers.set(i, answer.apply(questions.get(i))));
        return IntStream.range(0, questions.size()).<R>mapToObj(answers::get).toList();
    }

    /** Does the work for all of 0 to count - 1. */
    public static void each(int count, IntConsumer work) {
        AtomicInteger next = new AtomicInteger();
        int hands = Math.min(count, ForkJoinPool.getCommonPoolParallelism() + 1);
        IntStream.range(0, hands).parallel().forEach(hand -> {
            for (int i = next.getAndIncrement(); i < count; i = next.getAndIncrement()) {
                work.accept(i);
            }
        });
    }
}
