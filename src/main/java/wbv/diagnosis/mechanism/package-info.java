/**
 * The mechanisms that a model may lack, one file each: the word, what it adds to a model and where, from which sizes a search for it
 * starts, and what a reader has to know of it. {@link wbv.diagnosis.mechanism.Library} lists them; a further one is a further file and its
 * entry there.
 */
package wbv.diagnosis.mechanism;
