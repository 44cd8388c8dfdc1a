/**
 * A user's own simulator as a functional mock-up unit (FMI 2.0.4 and 3.0.1, Modelica Association): co-simulation and model exchange, run on
 * what was recorded.
 *
 * <p>{@link wbv.fmi.FmuSimulation} is the whole: its inputs are recorded channels, its outputs are channels, its tunable parameters are
 * what may be wrong, inputs that are forces and were not recorded are places where one may be missing. {@link wbv.fmi.Description} is what
 * the unit says of itself, {@link wbv.fmi.Instance} the few calls made of it, with an implementation for each version; every native call
 * goes through {@link wbv.fmi.Binary}.
 */
package wbv.fmi;
