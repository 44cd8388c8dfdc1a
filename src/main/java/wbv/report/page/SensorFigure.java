package wbv.report.page;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;

/** Where the sensors sit on a seated person, seen from the right, and what is wrong with each. */
public record SensorFigure(List<Sensor> sensors) implements Block {

    private static final double SPREAD = 19;

    /** Where parts of the body lie in the drawing, by words of their names; the first that fits counts. */
    private static final List<Part> PARTS = List.of(new Part(128, 34, "head", "helmet", "skull"), new Part(122, 76, "neck", "c7"),
            new Part(142, 124, "sternum", "chest", "stern"), new Part(121, 98, "shoulder", "acromion"),
            new Part(99, 118, "t1", "t4", "t8", "t12", "upper_back", "thorax", "spine"),
            new Part(94, 176, "lumbar", "l1", "l3", "l5", "back_low"),
            new Part(128, 132, "upper_arm", "upperarm"), new Part(164, 172, "forearm", "lower_arm"), new Part(196, 180, "hand", "wrist"),
            new Part(163, 210, "thigh", "femur", "upper_leg", "upperleg"), new Part(212, 206, "knee"),
            new Part(214, 262, "shank", "tibia", "lower_leg", "lowerleg", "shin"), new Part(236, 322, "foot", "ankle", "toe"),
            new Part(106, 212, "pelvis", "hip", "sacrum"), new Part(62, 130, "backrest", "seat_back", "back"),
            new Part(140, 238, "seat", "cushion"), new Part(52, 336, "platform", "base", "floor", "cabin"));

    private record Part(double x, double y, String... words) {

        private boolean fits(String name) {
            for (String word : words) {
                if (name.contains(word)) {
                    return true;
                }
            }
            return false;
        }
    }

    /**
     * A place with sensors.
     *
     * @param channels in short
     * @param tone of the worst found
     * @param words what is wrong, in a few words; empty if nothing is
     */
    public record Sensor(String place, String channels, Tiles.Tone tone, String words) {}

    public SensorFigure {
        sensors = List.copyOf(sensors);
    }

    private static Optional<double[]> spot(String place) {
        String name = place.toLowerCase(Locale.ROOT);
        boolean far = name.startsWith("left") || name.startsWith("l_") || name.endsWith("_l") || name.endsWith("_left");
        return PARTS.stream().filter(part -> part.fits(name)).findFirst()
                .map(part -> new double[] {part.x() - (far ? 15 : 0), part.y() - (far ? 12 : 0)});
    }

    /**
     * The drawing; empty if no place is one that it shows.
     *
     * @param escape makes text safe in markup
     */
    public String svg(UnaryOperator<String> escape) {
        StringBuilder dots = new StringBuilder();
        List<double[]> taken = new ArrayList<>();
        for (int i = 0; i < sensors.size(); i++) {
            Optional<double[]> spot = spot(sensors.get(i).place());
            if (spot.isPresent()) {
                double[] at = apart(spot.get(), taken);
                taken.add(at);
                dots.append(String.format(Locale.ROOT, "<g class=\"%s\"><circle cx=\"%.0f\" cy=\"%.0f\" r=\"9\"/><text x=\"%.0f\""
                        + " y=\"%.1f\">%d</text></g>\n", sensors.get(i).tone().name().toLowerCase(Locale.ROOT), at[0], at[1], at[0],
                        at[1] + 3.7, i + 1));
            }
        }
        return dots.length() == 0 ? ""
                : "<svg viewBox=\"10 0 270 352\" role=\"img\" aria-label=\"" + escape.apply("A seated person from the"
                        + " right, with a numbered dot for every sensor: "
                        + sensors.stream().map(Sensor::place).collect(Collectors.joining(", ")))
                        + "\">\n" + PERSON + dots + "</svg>\n";
    }

    /** Moves a dot aside that would hide another. */
    private static double[] apart(double[] spot, List<double[]> taken) {
        double[] at = spot.clone();
        for (int i = 0; i < 8 && taken.stream().anyMatch(other -> Math.hypot(other[0] - at[0], other[1] - at[1]) < SPREAD - 2); i++) {
            at[0] += SPREAD;
        }
        return at;
    }

    private static final String PERSON = """
            <g class="chair"><path d="M26 336H262" stroke-width="11"/><path d="M128 246V331" stroke-width="11"/>\
            <path d="M84 240H186" stroke-width="15"/><path d="M70 236L56 96" stroke-width="11"/></g>
            <g class="person"><circle cx="127" cy="38" r="23"/><path class="limb" d="M122 56L117 92" stroke-width="18"/>\
            <path d="M97 92C108 80 132 82 140 98C150 118 148 150 144 176C142 196 140 214 132 226C112 234 90 232 82 222C76 206 80 186 84 168\
            C88 144 84 112 97 92Z"/><path class="limb" d="M104 212L203 207" stroke-width="35"/>\
            <path class="limb" d="M208 210L213 302" stroke-width="24"/>\
            <path d="M201 302H226C228 312 248 316 256 322C260 326 258 330 254 330H201Z"/></g>
            <g class="arm"><path class="rim" d="M114 104L128 166L190 180" stroke-width="21"/>\
            <path d="M114 104L128 166L190 180" stroke-width="15"/></g>
            """;
}
