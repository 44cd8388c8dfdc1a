package wbv.diagnosis.search;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Start;

/**
 * Laws about as strong as the link that they act in, to start from. Screening sees a law as it would be if it were weak, beside a model
 * that has bent itself to make up for it: of a strong one that tells neither the size nor, at times, the sign.
 */
final class StrongStarts {

    /** Force of a law over what the model carries in its link, root mean squares [1]: fits reach what lies between and beyond. */
    private static final double[] SHARES = {-2, -0.5, 0.5, 2};

    private final Screening screening;

    /**
     * Along the motion at a fit.
     *
     * @param screening at that fit
     */
    StrongStarts(Screening screening) {
        this.screening = screening;
    }

    /** Values of a hypothesis, each in its unit; none where no law has a size that can be chosen. */
    List<double[]> of(Hypothesis hypothesis) {
        return !Screening.isInLink(hypothesis) ? List.of()
                : hypothesis.starts().stream().filter(start -> !start.columns().isEmpty()).flatMap(start -> of(hypothesis, start)).toList();
    }

    private Stream<double[]> of(Hypothesis hypothesis, Start start) {
        double each = screening.share(hypothesis, sized(hypothesis, start, 1));
        return Arrays.stream(SHARES).mapToObj(share -> sized(hypothesis, start, share / each)).filter(values -> canBe(hypothesis, values));
    }

    private static double[] sized(Hypothesis hypothesis, Start start, double factor) {
        double[] all = new double[start.columns().size()];
        Arrays.fill(all, factor);
        return Screening.sized(hypothesis, start, all);
    }

    private static boolean canBe(Hypothesis hypothesis, double[] values) {
        for (int i = 0; i < values.length; i++) {
            Hypothesis.Number number = hypothesis.numbers().get(i);
            if (!(values[i] >= number.low() && values[i] <= number.high())) {
                return false;
            }
        }
        return true;
    }
}
