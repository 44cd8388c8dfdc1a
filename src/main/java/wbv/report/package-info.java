/**
 * Results on a page and in files: one self-contained HTML page, JSON, and a folder that is written whole or not at all.
 *
 * <p>A {@link wbv.report.Page} is a tree of small records: sections of {@link wbv.report.Block}s. {@link wbv.report.HtmlWriter}
 * renders it with style and script inlined, so that it opens anywhere without a network. A new kind of chart is a record that
 * {@link wbv.report.Chart} permits, its data in {@code ChartJson}, and a class in a script of its own.
 */
package wbv.report;
