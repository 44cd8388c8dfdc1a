/**
 * Many {@link wbv.seat.Seat seats} in one process: recordings replayed as packets, or packets from files, a plain loop over seats, results
 * that a kill at any moment neither loses nor doubles. It needs no cluster and is the yardstick for one; {@link wbv.fleet.FleetEngine} is
 * the door to many machines, where the build has them.
 */
package wbv.fleet;
