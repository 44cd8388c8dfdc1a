package wbv.task;

import com.github.javacliparser.FlagOption;
import com.github.javacliparser.FloatOption;
import com.github.javacliparser.StringOption;
import com.yahoo.labs.samoa.instances.Instance;
import com.yahoo.labs.samoa.instances.InstancesHeader;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import moa.core.Measurement;
import moa.core.ObjectRepository;
import moa.evaluation.LearningEvaluation;
import moa.evaluation.preview.LearningCurve;
import moa.options.ClassOption;
import moa.streams.InstanceStream;
import moa.tasks.AuxiliarMainTask;
import moa.tasks.TaskMonitor;
import wbv.exposure.DailyExposure;
import wbv.exposure.DailyTask;
import wbv.exposure.Directive;
import wbv.exposure.Meter;
import wbv.exposure.SeatAxis;
import wbv.exposure.Vibration;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;

/**
 * Measures exposure as it grows: weighted acceleration, dose and greatest running r.m.s. by axis, and what a day like this comes
 * to. Takes the accelerations of one place among the attributes and the class of a stream; the values lag by less than a second.
 */
public class MeasureExposure extends AuxiliarMainTask {

    private static final long serialVersionUID = 1;
    private static final String TIME = "time [s]";
    private static final int BETWEEN_MONITOR_LOOKS = 1000;
    /** Time after which a weighting has forgotten what was, eight periods of 0.4 Hz [s]. */
    private static final double FORGOTTEN = 20;

    public final ClassOption streamOption = new ClassOption("stream", 's', "Accelerations of the seat, one of them as the class.",
            InstanceStream.class, "wbv.stream.RecordingStream -i seat.acc.x,seat.acc.y -o seat.acc.z");
    public final StringOption placeOption = new StringOption("place", 'p', "Where the vibration enters the sitter.", "seat");
    public final FloatOption minutesOption = new FloatOption("minutes", 'm', "Daily duration of the task [min].", 480, 0, 1440);
    public final FloatOption intervalOption = new FloatOption("interval", 'e',
            "Time from one entry of the curve to the next [s].", 1, 1e-3, 1e9);
    public final FloatOption rateOption = new FloatOption("rate", 'r',
            "Sampling rate, for streams without an attribute t; 0 takes it from t [Hz].", 0, 0, 1e6);
    public final FlagOption boxcarOption = new FlagOption("boxcar", 'b',
            "Samples are means over the sampling period: undo their droop.");

    @Override
    public String getPurposeString() {
        return "Measures the exposure to whole-body vibration of a stream as it grows.";
    }

    @Override
    public Class<?> getTaskResultType() {
        return LearningCurve.class;
    }

    @Override
    protected Object doMainTask(TaskMonitor monitor, ObjectRepository repository) {
        InstanceStream stream = (InstanceStream) getPreparedClassOption(streamOption);
        Map<SeatAxis, Integer> columns = columns(stream.getHeader());
        LearningCurve curve = new LearningCurve(TIME);
        if (!stream.hasMoreInstances()) {
            return curve;
        }
        Instance first = stream.nextInstance().getData();
        if (!stream.hasMoreInstances()) {
            throw new DataFault("the stream has one sample; exposure needs seconds of them");
        }
        Instance second = stream.nextInstance().getData();
        double rate = rate(stream.getHeader(), first, second);
        double start = hasTime(stream.getHeader()) ? first.value(0) : 0;
        Map<SeatAxis, Meter> meters = new EnumMap<>(SeatAxis.class);
        columns.keySet().forEach(axis -> meters.put(axis, Meter.stream(axis.weighting().filter(), rate, boxcarOption.isSet())));
        take(first, columns, meters);
        take(second, columns, meters);
        long count = 2;
        double due = intervalOption.getValue();
        double before = second.value(0);
        while (stream.hasMoreInstances()) {
            Instance next = stream.nextInstance().getData();
            if (hasTime(stream.getHeader())) {
                long lost = Math.max(0, Math.round((next.value(0) - before) * rate) - 1);
                before = next.value(0);
                count += lost;
                lose(lost, meters, (long) (FORGOTTEN * rate));
            }
            take(next, columns, meters);
            count++;
            if (count / rate >= due - 1e-9 && stream.hasMoreInstances()) { // the last entry follows the flush
                curve.insertEntry(entry(start + count / rate, meters));
                due += intervalOption.getValue() * Math.max(1, Math.ceil((count / rate - due) / intervalOption.getValue()));
            }
            if (count % BETWEEN_MONITOR_LOOKS == 0) {
                if (monitor.taskShouldAbort()) {
                    return curve;
                }
                monitor.setCurrentActivityFractionComplete(count / (double) (count + stream.estimatedRemainingInstances()));
            }
        }
        meters.values().forEach(Meter::finish);
        curve.insertEntry(entry(start + count / rate, meters));
        return curve;
    }

    private Map<SeatAxis, Integer> columns(InstancesHeader header) {
        Map<SeatAxis, Integer> columns = new EnumMap<>(SeatAxis.class);
        List<String> names = new ArrayList<>();
        for (int i = 0; i < header.numAttributes(); i++) {
            names.add(header.attribute(i).name());
        }
        for (Quantity quantity : List.of(Quantity.SPECIFIC_FORCE, Quantity.ACCELERATION)) { // the latter goes first
            for (SeatAxis axis : SeatAxis.values()) {
                int index = names.indexOf(new Channel(placeOption.getValue(), quantity, axis.letter()).toString());
                if (index >= 0) {
                    columns.put(axis, index);
                }
            }
        }
        if (columns.isEmpty()) {
            throw new DataFault("no acceleration of " + placeOption.getValue() + " among " + names + "; name the place with -p");
        }
        return columns;
    }

    private static boolean hasTime(InstancesHeader header) {
        return header.attribute(0).name().equals("t");
    }

    private double rate(InstancesHeader header, Instance first, Instance second) {
        double rate = rateOption.getValue() > 0 || !hasTime(header) ? rateOption.getValue()
                : 1 / (second.value(0) - first.value(0));
        if (!(rate >= 49) || Double.isInfinite(rate)) {
            throw new DataFault("exposure needs 50 Hz of sampling at least, said by -r or by an attribute t: " + rate);
        }
        return rate;
    }

    /**
     * Lets time pass of which the stream has no instances.
     *
     * @param most after which nothing changes any more
     */
    private static void lose(long samples, Map<SeatAxis, Meter> meters, long most) {
        for (long i = 0; i < Math.min(samples, most); i++) {
            meters.values().forEach(meter -> meter.accept(Double.NaN));
        }
    }

    private static void take(Instance instance, Map<SeatAxis, Integer> columns, Map<SeatAxis, Meter> meters) {
        for (Map.Entry<SeatAxis, Meter> entry : meters.entrySet()) {
            int column = columns.get(entry.getKey());
            entry.getValue().accept(instance.isMissing(column) ? Double.NaN : instance.value(column));
        }
    }

    private LearningEvaluation entry(double time, Map<SeatAxis, Meter> meters) {
        List<Measurement> values = new ArrayList<>(List.of(new Measurement(TIME, time)));
        Map<SeatAxis, Vibration.Level> levels = new EnumMap<>(SeatAxis.class);
        for (SeatAxis axis : SeatAxis.values()) {
            Meter meter = meters.get(axis);
            Vibration vibration = meter == null ? new Vibration(0, 0, Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN,
                    0, Double.NaN)
                    : meter.vibration();
            values.add(new Measurement("a_w " + axis.letter() + " [m/s2]", vibration.rms()));
            values.add(new Measurement("running r.m.s. " + axis.letter() + " [m/s2]", meter == null ? Double.NaN
                    : meter.running()));
            values.add(new Measurement("MTVV " + axis.letter() + " [m/s2]", vibration.mtvv()));
            values.add(new Measurement("VDV " + axis.letter() + " [m/s^1.75]", vibration.vdv()));
            if (vibration.seconds() > 0) {
                levels.put(axis, vibration.level());
            }
        }
        daily(values, levels);
        return new LearningEvaluation(values.toArray(Measurement[]::new));
    }

    /** What a day of this comes to. */
    private void daily(List<Measurement> values, Map<SeatAxis, Vibration.Level> levels) {
        double[] day = {Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN};
        if (!levels.isEmpty()) {
            DailyExposure exposure = new DailyExposure(List.of(new DailyTask("task", minutesOption.getValue(), levels)));
            day = new double[] {exposure.a8(), exposure.points(), exposure.vdv(), exposure.minutesUntil(Directive.ACTION),
                exposure.minutesUntil(Directive.LIMIT)};
        }
        String[] names = {"A(8) [m/s2]", "points", "daily VDV [m/s^1.75]", "until action value [min]", "until limit value [min]"};
        for (int i = 0; i < names.length; i++) {
            values.add(new Measurement(names[i], day[i]));
        }
    }
}
