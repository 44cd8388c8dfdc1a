package wbv.report;

import java.util.List;

/**
 * A report: what it is about, and its sections in reading order.
 *
 * @param title    one line
 * @param subtitle one line under the title, may be empty
 */
public record Page(String title, String subtitle, List<Section> sections) {

    public Page {
        if (title.isBlank()) {
            throw new IllegalArgumentException("a page needs a title");
        }
        sections = List.copyOf(sections);
    }
}
