package wbv.report.page;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import wbv.recording.AtomicFile;

/**
 * Renders a {@link Page} as one HTML file that needs nothing else: style, script and data are inside, and the page forbids itself
 * to load anything. Words, tables and findings need no script. The same page always gives the same bytes.
 */
public final class HtmlWriter {

    /** A cell of more letters may break anywhere, so that the table fits. */
    private static final int LONG = 32;

    private static final String SAFE = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:";
    private static final List<
            String> SCRIPTS = List.of("axes.js", "view.js", "chart.js", "lines.js", "xy.js", "bars.js", "heatmap.js", "report.js");

    private final StringBuilder html = new StringBuilder();
    private String openGroup = "";

    private HtmlWriter() {}

    /** The page as HTML text. */
    public static String render(Page page) {
        return new HtmlWriter().page(page);
    }

    /** Writes the page to a file, whole or not at all. */
    public static void write(Page page, Path file) throws IOException {
        AtomicFile.write(file, render(page).getBytes(StandardCharsets.UTF_8));
    }

    private String page(Page page) {
        html.append("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n")
                .append("<meta http-equiv=\"Content-Security-Policy\" content=\"").append(SAFE).append("\">\n")
                .append("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n")
                .append("<meta name=\"color-scheme\" content=\"light dark\">\n");
        element("title", page.title());
        html.append("<style>\n").append(resource("report.css")).append("</style>\n</head>\n<body")
                .append(page.printed() > 0 ? " class=\"sheet\"" : "").append(">\n<header>\n");
        element("h1", page.title());
        optional("p", "subtitle", page.subtitle());
        html.append("</header>\n");
        contents(page.sections());
        html.append("<main>\n");
        for (int i = 0; i < page.sections().size(); i++) {
            section(page.sections().get(i), i + 1, i < page.printed());
        }
        html.append("</main>\n<script>\n(() => {\n'use strict';\n");
        SCRIPTS.forEach(name -> html.append('\n').append(resource(name)));
        html.append("})();\n</script>\n</body>\n</html>\n");
        return html.toString();
    }

    private void contents(List<Section> sections) {
        if (sections.size() < 2) {
            return;
        }
        html.append("<nav aria-label=\"Contents\">\n");
        for (int i = 0; i < sections.size(); i++) {
            html.append("<a href=\"#section-").append(i + 1).append("\">").append(escape(sections.get(i).title()))
                    .append("</a>\n");
        }
        html.append("</nav>\n");
    }

    private void section(Section section, int number, boolean printed) {
        html.append("<section id=\"section-").append(number).append(printed ? "\" class=\"printed\">\n" : "\">\n");
        element("h2", section.title());
        optional("p", "intro", section.intro());
        section.blocks().forEach(this::block);
        closeGroup("");
        html.append("</section>\n");
    }

    private void block(Block block) {
        closeGroup(block instanceof Chart chart ? chart.group() : "");
        if (block instanceof Lead lead) {
            optional("p", "lead", lead.text());
        } else if (block instanceof Beside beside) {
            html.append("<div class=\"beside\">\n");
            for (Block each : beside.blocks()) {
                html.append("<div>\n");
                block(each);
                closeGroup("");
                html.append("</div>\n");
            }
            html.append("</div>\n");
        } else if (block instanceof Text text) {
            for (String paragraph : text.text().strip().split("\\n\\s*\\n")) {
                element("p", paragraph);
            }
        } else if (block instanceof Code code) {
            optional("p", "caption", code.caption());
            html.append("<pre><code>").append(escape(code.text())).append("</code></pre>\n");
        } else if (block instanceof Table table) {
            table(table);
        } else if (block instanceof Figures figures) {
            figures(figures);
        } else if (block instanceof Findings findings) {
            findings(findings);
        } else if (block instanceof StateGraph graph) {
            html.append("<figure>\n<figcaption>").append(escape(graph.title())).append("</figcaption>\n")
                    .append(graph.svg(HtmlWriter::escape)).append("</figure>\n");
        } else if (block instanceof Tiles tiles) {
            tiles(tiles);
        } else if (block instanceof SensorFigure figure) {
            sensors(figure);
        } else if (block instanceof Folded folded) {
            html.append("<details>\n");
            element("summary", folded.title());
            folded.blocks().forEach(this::block);
            closeGroup("");
            html.append("</details>\n");
        } else if (block instanceof Chart chart) {
            chart(chart);
        } else {
            throw new IllegalStateException("no rendering of " + block.getClass());
        }
    }

    private void table(Table table) {
        html.append("<div class=\"scroll\" tabindex=\"0\"><table>\n");
        optional("caption", "", table.caption());
        html.append("<thead><tr>");
        for (Table.Column column : table.columns()) {
            cell("th", column, column.header());
        }
        html.append("</tr></thead>\n<tbody>\n");
        for (List<String> row : table.rows()) {
            html.append("<tr>");
            for (int i = 0; i < row.size(); i++) {
                cell("td", table.columns().get(i), row.get(i));
            }
            html.append("</tr>\n");
        }
        html.append("</tbody>\n</table></div>\n");
    }

    private void cell(String tag, Table.Column column, String text) {
        html.append('<').append(tag).append(column.align() == Table.Align.RIGHT ? " class=\"number\">"
                : text.length() > LONG ? " class=\"long\">" : ">")
                .append(escape(text)).append("</").append(tag).append('>');
    }

    private void figures(Figures figures) {
        html.append("<dl class=\"figures\">\n");
        for (Figures.Figure figure : figures.figures()) {
            html.append("<div><dt>").append(escape(figure.label())).append("</dt><dd><span class=\"value\">")
                    .append(escape(figure.value())).append("</span>");
            inline("unit", figure.unit());
            inline("uncertainty", figure.uncertainty());
            html.append("</dd></div>\n");
        }
        html.append("</dl>\n");
    }

    private void tiles(Tiles tiles) {
        html.append("<div class=\"tiles\">\n");
        for (Tiles.Tile tile : tiles.tiles()) {
            html.append("<section class=\"tile ").append(tile.tone().name().toLowerCase(Locale.ROOT)).append("\">\n");
            element("h3", tile.title());
            html.append("<p class=\"reading\"><span class=\"value\">").append(escape(tile.value())).append("</span>");
            inline("unit", tile.unit());
            html.append("</p>\n").append(tile.gauge().empty() ? "" : tile.gauge().svg(HtmlWriter::escape));
            tile.lines().forEach(line -> element("p", line));
            html.append("</section>\n");
        }
        html.append("</div>\n");
    }

    private void sensors(SensorFigure figure) {
        html.append("<div class=\"sensors\">\n").append(figure.svg(HtmlWriter::escape)).append("<ol>\n");
        for (SensorFigure.Sensor sensor : figure.sensors()) {
            html.append("<li class=\"").append(sensor.tone().name().toLowerCase(Locale.ROOT)).append("\"><b>")
                    .append(escape(sensor.place())).append("</b> <span class=\"channels\">").append(escape(sensor.channels()))
                    .append("</span> <span class=\"found\">").append(escape(sensor.words().isEmpty() ? "nothing found" : sensor.words()))
                    .append("</span></li>\n");
        }
        html.append("</ol>\n</div>\n");
    }

    private void findings(Findings findings) {
        if (findings.findings().isEmpty()) {
            optional("p", "none", findings.none());
            return;
        }
        html.append("<ul class=\"findings\">\n");
        for (Findings.Finding finding : findings.findings()) {
            String severity = finding.severity().name();
            html.append("<li class=\"").append(severity.toLowerCase(Locale.ROOT)).append("\"><span class=\"severity\">")
                    .append(severity.charAt(0)).append(severity.substring(1).toLowerCase(Locale.ROOT)).append("</span>")
                    .append("<div><p>").append(escape(finding.message())).append("</p>");
            optional("p", "advice", finding.advice());
            html.append("</div></li>\n");
        }
        html.append("</ul>\n");
    }

    private void chart(Chart chart) {
        if (!chart.group().isEmpty() && openGroup.isEmpty()) {
            html.append("<div class=\"group\">\n");
            openGroup = chart.group();
        }
        html.append("<figure class=\"chart\">\n<figcaption>").append(escape(chart.title())).append("</figcaption>\n")
                .append("<div class=\"plot\"><noscript>This chart needs JavaScript.</noscript></div>\n");
        optional("p", "note", chart.note());
        html.append("<script type=\"application/json\">").append(ChartJson.of(chart).replace("<", "\\u003c"))
                .append("</script>\n</figure>\n");
    }

    /** Ends the run of charts that belong together unless the next block goes on with it. */
    private void closeGroup(String next) {
        if (!openGroup.isEmpty() && !openGroup.equals(next)) {
            html.append("</div>\n");
            openGroup = "";
        }
    }

    private void element(String tag, String text) {
        html.append('<').append(tag).append('>').append(escape(text)).append("</").append(tag).append(">\n");
    }

    private void optional(String tag, String type, String text) {
        if (!text.isBlank()) {
            html.append('<').append(tag).append(type.isEmpty() ? "" : " class=\"" + type + '"').append('>')
                    .append(escape(text)).append("</").append(tag).append(">\n");
        }
    }

    private void inline(String type, String text) {
        if (!text.isBlank()) {
            html.append(" <span class=\"").append(type).append("\">").append(escape(text)).append("</span>");
        }
    }

    private static String escape(String text) {
        StringBuilder safe = new StringBuilder(text.length());
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            switch (c) {
                case '&' -> safe.append("&amp;");
                case '<' -> safe.append("&lt;");
                case '>' -> safe.append("&gt;");
                case '"' -> safe.append("&quot;");
                case '\'' -> safe.append("&#39;");
                default -> safe.append(c < ' ' && c != '\n' && c != '\t' ? '\uFFFD' : c);
            }
        }
        return safe.toString();
    }

    private static String resource(String name) {
        try (InputStream in = HtmlWriter.class.getResourceAsStream(name)) {
            if (in == null) {
                throw new IllegalStateException("the program lacks its own file wbv/report/page/" + name);
            }
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
