package wbv.network;

/**
 * What one epoch came to, to single precision: a training that is gone on with from its checkpoint tells the same.
 *
 * @param train loss on the trials learned from [1]
 * @param held  loss on trials held back [1]
 * @param rmse  root mean square of all standardised errors [1] on trials held back
 */
public record Losses(double train, double held, double rmse) {

    public Losses {
        train = (float) train;
        held = (float) held;
        rmse = (float) rmse;
    }
}
