package wbv.task;

import com.github.javacliparser.FloatOption;
import com.yahoo.labs.samoa.instances.Instance;
import com.yahoo.labs.samoa.instances.InstancesHeader;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import moa.core.Measurement;
import moa.core.ObjectRepository;
import moa.evaluation.LearningEvaluation;
import moa.evaluation.preview.LearningCurve;
import moa.options.ClassOption;
import moa.streams.InstanceStream;
import moa.tasks.AuxiliarMainTask;
import moa.tasks.TaskMonitor;
import wbv.recording.DataFault;
import wbv.signal.Detrend;
import wbv.signal.FrequencyResponse.Excited;
import wbv.signal.GapBridges;
import wbv.signal.Peak;
import wbv.signal.ResponseMatrix;
import wbv.signal.Segmentation;
import wbv.signal.SpectralMatrix;

/**
 * Frequency responses from all inputs of a stream to its class, averaged as it passes: the peak of each, how sure it is, and the
 * coherence, as a curve over time. With a half-life the average forgets, so that the curve follows what changes.
 */
public class RespondOverTime extends AuxiliarMainTask {

    private static final long serialVersionUID = 1;
    private static final String TIME = "time [s]";
    private static final double LONGEST_BRIDGE = 0.05;
    private static final int BETWEEN_MONITOR_LOOKS = 1000;

    public final ClassOption streamOption = new ClassOption("stream", 's', "Inputs, and the output as the class.",
            InstanceStream.class, "wbv.stream.RigStream");
    public final FloatOption segmentOption = new FloatOption("segment", 'g',
            "Length of a segment [s], taken to the next power of two of samples.", 4.27, 1e-3, 1e6);
    public final FloatOption halfLifeOption = new FloatOption("halfLife", 'h',
            "Time after which a segment counts half [s]; 0 forgets nothing.", 0, 0, 1e9);
    public final FloatOption intervalOption = new FloatOption("interval", 'e',
            "Time from one entry of the curve to the next [s].", 10, 1e-3, 1e9);
    public final FloatOption rateOption = new FloatOption("rate", 'r',
            "Sampling rate of a stream without times [Hz].", 60, 1e-6, 1e6);

    @Override
    public String getPurposeString() {
        return "Averages frequency responses from all inputs of a stream to its class.";
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
        int output = header.classIndex();
        int[] columns = IntStream.concat(IntStream.range(timed ? 1 : 0, header.numAttributes()).filter(a -> a != output),
                IntStream.of(output)).toArray();
        if (columns.length < 2) {
            throw new DataFault("the stream has no input beside its class " + header.attribute(header.classIndex()).name());
        }
        LearningCurve curve = new LearningCurve(TIME);
        FirstTwo begun = FirstTwo.of(stream, "nothing to average");
        Average average = new Average(header, columns, timed, begun.rate(timed, rateOption.getValue()));
        average.accept(begun.first(), curve);
        average.accept(begun.second(), curve);
        for (long count = 2; stream.hasMoreInstances(); count++) {
            average.accept(stream.nextInstance().getData(), curve);
            if (count % BETWEEN_MONITOR_LOOKS == 0) {
                if (monitor.taskShouldAbort()) {
                    return curve;
                }
                monitor.setCurrentActivityFractionComplete(count / (double) (count + stream.estimatedRemainingInstances()));
            }
        }
        average.finish(curve);
        return curve;
    }

    /** One run through a stream. */
    private final class Average {

        private final InstancesHeader header;
        private final int[] columns;
        private final boolean timed;
        private final double rate;
        private final SpectralMatrix spectra;
        private final GapBridges bridges;
        private final double[] values;
        private double time;
        private double start = Double.NaN;
        private double due;
        private boolean told = true;
        private long count;

        Average(InstancesHeader header, int[] columns, boolean timed, double rate) {
            if (!(rate > 0) || Double.isInfinite(rate)) {
                throw new DataFault("the times of the stream must rise: its first two tell a rate of " + rate + " Hz");
            }
            this.header = header;
            this.columns = columns;
            this.timed = timed;
            this.rate = rate;
            Segmentation segmentation = Segmentation.lasting(rate, segmentOption.getValue());
            double memory = halfLifeOption.getValue() == 0 ? 1
                    : Math.pow(0.5, segmentation.hop() / rate / halfLifeOption.getValue());
            this.spectra = new SpectralMatrix(segmentation, Detrend.MEAN, columns.length, memory);
            this.bridges = new GapBridges(columns.length, Math.max(1, (int) Math.round(LONGEST_BRIDGE * rate)));
            this.values = new double[columns.length];
        }

        void accept(Instance instance, LearningCurve curve) {
            double now = timed ? instance.value(0) : count / rate;
            if (count == 0) {
                start = now;
                due = now + intervalOption.getValue();
            }
            long missing = count == 0 ? 0 : Math.round((now - time) * rate) - 1;
            for (long i = 0; i < Math.min(missing, 2L * spectra.segmentation().length()); i++) {
                push(Double.NaN, instance);
            }
            time = now;
            count++;
            push(1, instance);
            if (time >= due - 1e-9) {
                tell(curve);
                due += intervalOption.getValue() * Math.max(1, Math.ceil((time - due) / intervalOption.getValue()));
            }
        }

        /** @param present 1, or NaN for a sample that is not there */
        private void push(double present, Instance instance) {
            for (int i = 0; i < values.length; i++) {
                values[i] = present * instance.value(columns[i]);
            }
            if (bridges.accept(values)) {
                told &= !spectra.accept(values);
            }
        }

        void finish(LearningCurve curve) {
            for (int late = bridges.delay(); late > 0; late--) {
                Arrays.fill(values, Double.NaN);
                if (bridges.accept(values)) {
                    told &= !spectra.accept(values);
                }
            }
            int inputs = columns.length - 1;
            if (spectra.independent() <= inputs) {
                ResponseMatrix.of(spectra, inputs, Excited.USUAL);   // says what is missing
            }
            if (!told) {
                tell(curve);
            }
        }

        private void tell(LearningCurve curve) {
            int inputs = columns.length - 1;
            if (spectra.independent() <= inputs) {
                return;
            }
            ResponseMatrix h = ResponseMatrix.of(spectra, inputs, Excited.USUAL);
            List<Measurement> all = new ArrayList<>();
            all.add(new Measurement(TIME, time - start));
            all.add(new Measurement("independent averages", h.averages()));
            for (int i = 0; i < inputs; i++) {
                String name = header.attribute(columns[i]).name();
                Peak peak = Peak.of(h.frequency(), h.h1(0, i).magnitudes(), h.usable(0, i))
                        .orElse(new Peak(Double.NaN, Double.NaN));
                int bin = (int) Math.round(peak.frequency() / h.frequency()[1]);
                boolean known = Double.isFinite(peak.frequency());
                all.add(new Measurement("peak of H1 from " + name, peak.height()));
                all.add(new Measurement("95 % margin of peak of H1 from " + name, known ? h.margin(0, i, 0.95)[bin]
                        : Double.NaN));
                all.add(new Measurement("peak frequency from " + name + " [Hz]", peak.frequency()));
                all.add(new Measurement("partial coherence at peak from " + name, known ? h.partialCoherence(0, i)[bin]
                        : Double.NaN));
            }
            curve.insertEntry(new LearningEvaluation(all.toArray(Measurement[]::new)));
            told = true;
        }
    }
}
