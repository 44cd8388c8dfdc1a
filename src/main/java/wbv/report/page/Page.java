package wbv.report.page;

import java.util.List;

/**
 * A report: what it is about, and its sections in reading order.
 *
 * @param title    one line
 * @param subtitle one line under the title, may be empty
 * @param printed  sections, from the first on, that paper gets; the first of them on one page by itself. 0 prints all as it comes
 */
public record Page(String title, String subtitle, List<Section> sections, int printed) {

    /** Paper gets all as it comes. */
    public Page(String title, String subtitle, List<Section> sections) {
        this(title, subtitle, sections, 0);
    }

    public Page {
        if (title.isBlank()) {
            throw new IllegalArgumentException("a page needs a title");
        }
        if (printed < 0 || printed > sections.size()) {
            throw new IllegalArgumentException("sections to be printed must be 0 to " + sections.size() + ": " + printed);
        }
        sections = List.copyOf(sections);
    }
}
