/**
 * What a link can do beside its linear stiffness and damping: one record a law, each with its source, its units and its closed
 * form.
 *
 * <p>A {@link wbv.body.law.Law} gives the force of a link's motion ({@link wbv.body.law.LinkMotion}) and its slopes. Laws with
 * memory carry a state. {@link wbv.body.law.Learned} laws come from data. A new law is a record that {@link wbv.body.law.Law}
 * permits, its components annotated with their {@link wbv.body.number.Key}s.
 */
package wbv.body.law;
