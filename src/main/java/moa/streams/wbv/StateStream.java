package moa.streams.wbv;

/** {@link wbv.stream.StateStream} where MOA's window looks for streams. */
public final class StateStream extends wbv.stream.StateStream {

    private static final long serialVersionUID = 1;
}
