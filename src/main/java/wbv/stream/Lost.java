package wbv.stream;

import com.github.javacliparser.MultiChoiceOption;

/** What a stream makes of a sample that a sensor lost. */
enum Lost {

    /** A missing value, which the learners of wbv take for what it is. */
    MISSING,
    /**
     * Its instance is left out, and t jumps. Regressors of MOA are safe then: a missing class ends FIMTDD with a NullPointerException, and
     * a missing value makes every weight of a Perceptron NaN.
     */
    SKIPPED;

    static MultiChoiceOption option() {
        return new MultiChoiceOption("lost", 'l', "What becomes of samples that sensors lost.", new String[] {"missing", "skipped"},
                new String[] {"missing values, as learners of wbv take them",
                    "instances that lack a value are left out, for learners that take no missing values, such as FIMTDD"},
                MISSING.ordinal());
    }

    static Lost of(MultiChoiceOption option) {
        return values()[option.getChosenIndex()];
    }
}
