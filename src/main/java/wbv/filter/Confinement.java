package wbv.filter;

import java.io.Serializable;
import wbv.filter.model.Bounds;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** What keeps an estimate within bounds, sample by sample: nothing, or a projection of the filters that can be projected. */
sealed interface Confinement extends Serializable, Snapshot permits Confinement.Free, Confinement.Within {

    /** Hears that a sample begins. */
    void begin();

    /** Moves the estimate into the bounds of this sample. */
    void apply();

    /** As before the first sample. */
    void reset();

    /** Nothing keeps it. */
    record Free() implements Confinement {
        @Override
        public void begin() {}

        @Override
        public void apply() {}

        @Override
        public void reset() {}

        @Override
        public void save(StateWriter out) {}

        @Override
        public void load(StateReader in) {}
    }

    /** The bounds of a body, and those of a constraint within them. */
    final class Within implements Confinement {

        private static final long serialVersionUID = 1;

        private final BodyFilter filter;
        private final Constraint constraint;
        private final Bounds bounds = new Bounds();
        private long samples;

        Within(BodyFilter filter, Constraint constraint) {
            this.filter = filter;
            this.constraint = constraint;
        }

        @Override
        public void begin() {
            bounds.clear();
            bounds.setToBody(filter.model().modes());
            constraint.at(samples++, bounds);
        }

        @Override
        public void apply() {
            filter.project(bounds);
        }

        @Override
        public void reset() {
            samples = 0;
            constraint.reset();
        }

        @Override
        public void save(StateWriter out) {
            out.put(samples);
            out.put(constraint);
        }

        @Override
        public void load(StateReader in) {
            samples = in.count();
            in.part(constraint);
        }
    }
}
