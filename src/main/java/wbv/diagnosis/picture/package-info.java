/**
 * What is drawn of a diagnosis, as numbers: {@link wbv.diagnosis.picture.Pictures} holds the views of all outputs and the
 * {@link wbv.diagnosis.picture.Portrait portraits} of what was found.
 */
package wbv.diagnosis.picture;
