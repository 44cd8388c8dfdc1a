package wbv.diagnosis.fit;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;

/**
 * What was found out about some evidence and is asked for again: answers are a matter of the evidence alone, whoever asks. Threads may
 * share it; two that ask at once both work, and find the same.
 */
public final class Known {

    private final AtomicReference<Optional<Evidence>> brief = new AtomicReference<>();
    private final AtomicReference<Fitter.State> base = new AtomicReference<>();
    private final Map<At, List<Ignoring>> places = new ConcurrentHashMap<>();
    private final Map<About, Object> others = new ConcurrentHashMap<>();

    /** A model at coordinates; each is itself and equal to no copy. */
    private record At(Candidate on, double[] x) {}

    /** Something that rests on a fit. */
    private record About(Fitter.State fit, Class<?> what) {}

    /** A part that is shaken hard, see {@link Evidence#brief}. */
    Optional<Evidence> brief(Supplier<Optional<Evidence>> find) {
        return once(brief, find);
    }

    /** The user's model fitted. */
    public Fitter.State base(Supplier<Fitter.State> fit) {
        return once(base, fit);
    }

    /**
     * What is left while whatever enters at some places is ignored.
     *
     * @param places ignored
     * @param x where the model fits then: coordinates [1], one a knob
     * @param reduced mean square of the whitened residual that is left, of what still shows
     */
    public record Ignoring(List<Place> places, double[] x, double reduced) {}

    /**
     * All places one by one.
     *
     * @param x where fits start, coordinates [1], one a knob, told by being the same array: kept and not modified.
     * @param find works them out if nobody asked
     */
    public List<Ignoring> places(Candidate on, double[] x, Supplier<List<Ignoring>> find) {
        At at = new At(on, x);
        List<Ignoring> found = places.containsKey(at) ? places.get(at) : find.get();
        places.put(at, found);
        return found;
    }

    /**
     * Whatever else rests on a fit and is asked for more than once.
     *
     * @param fit told by being the same
     * @param what of which there is one for each fit
     * @param begin makes it if nobody asked
     */
    public <T> T about(Fitter.State fit, Class<T> what, Supplier<T> begin) {
        return what.cast(others.computeIfAbsent(new About(fit, what), asked -> begin.get()));
    }

    private static <T> T once(AtomicReference<T> known, Supplier<T> find) {
        T found = Optional.ofNullable(known.get()).orElseGet(find);
        known.set(found);
        return found;
    }
}
