package wbv.network;

import org.junit.jupiter.api.Assumptions;
import wbv.recording.DataFault;

/** Skips tests that need PyTorch's library where the build has none for the platform. */
public final class WithEngine {

    private WithEngine() {}

    public static void orSkip() {
        try {
            PyTorch.engine();
        } catch (DataFault missing) {
            Assumptions.abort(missing.getMessage());
        }
    }
}
