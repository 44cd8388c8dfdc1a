package wbv.report.diagnosis;

import java.util.ArrayList;
import java.util.List;
import wbv.diagnosis.picture.Portrait;
import wbv.report.page.Band;
import wbv.report.page.Chart;
import wbv.report.page.ChartAxis;
import wbv.report.page.LineChart;
import wbv.report.page.Series;
import wbv.report.page.XyChart;
import wbv.report.page.XySeries;

/** A portrait as a chart: curves over x where all of it is measured or said over rising x, else points in the plane. */
final class PortraitChart {

    private static final int MEASURED = 0;
    private static final int LAW = 1;
    private static final int REFERENCE = 2;
    private static final int FAINT = 7;

    private PortraitChart() {}

    static Chart of(Portrait portrait) {
        boolean rising = portrait.trails().stream().allMatch(trail -> trail.kind() != Portrait.Kind.SAMPLES
                && trail.kind() != Portrait.Kind.MEAN && rises(trail.x()));
        return rising ? curves(portrait) : plane(portrait);
    }

    private static boolean rises(double[] x) {
        for (int i = 1; i < x.length; i++) {
            if (!(x[i] >= x[i - 1])) {
                return false;
            }
        }
        return true;
    }

    private static ChartAxis axis(Portrait.Scale scale) {
        return scale.log() ? ChartAxis.log(scale.label(), scale.unit()) : ChartAxis.linear(scale.label(), scale.unit());
    }

    private static LineChart curves(Portrait portrait) {
        List<Series> series = new ArrayList<>();
        for (Portrait.Trail trail : portrait.trails()) {
            Series each = trail.kind() == Portrait.Kind.LAW ? Series.dashed(trail.name(), trail.x(), trail.y())
                    : Series.line(trail.name(), trail.x(), trail.y());
            series.add(trail.deviation().length == 0 ? each : each.with(Band.deviations(trail.y(), trail.deviation(), 2, "±2σ")));
        }
        return new LineChart(portrait.title(), axis(portrait.x()), axis(portrait.y()), series).noted(portrait.note());
    }

    private static XyChart plane(Portrait portrait) {
        List<XySeries> series = new ArrayList<>();
        int clouds = 0;
        for (Portrait.Trail trail : portrait.trails()) {
            series.add(switch (trail.kind()) {
                case SAMPLES -> new XySeries(trail.name(), trail.x(), trail.y(), XySeries.Style.CLOUD)
                        .coloured(clouds++ == 0 ? FAINT : MEASURED);
                case MEAN -> new XySeries(trail.name(), trail.x(), trail.y(), doubled(trail.deviation()), XySeries.Style.POINTS,
                        MEASURED);
                case MEASURED -> new XySeries(trail.name(), trail.x(), trail.y(), XySeries.Style.LINE).coloured(MEASURED);
                case LAW -> new XySeries(trail.name(), trail.x(), trail.y(), XySeries.Style.LINE).coloured(LAW);
                case LAW_IN_BAND -> new XySeries(trail.name(), trail.x(), trail.y(), XySeries.Style.DASHED).coloured(LAW);
                case REFERENCE -> new XySeries(trail.name(), trail.x(), trail.y(), XySeries.Style.DASHED).coloured(REFERENCE);
            });
        }
        return new XyChart(portrait.title(), axis(portrait.x()), axis(portrait.y()), series).noted(portrait.note());
    }

    private static double[] doubled(double[] deviation) {
        double[] out = new double[deviation.length];
        for (int i = 0; i < out.length; i++) {
            out[i] = 2 * deviation[i];
        }
        return out;
    }
}
