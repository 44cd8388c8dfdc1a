package wbv.recording.inspect;

/** Tells rows in order of time from those that are not: one that lies before its predecessor, or beyond its sound successor. */
final class Order {

    private double last = Double.NEGATIVE_INFINITY;

    /**
     * True if a row belongs into the order.
     *
     * @param following time of the row after it; infinite at the end
     */
    boolean keeps(double time, double following) {
        boolean early = time < last;
        boolean late = following < time && following >= last;
        if (early || late) {
            return false;
        }
        last = time;
        return true;
    }
}
