package wbv.report.page;

/**
 * Words for a machine, such as a command line; shown as they are, in a fixed-width type.
 *
 * @param caption what it is, may be empty
 */
public record Code(String caption, String text) implements Block {}
