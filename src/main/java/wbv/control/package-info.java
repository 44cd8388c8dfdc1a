/**
 * Suspension seats that are controlled, and controllers that know who sits on them.
 *
 * <p>A {@link wbv.control.SeatController} takes what the seat's sensors say ({@link wbv.control.SeatReadings}) and says what damper
 * or actuator shall do ({@link wbv.control.SeatCommand}), a sample at a time, allocating nothing: {@link wbv.control.PassiveSeat},
 * {@link wbv.control.SkyhookSeat} and {@link wbv.control.OptimalSeat}, which designs itself for the mean or for
 * the worst for the sitter whom a {@link wbv.control.SitterSource} tells: one who never changes, one who is told, or the one that
 * streaming estimators find. Riccati's equations are solved by {@link wbv.control.DiscreteRiccati}, a doubling a sample.
 *
 * <p>How any of them does on a seat, with friction, stops and a person of the virtual rig, is asked in {@code wbv.control.trial}.
 */
package wbv.control;
