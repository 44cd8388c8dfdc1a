package wbv.report.page;

import java.util.List;

/**
 * What was found, good or bad, the worst first by the writer's own order.
 *
 * @param none what is said when there is nothing to report
 */
public record Findings(List<Finding> findings, String none) implements Block {

    public Findings {
        findings = List.copyOf(findings);
    }

    /** How much a finding matters. */
    public enum Severity {
        /** Good to know. */
        NOTE,
        /** Results may be affected. */
        WARNING,
        /** Results are affected. */
        FAULT
    }

    /**
     * One thing that was found.
     *
     * @param message what was found, with its numbers
     * @param advice  what the reader can do about it; may be empty
     */
    public record Finding(Severity severity, String message, String advice) {}
}
