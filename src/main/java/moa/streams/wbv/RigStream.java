package moa.streams.wbv;

/** {@link wbv.stream.RigStream} where MOA's window looks for streams. */
public final class RigStream extends wbv.stream.RigStream {

    private static final long serialVersionUID = 1;
}
