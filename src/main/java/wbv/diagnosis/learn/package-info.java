/**
 * The law of a link that has no name in the library: {@link wbv.diagnosis.learn.LatentEstimator} finds the force that the recording asks
 * for, {@link wbv.diagnosis.learn.Grammar} holds the terms of which laws are made, and {@link wbv.diagnosis.learn.LawLearner} takes the
 * sentence of them that foretells data that were not used.
 */
package wbv.diagnosis.learn;
