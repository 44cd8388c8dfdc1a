/** The report of {@code wbv poles}: how poles gather, what they bound, and how that serves elsewhere. */
package wbv.report.poles;
