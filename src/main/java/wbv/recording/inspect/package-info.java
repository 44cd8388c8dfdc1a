/**
 * What is wrong with a recording, and its rows laid on one clock.
 *
 * <p>A {@link wbv.recording.inspect.RowSource} is what can be read, a file or a set of them. An
 * {@link wbv.recording.inspect.Inspector} looks at every row once and gives an {@link wbv.recording.inspect.Inspection}: the
 * clock, a summary by channel, and a list of {@link wbv.recording.inspect.Finding}s, each with advice. A
 * {@link wbv.recording.inspect.UniformReader} lays the rows on that clock and accounts for what it did in a
 * {@link wbv.recording.inspect.Relay}.
 *
 * <p>A new kind of finding is a record in {@link wbv.recording.inspect.Finding} and a detector that makes it.
 */
package wbv.recording.inspect;
