/**
 * One seat of a live stream or of a fleet: {@link wbv.seat.Packet packets} of samples in, {@link wbv.seat.SeatResult results} out.
 *
 * <p>A {@link wbv.seat.Seat} puts packets in order, drops what came twice, counts what is lost, follows the body, measures the
 * exposure and tells the state. It knows sensor time alone, no clock on the wall and no engine, so that the same packets give the
 * same results wherever and whenever they are replayed; and its whole memory can be saved and loaded.
 */
package wbv.seat;
