/**
 * How the platform is driven: each {@link wbv.rig.platform.Axis} by random motion, sweeps and the events of a ride, as a
 * {@link wbv.rig.platform.Program} puts them together, and every random source from one seed ({@link wbv.rig.platform.Seeds}).
 */
package wbv.rig.platform;
