/**
 * A fleet on several machines with Apache Flink: packets keyed by seat, each seat's memory in Flink's checkpoints in the form of
 * {@link wbv.snapshot}, results that a machine's death neither loses nor doubles. Built by the profile 'fleet' alone; nothing imports
 * it, {@link wbv.fleet.FleetEngine} finds it.
 */
package wbv.fleet.flink;
