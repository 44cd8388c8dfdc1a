package wbv.network;

import java.io.Serializable;

/**
 * One plane of an image: what is shown of one channel, or of two, at every frequency and moment.
 *
 * @param kind   what
 * @param first  number of the channel, from 0; of the exciting one where there are two
 * @param second number of the answering channel; the same as {@code first} where there is one
 */
public record ImagePlane(Kind kind, int first, int second) implements Serializable {

    /** What a plane shows. */
    public enum Kind {
        /** Natural logarithm of the magnitude. */
        LEVEL(false),
        /** The same less its mean over the image: how strong the shaking is as a whole says nothing of a linear body. */
        RELATIVE(false),
        /**
         * The thesis' own: natural logarithm of the magnitude of segments of 32 points, two-sided, constant and all, so that the lower
         * half repeats the upper.
         */
        TWO_SIDED(false),
        /** Level of the answer less that of the excitation. */
        GAIN(true),
        /** Cosine of the phase from excitation to answer. */
        COSINE(true),
        /** Sine of the same. */
        SINE(true);

        private final boolean pair;

        Kind(boolean pair) {
            this.pair = pair;
        }
    }

    public ImagePlane {
        if (first < 0 || second < 0 || kind.pair == (first == second)) {
            throw new IllegalArgumentException("a " + kind + " plane is of " + (kind.pair ? "two channels: " : "one channel: ")
                    + first + ", " + second);
        }
    }

    static ImagePlane of(Kind kind, int channel) {
        return new ImagePlane(kind, channel, channel);
    }

    /** As a card says it, such as {@code GAIN 0 1}. */
    @Override
    public String toString() {
        return kind + " " + first + " " + second;
    }

    /** @throws IllegalArgumentException if the text is no plane */
    static ImagePlane parse(String text) {
        String[] word = text.split(" ");
        if (word.length != 3) {
            throw new IllegalArgumentException("a plane is a kind and two channels, as GAIN 0 1: '" + text + "'");
        }
        try {
            return new ImagePlane(Kind.valueOf(word[0]), Integer.parseInt(word[1]), Integer.parseInt(word[2]));
        } catch (IllegalArgumentException none) {
            throw new IllegalArgumentException("a plane is a kind and two channels, as GAIN 0 1: '" + text + "'", none);
        }
    }
}
