package wbv.report.page;

/** The one sentence that a reader in a hurry needs, set large. */
public record Lead(String text) implements Block {}
