package wbv.task;

import java.io.ObjectInputFilter;

/**
 * What may be read from a serialized file. MOA takes a learner, a stream or a whole task from {@code file:...} inside a task
 * string, and what is read there is made before anybody asks what it is; any class on the path can be named in it. Admitted are
 * classes of MOA, Weka and wbv, matrices, and values of Java itself; no proxy, no reflection, no method handle (JEP 290).
 */
public final class AdmittedClasses {

    private static final String PATTERN = String.join(";", "wbv.**", "moa.**", "com.yahoo.labs.samoa.instances.*",
            "com.github.javacliparser.*", "weka.**", "java.lang.*", "java.util.*", "java.util.concurrent.atomic.*",
            "java.util.concurrent.ConcurrentHashMap", "java.util.concurrent.ConcurrentHashMap$*", "java.util.concurrent.locks.*",
            "org.ejml.data.*", "java.math.*", "java.text.*", "java.time.*", "java.io.File", "!*");

    private AdmittedClasses() {}

    /** Admits these classes alone, and says which one it refused. */
    public static ObjectInputFilter filter() {
        ObjectInputFilter pattern = ObjectInputFilter.Config.createFilter(PATTERN);
        return info -> {
            ObjectInputFilter.Status status = pattern.checkInput(info);
            if (status == ObjectInputFilter.Status.REJECTED && info.serialClass() != null) {
                throw new IllegalArgumentException(info.serialClass().getName()
                        + " may not come from a file; admitted are classes of MOA, Weka and wbv, and values of Java");
            }
            return status;
        };
    }

    /** Makes it a rule for everything that this Java process reads, unless it was begun with a rule of its own. */
    public static void enforce() {
        if (ObjectInputFilter.Config.getSerialFilter() == null) {
            ObjectInputFilter.Config.setSerialFilter(filter());
        }
    }
}
