/**
 * Models that move: by their base's measured acceleration, velocity or position, or by measured forces on bodies while the base
 * rests.
 *
 * <p>{@link wbv.body.simulate.SpectralResponse} solves the linear part in the frequency domain;
 * {@link wbv.body.simulate.FreeRun} steps it exactly in time with implicit laws. Both give the sensitivity to every parameter.
 * Where both ends of a link move as measured, {@link wbv.body.simulate.DrivenLinks} evaluates what it carries along the stroke.
 */
package wbv.body.simulate;
