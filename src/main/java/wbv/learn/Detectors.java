package wbv.learn;

import com.github.javacliparser.ClassOption;
import java.util.function.Supplier;
import moa.classifiers.core.driftdetection.ADWINChangeDetector;
import moa.classifiers.core.driftdetection.ChangeDetector;
import wbv.filter.drift.Alarm;

/**
 * Alarms by the command line of any of MOA's change detectors, such as {@code ADWINChangeDetector -a 0.01} or {@code
 * PageHinkleyDM -l 20}, or {@value #NONE}.
 */
public final class Detectors {

    /** ADWIN at a probability of a false cut at one look of 0.002. */
    public static final String USUAL = "ADWINChangeDetector";
    /** No detector: only the estimators' own tests listen. */
    public static final String NONE = "none";
    /** What the option is for. */
    static final String PURPOSE = "Change detector that hears the innovations beside the estimator's own tests; ADWIN in both "
            + "directions. 'none' for the tests alone.";

    private Detectors() {}

    /**
     * What makes alarms.
     *
     * @param commandLine class name and options of a detector; the package may be left out
     * @throws IllegalArgumentException if it is none
     */
    public static Supplier<Alarm> named(String commandLine) {
        if (commandLine.strip().equalsIgnoreCase(NONE)) {
            return () -> new DetectorAlarm(new Deaf());
        }
        ChangeDetector detector = parse(commandLine);
        if (detector instanceof ADWINChangeDetector adwin) {
            double delta = adwin.deltaAdwinOption.getValue();
            return () -> new AdwinAlarm(delta);
        }
        try {
            detector.copy();
        } catch (RuntimeException doesNotSerialise) {
            throw new IllegalArgumentException("this change detector of MOA's cannot be copied, as an estimator must be: '" + commandLine
                    + "'", doesNotSerialise);
        }
        return () -> new DetectorAlarm((ChangeDetector) detector.copy());
    }

    private static ChangeDetector parse(String commandLine) {
        try {
            ChangeDetector detector = (ChangeDetector) ClassOption.cliStringToObject(commandLine.strip(), ChangeDetector.class, null);
            detector.prepareForUse();
            detector.resetLearning();
            return detector;
        } catch (Exception wrong) {
            throw new IllegalArgumentException("a change detector is '" + NONE + "' or a class of MOA's with its options, such as '"
                    + USUAL + " -a 0.01': '" + commandLine + "'", wrong);
        }
    }
}
