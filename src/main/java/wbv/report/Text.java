package wbv.report;

/** Plain words. @param text paragraphs, parted by an empty line */
public record Text(String text) implements Block { }
