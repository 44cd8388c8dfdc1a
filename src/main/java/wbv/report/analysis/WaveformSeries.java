package wbv.report.analysis;

import java.util.Arrays;
import wbv.report.page.Band;
import wbv.report.page.Series;
import wbv.study.Waveform;

/** A {@link Waveform} as a curve. */
final class WaveformSeries {

    private WaveformSeries() {}

    /**
     * Its samples, or the middle of their range with the range about it.
     *
     * @param start time of the first sample [s]
     * @param step between samples [s]
     */
    static Series of(String name, Waveform waveform, double start, double step) {
        double[] low = new double[waveform.size()];
        double[] time = new double[low.length];
        Arrays.setAll(low, waveform::smallest);
        for (int i = 0; i < time.length; i++) {
            time[i] = start + (i * (double) waveform.width() + (waveform.width() - 1) / 2.0) * step;
        }
        if (waveform.width() == 1) {
            return Series.line(name, time, low);
        }
        double[] high = new double[low.length];
        double[] middle = new double[low.length];
        Arrays.setAll(high, waveform::largest);
        Arrays.setAll(middle, i -> (low[i] + high[i]) / 2);
        return Series.line(name, time, middle).with(Band.extremes(low, high));
    }
}
