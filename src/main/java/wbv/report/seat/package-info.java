/** The report of {@code wbv seat}: controllers of a suspension seat at equal stroke. */
package wbv.report.seat;
