package wbv.diagnosis;

/**
 * What can be answered.
 *
 * @param name of a mechanism with its place, several joined where they act together; the place of something else; empty where nothing is
 *             missing
 * @param like mechanism with its place that something else is like; empty where there is none
 */
record Claim(Kind kind, String name, String like) {

    enum Kind {
        /** The model is right as given. */
        NOTHING,
        /** It is, with other values. */
        VALUES,
        /** A mechanism of the library, or several. */
        NAMED,
        /** Something else at a place, alone or beside a mechanism of which it leaves no more than a likeness. */
        ELSE
    }

    static final Claim NOTHING = new Claim(Kind.NOTHING, "", "");
    static final Claim VALUES = new Claim(Kind.VALUES, "", "");

    static Claim named(String name) {
        return new Claim(Kind.NAMED, name, "");
    }

    static Claim elseAt(String place, String like) {
        return new Claim(Kind.ELSE, place, like);
    }

    boolean isPhysics() {
        return kind == Kind.NAMED || kind == Kind.ELSE;
    }
}
