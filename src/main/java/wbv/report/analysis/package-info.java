/** The report of {@code wbv analyze}: one recording, tile by tile and chart by chart. */
package wbv.report.analysis;
