package wbv.report.page;

/**
 * Plain words.
 *
 * @param text paragraphs, parted by an empty line
 */
public record Text(String text) implements Block {}
