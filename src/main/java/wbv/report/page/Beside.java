package wbv.report.page;

import java.util.List;

/** Blocks beside each other where there is room, below each other where there is not. */
public record Beside(List<Block> blocks) implements Block {

    public Beside {
        blocks = List.copyOf(blocks);
    }

    /** Blocks from left to right. */
    public Beside(Block... blocks) {
        this(List.of(blocks));
    }
}
