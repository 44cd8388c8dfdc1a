package wbv.task;

import com.yahoo.labs.samoa.instances.Instance;
import moa.streams.InstanceStream;
import wbv.recording.DataFault;

/** The first two instances of a stream, which tell its rate where its first attribute is the time. */
record FirstTwo(Instance first, Instance second) {

    /**
     * @param wanting what one instance is too little for
     * @throws DataFault if there are fewer
     */
    static FirstTwo of(InstanceStream stream, String wanting) {
        if (!stream.hasMoreInstances()) {
            throw new DataFault("the stream has no instance");
        }
        Instance first = stream.nextInstance().getData();
        if (!stream.hasMoreInstances()) {
            throw new DataFault("the stream has one instance only: " + wanting);
        }
        return new FirstTwo(first, stream.nextInstance().getData());
    }

    /**
     * Sampling rate [Hz].
     *
     * @param timed whether the first attribute is the time [s]
     * @param stated where it is not
     */
    double rate(boolean timed, double stated) {
        return timed ? 1 / (second.value(0) - first.value(0)) : stated;
    }
}
