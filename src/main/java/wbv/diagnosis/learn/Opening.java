package wbv.diagnosis.learn;

import java.util.List;
import java.util.stream.Stream;

/**
 * Sentences with the first terms, from one ground or two.
 *
 * @param likely forms of the terms that gained most from the last of them
 */
record Opening(List<Sentence> sentences, List<String> likely) {

    /** Where nothing could be begun. */
    static final Opening NONE = new Opening(List.of(), List.of());

    Opening {
        sentences = List.copyOf(sentences);
        likely = List.copyOf(likely);
    }

    /** With what was found later. */
    Opening and(Opening later) {
        return new Opening(Stream.concat(sentences.stream(), later.sentences.stream()).toList(), later.likely);
    }
}
