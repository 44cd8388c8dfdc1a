/**
 * Recordings in files: CSV, ARFF, MT Manager, DOT, MVNX, the {@linkplain wbv.recording.signals files of signals} and any table by a
 * {@link wbv.recording.format.ColumnMap}; gzip or not, recognised by content.
 *
 * <p>A {@link wbv.recording.format.RecordingFile} is a {@link wbv.recording.inspect.RowSource} whatever its
 * {@link wbv.recording.format.Format}; a {@link wbv.recording.format.RecordingSet} joins files of one sensor each on their
 * counters; a {@link wbv.recording.format.RecordingWriter} writes a recording exactly, with a
 * {@link wbv.recording.format.Sidecar} for what no column can hold.
 *
 * <pre>{@code
 * RecordingFile file = new RecordingFile(Path.of("ride.csv.gz"));
 * Inspection inspection = file.inspect();
 * inspection.findings().forEach(finding -> System.out.println(finding.message()));
 * double[] head = file.load(inspection).values(Channel.parse("head.acc.z"));
 * }</pre>
 *
 * <p>A new format is a case of {@link wbv.recording.format.Format} that recognises its head and opens a reader of rows.
 */
package wbv.recording.format;
