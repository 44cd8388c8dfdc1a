package wbv.network;

/**
 * What is to be trained: the same order gives the same model, on the same kind of processor to the last bit.
 *
 * @param bodies       what the trials are drawn from
 * @param images       trials, one image each; a tenth of them is held back
 * @param dataSeed     of the trials
 * @param architecture of the network
 * @param settings     of the training; member i has their seed plus i
 * @param members      networks that will be asked together
 */
public record Order(Bodies bodies, int images, long dataSeed, Architecture architecture, Settings settings, int members) {

    /** One trial in so many is held back. */
    public static final int HELD_BACK = 10;

    private static final int MOST_FURTHER = 1000;

    public Order {
        if (images < 40) {
            throw new IllegalArgumentException("a network needs at least 40 images: " + images);
        }
        if (architecture.others() > bodies.channels().size() - 2) {
            throw new IllegalArgumentException(architecture.word() + " needs bodies whose base moves in three axes, as "
                    + Bodies.COUPLED.word() + ": " + bodies.word());
        }
        if (members < 1 || members > 20) {
            throw new IllegalArgumentException("members must be 1 to 20: " + members);
        }
    }

    /** Trials more, neither learned from nor held back, by which a model learns how sure it may be. */
    public int further() {
        return Math.min(MOST_FURTHER, images / 2);
    }
}
