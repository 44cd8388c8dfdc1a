package wbv.report;

import java.util.List;

/**
 * A report: what it is about, and its sections in reading order.
 *
 * @param title    one line
 * @param subtitle one line under the title, may be empty
 * @param sheet    true if the first section is a sheet of its own: printing gives one page with nothing else
 */
public record Page(String title, String subtitle, List<Section> sections, boolean sheet) {

    public Page(String title, String subtitle, List<Section> sections) {
        this(title, subtitle, sections, false);
    }

    public Page {
        if (title.isBlank()) {
            throw new IllegalArgumentException("a page needs a title");
        }
        sections = List.copyOf(sections);
    }
}
