package wbv.filter.drift;

/** What can hear that a body, or what disturbs it, has changed; in files by its place in this list. */
public enum ChangeTest {

    /** None did. */
    NONE("none"),
    /** The {@link Alarm}: ADWIN or another detector. */
    DETECTOR("detector"),
    /** Page's test on the variance of the innovations. */
    VARIANCE("variance"),
    /** Page's test on the likelihood of a step in ln ω. */
    STEP("step"),
    /** Page's test on what following the body explains beyond one that stays as it was. */
    EVIDENCE("evidence");

    private final String word;

    ChangeTest(String word) {
        this.word = word;
    }

    /** Its name in words and results. */
    public String word() {
        return word;
    }
}
