/**
 * What a recording of inertial sensors is: channels over one clock, in SI units, row by row or held in memory; and how files are
 * written whole.
 *
 * <p>A {@link wbv.recording.RowReader} is a stream of rows with flat memory, of {@link wbv.recording.Channel}s that each have a
 * {@link wbv.recording.Quantity}. A {@link wbv.recording.Recording} is such a stream held in memory. Bad input is a
 * {@link wbv.recording.DataFault}: one line that names the file, the line and the channel. An {@link wbv.recording.AtomicFile}
 * appears under its name whole or not at all.
 *
 * <p>{@code wbv.recording.inspect} looks at rows before they are used and lays them on a uniform clock;
 * {@code wbv.recording.format} reads and writes files. Neither is known here.
 */
package wbv.recording;
