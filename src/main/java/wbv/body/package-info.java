/**
 * Lumped-parameter models of sitter and seat on one axis: bodies, links with linear stiffness and damping and any number of
 * further laws, sensors with their faults.
 *
 * <p>With q the displacements relative to the base, M the masses, E the incidence of the links, K and C their stiffness and
 * damping, Φ the forces of the laws and a the base's acceleration, everything here solves
 *
 * <pre>  M q'' + E C Eᵀ q' + E K Eᵀ q = -M 1 a - E Φ(r, r', t) + f,     r = Eᵀ q,     y = q'' + a</pre>
 *
 * <p>A model is moved by its base's measured acceleration, velocity or position, or by measured forces on bodies while its base
 * rests. Where both ends of a link move as measured, {@link wbv.body.DrivenLinks} evaluates what it carries along the stroke.
 *
 * <p>{@link wbv.body.SpectralResponse} solves the linear part in the frequency domain; {@link wbv.body.FreeRun} steps it exactly
 * in time with implicit laws. Both give the sensitivity to every parameter.
 */
package wbv.body;
