package wbv.report.page;

import java.util.List;

/**
 * A part of a page.
 *
 * @param title shown as heading and in the page's list of contents
 * @param intro what the reader finds here and how to read it; may be empty
 */
public record Section(String title, String intro, List<Block> blocks) {

    public Section {
        if (title.isBlank()) {
            throw new IllegalArgumentException("a section needs a title");
        }
        blocks = List.copyOf(blocks);
    }

    /** Blocks from the top down. */
    public Section(String title, String intro, Block... blocks) {
        this(title, intro, List.of(blocks));
    }
}
