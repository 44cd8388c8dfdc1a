/**
 * Lumped-parameter models of sitter and seat: bodies, links with linear stiffness and damping and any number of further laws,
 * sensors with their faults; and their files.
 *
 * <p>With q the displacements relative to the base, M the masses, E the incidence of the links, K and C their stiffness and
 * damping, Φ the forces of the laws and a the base's acceleration, everything here solves
 *
 * <pre>  M q'' + E C Eᵀ q' + E K Eᵀ q = -M 1 a - E Φ(r, r', t) + f,     r = Eᵀ q,     y = q'' + a</pre>
 *
 * <p>{@code wbv.body.number} holds what a model's numbers are, {@code wbv.body.law} what a link can do beyond linear stiffness and
 * damping, {@code wbv.body.simulate} moves a model.
 */
package wbv.body;
