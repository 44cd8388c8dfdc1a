/**
 * The page kit: one self-contained HTML page of small records.
 *
 * <p>A {@link wbv.report.page.Page} is a tree: sections of {@link wbv.report.page.Block}s. {@link wbv.report.page.HtmlWriter}
 * renders it with style and script inlined, so that it opens anywhere without a network. A new kind of chart is a record that
 * {@link wbv.report.page.Chart} permits, its data in {@code ChartJson}, and a class in a script of its own.
 */
package wbv.report.page;
