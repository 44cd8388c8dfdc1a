/**
 * Recordings of inertial sensors: channels over one clock, in SI units, and what is wrong with them.
 *
 * <p>A file is read as a stream of rows ({@link wbv.recording.RowReader}), whatever its format and its size. An
 * {@link wbv.recording.Inspector} looks at every row once and lists what it found; a
 * {@link wbv.recording.UniformReader} lays the rows on a uniform clock and says what it did. A
 * {@link wbv.recording.Recording} is such a stream held in memory.
 */
package wbv.recording;
