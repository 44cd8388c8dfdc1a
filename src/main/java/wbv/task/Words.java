package wbv.task;

import java.util.Arrays;
import java.util.List;

/** Several words in one option of a task. */
final class Words {

    private Words() { }

    /** The words of a list separated by commas, without what is empty. */
    static List<String> of(String list) {
        return Arrays.stream(list.split(",")).map(String::strip).filter(word -> !word.isEmpty()).toList();
    }
}
