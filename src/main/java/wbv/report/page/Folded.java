package wbv.report.page;

import java.util.List;

/** Blocks behind a line that opens them: what few readers need. Paper gets the line alone. */
public record Folded(String title, List<Block> blocks) implements Block {

    public Folded {
        if (title.isBlank()) {
            throw new IllegalArgumentException("what is folded needs a title");
        }
        blocks = List.copyOf(blocks);
    }

    /** Blocks from the top down. */
    public Folded(String title, Block... blocks) {
        this(title, List.of(blocks));
    }
}
