package wbv.learn;

import moa.classifiers.core.driftdetection.AbstractChangeDetector;
import moa.core.ObjectRepository;
import moa.tasks.TaskMonitor;

/** Hears nothing: for estimators that are to rest on their own tests alone. */
public final class Deaf extends AbstractChangeDetector {

    private static final long serialVersionUID = 1;

    @Override
    public void input(double value) {}

    @Override
    public void getDescription(StringBuilder out, int indent) {
        out.append("hears nothing");
    }

    @Override
    protected void prepareForUseImpl(TaskMonitor monitor, ObjectRepository repository) {}
}
