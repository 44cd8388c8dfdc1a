/**
 * The state of what follows a stream, as bytes that a later process goes on from: {@link wbv.snapshot.Snapshot} is the port,
 * {@link wbv.snapshot.StateWriter} and {@link wbv.snapshot.StateReader} the form. Bytes hold numbers in a fixed order behind
 * one version, and a checksum; no class name, no Java serialisation.
 */
package wbv.snapshot;
