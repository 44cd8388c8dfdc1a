package wbv.network;

/**
 * What one epoch came to.
 *
 * @param train loss on the trials learned from
 * @param held  loss on trials held back
 * @param rmse  root mean square of all standardised errors on trials held back
 */
public record Losses(double train, double held, double rmse) { }
