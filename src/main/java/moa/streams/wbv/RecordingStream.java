package moa.streams.wbv;

/** {@link wbv.stream.RecordingStream} where MOA's window looks for streams. */
public final class RecordingStream extends wbv.stream.RecordingStream {

    private static final long serialVersionUID = 1;
}
