/** The report of {@code wbv states}: when which motion state, how one follows another, and how far to trust them. */
package wbv.report.states;
