package wbv.state;

import java.util.Collections;
import java.util.Enumeration;
import java.util.Vector;
import java.util.stream.Stream;
import weka.core.Option;

/** A learner's own options, which Weka finds by their annotations, before those that it inherits. */
final class WekaOptions {

    private WekaOptions() { }

    static Enumeration<Option> listed(Object learner, Enumeration<Option> inherited) {
        Vector<Option> options = new Vector<>(Option.listOptionsForClass(learner.getClass()));
        options.addAll(Collections.list(inherited));
        return options.elements();
    }

    static String[] words(Object learner, String[] inherited) {
        return Stream.concat(Stream.of(Option.getOptions(learner, learner.getClass())), Stream.of(inherited))
                .toArray(String[]::new);
    }
}
