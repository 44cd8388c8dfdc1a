package wbv.seat;

/**
 * Something that somebody should know.
 *
 * @param time   of the sample at which it was noticed, by the sensor's clock [s]
 * @param reason in words
 */
public record SeatAlarm(Kind kind, double time, String reason) {

    /** Kinds, the gravest first. */
    public enum Kind {
        /** The exposure limit value is reached. */
        LIMIT_VALUE("limit-value"),
        /** The exposure action value is reached. */
        ACTION_VALUE("action-value"),
        /** A body is not what it was. */
        BODY_CHANGED("body-changed"),
        /** An estimate left what a body can be, and began anew. */
        ESTIMATE_LOST("estimate-lost"),
        /** The sensor's counter or clock began again. */
        SENSOR_RESTARTED("sensor-restarted"),
        /** Samples are missing for half a second or more. */
        SAMPLES_LOST("samples-lost");

        private final String word;

        Kind(String word) {
            this.word = word;
        }

        /** Its name in results. */
        public String word() {
            return word;
        }
    }
}
