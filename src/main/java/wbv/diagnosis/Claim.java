package wbv.diagnosis;

/**
 * What can be answered.
 *
 * @param name of a mechanism with its place, several joined where they act together; else empty
 */
record Claim(Kind kind, String name) {

    enum Kind {
        /** The model is right, with other values. */
        VALUES,
        /** A mechanism of the library, or several. */
        NAMED,
        /** Something that is in no library. */
        ELSE
    }

    static final Claim VALUES = new Claim(Kind.VALUES, "");
    static final Claim UNKNOWN = new Claim(Kind.ELSE, "");

    static Claim named(String name) {
        return new Claim(Kind.NAMED, name);
    }
}
