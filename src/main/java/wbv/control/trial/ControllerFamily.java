package wbv.control.trial;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import wbv.control.OptimalSeat;
import wbv.control.PassiveSeat;
import wbv.control.SeatController;
import wbv.control.SitterSource;
import wbv.control.SkyhookSeat;

/** Kinds of controllers, each with one number to tune. */
public enum ControllerFamily {
    /** Tuned by its damping. */
    PASSIVE("passive", "a damper that nobody adjusts", "N·s/m", false, 200, 400, 800, 1600),
    /** By the sky's damping. */
    SKYHOOK("skyhook", "semi-active damper, skyhook, continuous", "N·s/m", false, 300, 700, 1500, 3500),
    /** By the higher damping. */
    ON_OFF("skyhook-on-off", "semi-active damper, skyhook, on and off", "N·s/m", false, 250, 500, 1000, 2000),
    /** By the price of stroke. */
    CLIPPED("clipped-lqg", "semi-active damper, linear quadratic Gaussian, clipped", "(m/s²)² for 20 mm", true, 0.05, 0.4, 3, 20, 120),
    /** By the price of stroke. */
    ACTIVE("active-lqg", "actuator, linear quadratic Gaussian", "(m/s²)² for 20 mm", true, 0.05, 0.4, 3, 20, 120),
    /** By the price of stroke. */
    WORST("active-h-infinity", "actuator, H∞", "(m/s²)² for 20 mm", true, 0.05, 0.4, 3, 20, 120);

    private final String word;
    private final String description;
    private final String unit;
    private final boolean knows;
    private final double[] tunings;

    ControllerFamily(String word, String description, String unit, boolean knows, double... tunings) {
        this.word = word;
        this.description = description;
        this.unit = unit;
        this.knows = knows;
        this.tunings = tunings;
    }

    /** As the command line calls it. */
    public String word() {
        return word;
    }

    /** What it is, in words. */
    public String description() {
        return description;
    }

    /** Of the number that is tuned. */
    public String unit() {
        return unit;
    }

    /** What it may know of the sitter, {@link Knowledge#FIXED} first. */
    public List<Knowledge> knowledge() {
        return knows ? List.of(Knowledge.values()) : List.of(Knowledge.FIXED);
    }

    /** Whether it sets a damper while it rides, which needs no power. */
    public boolean setsDamper() {
        return this == SKYHOOK || this == ON_OFF || this == CLIPPED;
    }

    /** Values over which it is tuned, in its own {@link #unit}, rising: a series. A copy. */
    public double[] tunings() {
        return tunings.clone();
    }

    /** @param sitter whom it believes in; passed over by those that know nobody */
    SeatController controller(Maker maker, double tuning, SitterSource sitter) {
        return switch (this) {
            case PASSIVE -> new PassiveSeat(maker.hardware(), tuning);
            case SKYHOOK -> new SkyhookSeat(maker.hardware(), SkyhookSeat.Kind.CONTINUOUS, tuning);
            case ON_OFF -> new SkyhookSeat(maker.hardware(), SkyhookSeat.Kind.ON_OFF, tuning);
            case CLIPPED -> optimal(maker, OptimalSeat.Drive.DAMPER, OptimalSeat.Aim.MEAN, tuning, sitter);
            case ACTIVE -> optimal(maker, OptimalSeat.Drive.ACTUATOR, OptimalSeat.Aim.MEAN, tuning, sitter);
            case WORST -> optimal(maker, OptimalSeat.Drive.ACTUATOR, OptimalSeat.Aim.WORST, tuning, sitter);
        };
    }

    private static SeatController optimal(Maker maker, OptimalSeat.Drive drive, OptimalSeat.Aim aim, double tuning, SitterSource sitter) {
        return new OptimalSeat(maker.hardware(), drive, aim, maker.floor().band(), tuning, sitter);
    }

    /** All as the command line calls them. */
    public static List<String> words() {
        return Arrays.stream(values()).map(ControllerFamily::word).toList();
    }

    /** The one that the command line calls so. */
    public static Optional<ControllerFamily> named(String word) {
        return Arrays.stream(values()).filter(family -> family.word.equals(word)).findFirst();
    }
}
