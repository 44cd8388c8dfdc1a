package wbv.report.page;

import java.util.List;

/** What matters most, one tile a subject: a number, a small scale that it stands on, and what to know about it. */
public record Tiles(List<Tile> tiles) implements Block {

    public Tiles {
        tiles = List.copyOf(tiles);
    }

    /** How good or bad it is. */
    public enum Tone { PLAIN, GOOD, WARNING, FAULT }

    /**
     * A tile.
     *
     * @param title what it is about
     * @param value ready to be shown, such as {@code ≥ 0.72}; words where there is no number
     * @param unit  may be empty
     * @param gauge where the value stands
     * @param lines what to know about it, the most important first
     * @param tone  of the value
     */
    public record Tile(String title, String value, String unit, Gauge gauge, List<String> lines, Tone tone) {

        public Tile {
            lines = List.copyOf(lines);
        }
    }
}
