/**
 * What a recording and a model may mean by their numbers: signs, units, which channel is which, and which carries nothing. Asked before any
 * physics is looked for: {@link wbv.diagnosis.convention.ConventionCheck} weighs each {@link wbv.diagnosis.convention.Convention} against
 * what the numbers of the model may be wrong by.
 */
package wbv.diagnosis.convention;
