package wbv.task;

import com.github.javacliparser.StringOption;
import java.util.Arrays;
import java.util.List;

/** Several words in one option of a task. */
final class Words {

    private Words() {}

    /**
     * What an option says that a task cannot do without.
     *
     * @throws IllegalArgumentException if it says nothing
     */
    static String needed(StringOption option) {
        String value = option.getValue();
        if (value == null || value.isBlank()) {
            throw new IllegalArgumentException("-" + option.getCLIChar() + " is needed: " + option.getPurpose());
        }
        return value;
    }

    /** The words of a list separated by commas, without what is empty. */
    static List<String> of(String list) {
        return Arrays.stream(list.split(",")).map(String::strip).filter(word -> !word.isEmpty()).toList();
    }
}
