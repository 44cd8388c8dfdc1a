package wbv.rig;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The effects that are on.
 *
 * @param on a set, copied
 */
public record Effects(Set<Effect> on) {

    /** Everything but packet loss. */
    public static final Effects USUAL = new Effects(EnumSet.complementOf(EnumSet.of(Effect.LOSS)));

    /** Ideal sensors on a linear sitter whose axes do not mix, without a cushion. */
    public static final Effects NONE = new Effects(Set.of());

    public Effects {
        on = Set.copyOf(on);
    }

    /** Whether an effect is on. */
    public boolean has(Effect effect) {
        return on.contains(effect);
    }

    /** These and another. */
    public Effects with(Effect effect) {
        EnumSet<Effect> more = copy();
        more.add(effect);
        return new Effects(more);
    }

    /** These but one. */
    public Effects without(Effect effect) {
        EnumSet<Effect> fewer = copy();
        fewer.remove(effect);
        return new Effects(fewer);
    }

    /** Those of the sensors alone. */
    Effects ofSensors() {
        return new Effects(on.stream().filter(Effect::ofSensors).collect(Collectors.toSet()));
    }

    /**
     * Reads {@code usual}, {@code all}, {@code none}, or a list {@code softening,noise}; a list may change the usual ones:
     * {@code usual,-noise,loss}.
     *
     * @throws IllegalArgumentException if a word is no effect
     */
    static Effects parse(String text) {
        EnumSet<Effect> on = EnumSet.noneOf(Effect.class);
        for (String word : text.split(",", -1)) {
            switch (word) {
                case "none" -> on.clear();
                case "usual" -> on.addAll(USUAL.on);
                case "all" -> on.addAll(EnumSet.allOf(Effect.class));
                default -> {
                    if (word.startsWith("-")) {
                        on.remove(Effect.parse(word.substring(1)));
                    } else {
                        on.add(Effect.parse(word));
                    }
                }
            }
        }
        return new Effects(on);
    }

    @Override
    public String toString() {
        if (on.isEmpty()) {
            return "none";
        }
        return Arrays.stream(Effect.values()).filter(on::contains).map(Effect::toString).collect(Collectors.joining(","));
    }

    private EnumSet<Effect> copy() {
        EnumSet<Effect> copy = EnumSet.noneOf(Effect.class);
        copy.addAll(on);
        return copy;
    }
}
