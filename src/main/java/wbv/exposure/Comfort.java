package wbv.exposure;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/** Likely reactions to a total value in public transport (ISO 2631-1:1997 Annex C.2.3); their ranges overlap. */
public enum Comfort {
    NOT("not uncomfortable", 0, 0.315),
    A_LITTLE("a little uncomfortable", 0.315, 0.63),
    FAIRLY("fairly uncomfortable", 0.5, 1),
    UNCOMFORTABLE("uncomfortable", 0.8, 1.6),
    VERY("very uncomfortable", 1.25, 2.5),
    EXTREMELY("extremely uncomfortable", 2, Double.POSITIVE_INFINITY);

    private final String words;
    private final double from;
    private final double to;

    Comfort(String words, double from, double to) {
        this.words = words;
        this.from = from;
        this.to = to;
    }

    /** As a sentence says it: "a little uncomfortable". */
    public String words() {
        return words;
    }

    /** All reactions whose range holds a total value a_v [m/s²], mildest first. */
    public static List<Comfort> of(double total) {
        return Arrays.stream(values()).filter(reaction -> total >= reaction.from && total < reaction.to).toList();
    }

    /** The reactions to a total value [m/s²] in words. */
    public static String words(double total) {
        return of(total).stream().map(Comfort::words).collect(Collectors.joining(" to "));
    }
}
