package wbv.diagnosis.learn;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import java.util.stream.Stream;

/**
 * Sentences with the first terms on one fit: whether a law may be one is asked before it is learned, and both begin with them. Threads may
 * share it.
 */
final class Openings {

    private final Map<Asked, Opening> known = new ConcurrentHashMap<>();

    /** A ground, itself and equal to no copy. */
    private record Asked(int link, Object ground) {}

    /**
     * What was found from one ground or two.
     *
     * @param likely forms of the terms that gained most from the last of them
     */
    record Opening(List<LawLearner.Sentence> sentences, List<String> likely) {

        Opening {
            sentences = List.copyOf(sentences);
            likely = List.copyOf(likely);
        }

        /** With what was found later. */
        Opening and(Opening later) {
            return new Opening(Stream.concat(sentences.stream(), later.sentences.stream()).toList(), later.likely);
        }
    }

    /**
     * What a ground shows in a link.
     *
     * @param ground told by being the same object, or equal to it
     * @param find works it out if nobody asked
     */
    Opening once(int link, Object ground, Supplier<Opening> find) {
        Asked asked = new Asked(link, ground);
        Opening opening = known.containsKey(asked) ? known.get(asked) : find.get();
        known.put(asked, opening);
        return opening;
    }
}
