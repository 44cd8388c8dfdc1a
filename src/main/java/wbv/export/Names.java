package wbv.export;

import java.util.ArrayList;
import java.util.List;
import wbv.body.Model;

/** What the numbers of a model belong to: the bodies of its structure, hidden masses behind them, and links likewise. */
record Names(List<String> bodies, List<String> links) {

    static Names of(Model model) {
        List<String> bodies = new ArrayList<>(model.bodies().stream().map(Model.Body::name).toList());
        List<String> links = new ArrayList<>(model.links().stream().map(Model.Link::name).toList());
        for (Model.Body body : model.bodies()) {
            if (body.hidden().isPresent()) {
                bodies.add("hidden mass on " + body.name());
                links.add(body.name() + "-hidden mass");
            }
        }
        return new Names(List.copyOf(bodies), List.copyOf(links));
    }

    /** {@code MountResonance} as {@code mount_resonance}. */
    static String snake(Object record) {
        return record.getClass().getSimpleName().replaceAll("(?<=.)([A-Z])", "_$1").toLowerCase(java.util.Locale.ROOT);
    }

    /** What a comment or a text in quotes may hold of a name that its user chose. */
    static String plain(String text) {
        return text.replaceAll("[\\p{Cntrl}\"\\\\]", " ").replace("*/", "* /").replace("--", "- -").strip();
    }
}
