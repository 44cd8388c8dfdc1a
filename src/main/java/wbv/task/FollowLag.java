package wbv.task;

import com.github.javacliparser.FloatOption;
import com.yahoo.labs.samoa.instances.Instance;
import com.yahoo.labs.samoa.instances.InstancesHeader;
import java.util.Optional;
import moa.core.Measurement;
import moa.core.ObjectRepository;
import moa.evaluation.LearningEvaluation;
import moa.evaluation.preview.LearningCurve;
import moa.options.ClassOption;
import moa.streams.InstanceStream;
import moa.tasks.AuxiliarMainTask;
import moa.tasks.TaskMonitor;
import wbv.recording.DataFault;
import wbv.state.HeadLag;
import wbv.state.Thresholds;

/**
 * How much later the head jerks than the seat, followed as a stream passes: a curve of the lag with its deviation, NaN as long as
 * fewer than three jolts stand out of the ride. With a half-life old jolts are forgotten, so that the curve follows what changes.
 */
public class FollowLag extends AuxiliarMainTask {

    private static final long serialVersionUID = 1;
    private static final String TIME = "time [s]";
    private static final int BETWEEN_MONITOR_LOOKS = 1000;

    public final ClassOption streamOption = new ClassOption("stream", 's',
            "Vertical acceleration of the seat as the first attribute after t, of the head as the class.", InstanceStream.class,
            "wbv.stream.RigStream -e 'excitation=ride:1' -i seat.acc.z");
    public final FloatOption halfLifeOption = new FloatOption("halfLife", 'h',
            "Time after which a jolt counts half [s]; 0 forgets nothing.", 0, 0, 1e9);
    public final FloatOption surgeOption = new FloatOption("surge", 'u',
            "Change of the seat's mean acceleration from 0.15 s to the next that makes a jolt [m/s²].", Thresholds.USUAL.surge(), 1e-3,
            1e6);
    public final FloatOption intervalOption = new FloatOption("interval", 'e',
            "Time from one entry of the curve to the next [s].", 10, 1e-3, 1e9);
    public final FloatOption endOption = new FloatOption("end", 'n', "Time after which to stop [s]; 0 goes on to the stream's end.",
            0, 0, 1e12);
    public final FloatOption rateOption = new FloatOption("rate", 'r', "Sampling rate of a stream without times [Hz].", 60, 20,
            100_000);

    @Override
    public String getPurposeString() {
        return "Follows how much later the head jerks than the seat.";
    }

    @Override
    public Class<?> getTaskResultType() {
        return LearningCurve.class;
    }

    @Override
    protected Object doMainTask(TaskMonitor monitor, ObjectRepository repository) {
        InstanceStream stream = (InstanceStream) getPreparedClassOption(streamOption);
        InstancesHeader header = stream.getHeader();
        boolean timed = header.attribute(0).name().equals("t");
        int seat = timed ? 1 : 0;
        int head = header.classIndex();
        if (header.numAttributes() < seat + 2 || head == seat) {
            throw new DataFault("the stream must hold the seat's vertical acceleration before its class, the head's: "
                    + header.getRelationName());
        }
        FirstTwo begun = FirstTwo.of(stream, "too little for a lag");
        double rate = begun.rate(timed, rateOption.getValue());
        if (!(rate >= 20 && rate <= 100_000)) {
            throw new DataFault("the first two times of the stream tell a rate of " + rate + " Hz; a lag needs 20 to 100 000");
        }
        HeadLag lag = new HeadLag(rate, surgeOption.getValue(), halfLifeOption.getValue() == 0 ? Double.POSITIVE_INFINITY
                : halfLifeOption.getValue());
        lag.accept(begun.first().value(seat), begun.first().value(head));
        LearningCurve curve = new LearningCurve(TIME);
        double start = timed ? begun.first().value(0) : 0;
        double end = endOption.getValue() == 0 ? Double.POSITIVE_INFINITY : endOption.getValue();
        double due = intervalOption.getValue();
        double before = 0;
        Instance next = begun.second();
        for (long count = 2;; count++) {
            double time = timed ? next.value(0) - start : (count - 1) / rate;
            // Rows that were lost spoil the jolt that they are part of, and no other.
            for (long lost = Math.min(Math.round((time - before) * rate) - 1, Math.round(rate)); lost > 0; lost--) {
                lag.accept(Double.NaN, Double.NaN);
            }
            before = time;
            lag.accept(next.value(seat), next.value(head));
            boolean last = !stream.hasMoreInstances() || time >= end;
            if (time >= due - 1e-9 || last) {
                curve.insertEntry(new LearningEvaluation(entry(lag, time)));
                due += intervalOption.getValue() * Math.max(1, Math.ceil((time - due) / intervalOption.getValue()));
            }
            if (last || count % BETWEEN_MONITOR_LOOKS == 0 && monitor.taskShouldAbort()) {
                return curve;
            }
            next = stream.nextInstance().getData();
        }
    }

    private static Measurement[] entry(HeadLag lag, double time) {
        Optional<HeadLag.Lag> now = lag.lag();
        return new Measurement[] {new Measurement(TIME, time), new Measurement("jolts", lag.jolts()),
            new Measurement("lag [ms]", now.map(each -> 1000 * each.seconds()).orElse(Double.NaN)),
            new Measurement("standard deviation of lag [ms]", now.map(each -> 1000 * each.deviation()).orElse(Double.NaN))};
    }
}
