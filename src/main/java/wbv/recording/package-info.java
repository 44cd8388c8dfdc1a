/**
 * Recordings of inertial sensors: channels over one clock, in SI units, and what is wrong with them.
 *
 * <p>A {@link wbv.recording.RowSource} is what can be read: a {@link wbv.recording.RecordingFile}, whatever its
 * format (CSV, ARFF, MT Manager, DOT, MVNX, any table by a {@link wbv.recording.ColumnMap}; gzip or not; recognised by content),
 * or a {@link wbv.recording.RecordingSet} of one-sensor files joined on their counters. It gives a stream of rows
 * ({@link wbv.recording.RowReader}), as they stand, with flat memory.
 *
 * <p>An {@link wbv.recording.Inspector} looks at every row once and gives an {@link wbv.recording.Inspection}: the clock, a
 * summary by channel, and a list of {@link wbv.recording.Finding}s. A {@link wbv.recording.UniformReader} lays the rows on that
 * clock and accounts for what it did in a {@link wbv.recording.Relay}. A {@link wbv.recording.Recording} is such a stream held in
 * memory; a {@link wbv.recording.RecordingWriter} writes one exactly, with a {@link wbv.recording.Sidecar} for what no column can
 * hold.
 *
 * <pre>{@code
 * RecordingFile file = new RecordingFile(Path.of("ride.csv.gz"));
 * Inspection inspection = file.inspect();
 * inspection.findings().forEach(finding -> System.out.println(finding.message()));
 * double[] head = file.load(inspection).values(Channel.parse("head.acc.z"));
 * }</pre>
 */
package wbv.recording;
