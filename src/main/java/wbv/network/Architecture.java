package wbv.network;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.recording.Channel;

/** The networks, by the names that users give. */
public enum Architecture {

    /** The thesis' first: convolutions of 48 units, batch normalisation, ReLU, dropout, linear regression (Figure 8-3). */
    CNN("cnn", false, new Settings(30, 64, Settings.Method.MOMENTUM, 0.001, 20, 0.1, 0.2, 1)),
    /** The thesis' second: the same units in residual pairs (Figures 8-4 and 8-5). */
    RESIDUAL("residual", false, new Settings(30, 64, Settings.Method.MOMENTUM, 0.001, 20, 0.1, 0.2, 1)),
    /**
     * Ours: gain and phase beside level, filters along frequency alone, and at each frequency a mean over time weighted by what
     * the network itself thinks a moment is worth, for a linear body is the same at all moments. States its own uncertainty.
     */
    POOLED("pooled", true, new Settings(40, 32, Settings.Method.ADAM, 4e-3, 10, 0.3, 0, 1)),
    /**
     * The same where no sensor sits at the seat: it sees the answer's level alone, and knows of the excitation only what all
     * those that it was trained on have in common.
     */
    ANSWER_ONLY("answer-only", true, new Settings(40, 32, Settings.Method.ADAM, 4e-3, 10, 0.3, 0, 1)),
    /** {@link #POOLED} that also sees, in the same form, the base's motion in x and y beside the answer. */
    THREE_AXES("three-axes", true, new Settings(40, 32, Settings.Method.ADAM, 4e-3, 10, 0.3, 0, 1)),
    /**
     * {@link #CNN} with all that the thesis prints: three axes at both places in its own images, and its Table 8-1. "Dropout rate 0.1"
     * and "frequency 20" are read as factor and period of the learning rate, which have just these names in the tool whose half mean square
     * loss the thesis names; its dropout layer has 0.1 too, so that the other reading is met. Epochs are not printed.
     */
    THESIS_CNN("thesis-cnn", false, new Settings(30, 64, Settings.Method.MOMENTUM, 0.005, 20, 0.1, 0.1, 1)),
    /** {@link #RESIDUAL} likewise. */
    THESIS_RESIDUAL("thesis-residual", false, new Settings(30, 64, Settings.Method.MOMENTUM, 0.005, 20, 0.1, 0.1, 1));

    private final String word;
    private final boolean uncertain;
    private final Settings settings;

    Architecture(String word, boolean uncertain, Settings settings) {
        this.word = word;
        this.uncertain = uncertain;
        this.settings = settings;
    }

    /** The name, as users write it. */
    public String word() {
        return word;
    }

    /** Whether it predicts a variance with every value. */
    public boolean uncertain() {
        return uncertain;
    }

    /** Whether it looks at the excitation; if not, nobody can say whether a body would have moved so. */
    public boolean excited() {
        return this != ANSWER_ONLY;
    }

    /** How it is trained if nothing is said. */
    public Settings settings() {
        return settings;
    }

    /** What it looks at, of an excitation (channel 0), an answer (1) and what else moves the base (2 and on). */
    public Imaging imaging() {
        return new Imaging(switch (this) {
            case CNN, RESIDUAL -> List.of(ImagePlane.of(ImagePlane.Kind.LEVEL, 0), ImagePlane.of(ImagePlane.Kind.LEVEL, 1));
            case POOLED -> answered(0).toList();
            case THREE_AXES -> Stream.of(answered(0), answered(2), answered(3)).flatMap(planes -> planes).toList();
            case ANSWER_ONLY -> List.of(ImagePlane.of(ImagePlane.Kind.RELATIVE, 1));
            case THESIS_CNN, THESIS_RESIDUAL -> IntStream.range(0, 6).mapToObj(c -> ImagePlane.of(ImagePlane.Kind.TWO_SIDED, c)).toList();
        });
    }

    /** The channels that it looks at: excitation and answer, then the others of their axes that it sees, in the order of the planes. */
    public List<Channel> channels(Channel input, Channel output) {
        return switch (this) {
            case CNN, RESIDUAL, POOLED, ANSWER_ONLY -> List.of(input, output);
            case THREE_AXES -> Stream.concat(Stream.of(input, output), across(input)).toList();
            case THESIS_CNN, THESIS_RESIDUAL -> Stream.of(Stream.of(input, output), across(input), across(output))
                    .flatMap(channels -> channels).toList();
        };
    }

    private static Stream<Channel> across(Channel channel) {
        return "xyz".chars().filter(axis -> axis != channel.axis()).mapToObj(axis -> channel.along((char) axis));
    }

    /** Level of an excitation, gain and phase from it to the answer. */
    private static Stream<ImagePlane> answered(int excitation) {
        return Stream.of(ImagePlane.of(ImagePlane.Kind.RELATIVE, excitation), new ImagePlane(ImagePlane.Kind.GAIN, excitation, 1),
                new ImagePlane(ImagePlane.Kind.COSINE, excitation, 1), new ImagePlane(ImagePlane.Kind.SINE, excitation, 1));
    }

    /** Motions of the base, beside the excitation, that the fit after it is given. */
    public int others() {
        return this == THREE_AXES ? 2 : 0;
    }

    /** The architecture of a name; empty if there is none. */
    public static Optional<Architecture> named(String word) {
        return Arrays.stream(values()).filter(each -> each.word.equals(word)).findFirst();
    }

    /** All names. */
    public static List<String> words() {
        return Arrays.stream(values()).map(Architecture::word).toList();
    }
}
