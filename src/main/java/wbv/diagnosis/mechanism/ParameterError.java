package wbv.diagnosis.mechanism;

import java.util.Optional;

/** The model's own numbers: no physics is missing. */
public record ParameterError() implements Mechanism {

    @Override
    public Entry entry() {
        return new Entry("parameters", Family.NUMBERS, "Only the numbers of %s are wrong");
    }

    @Override
    public Optional<String> against(Mechanism rival) {
        return rival.family() != Family.DYNAMIC ? Optional.empty()
                : Optional.of("Press the link with a known weight and see how far it gives: "
                        + "a memory leaves the slow stiffness where the model has it, a wrong number does not.");
    }
}
