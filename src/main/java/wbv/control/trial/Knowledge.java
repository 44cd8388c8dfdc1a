package wbv.control.trial;

/** What a controller knows of who sits there. */
public enum Knowledge {
    /** The middle sitter, whoever sits there. */
    FIXED("fixed"),
    /** What streaming estimators find. */
    SCHEDULED("scheduled"),
    /** The body that is really there, and how soft it is now, as one mass on a spring. */
    ORACLE("oracle");

    private final String word;

    Knowledge(String word) {
        this.word = word;
    }

    /** As results call it. */
    public String word() {
        return word;
    }
}
