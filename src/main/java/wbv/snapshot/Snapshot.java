package wbv.snapshot;

/**
 * What has memory and can be kept: loaded into an object that was made alike, its state continues bit for bit.
 *
 * <p>Only what the next sample depends on is written. What an object was made of (rates, recipes, models) is not: whoever makes
 * it knows that, or writes it in front.
 */
public interface Snapshot {

    /** Writes the state. Changes nothing. */
    void save(StateWriter out);

    /**
     * Takes a state that {@link #save} of an object made alike has written. After a fault the state is that of neither.
     *
     * @throws wbv.recording.DataFault if the bytes hold another kind of state
     */
    void load(StateReader in);
}
