package wbv.state.mixture;

import java.util.Arrays;
import java.util.stream.IntStream;

/** Counts how many components minimum message length finds in the classical test mixtures, seed by seed. Argument: seeds. */
public final class MessageLengthProof {

    private MessageLengthProof() {}

    public static void main(String[] words) {
        int seeds = Integer.parseInt(words[0]);
        System.out.println("| mixture | components | found right | found more | found fewer |\n|---|---|---|---|---|");
        for (ClassicalMixtures mixture : ClassicalMixtures.values()) {
            int[] found = IntStream.range(0, seeds).map(mixture::found).toArray();
            int k = mixture.components();
            System.out.println("| " + mixture + " | " + k + " | " + Arrays.stream(found).filter(f -> f == k).count() + " of "
                    + seeds
                    + " | " + Arrays.stream(found).filter(f -> f > k).count() + " | " + Arrays.stream(found).filter(f -> f < k)
                            .count()
                    + " |");
        }
    }
}
