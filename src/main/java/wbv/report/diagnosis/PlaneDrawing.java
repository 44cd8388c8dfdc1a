package wbv.report.diagnosis;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import wbv.body.Model;
import wbv.report.page.ChartAxis;
import wbv.report.page.XyChart;
import wbv.report.page.XySeries;

/** Bodies in a plane seen from the side: where their masses are, their sensors, and the points that hold them. */
final class PlaneDrawing {

    /** Room around what is drawn [m]. */
    private static final double MARGIN = 0.12;
    /** Width over height of a chart as wide as the page. */
    private static final double SHAPE = 3.6;

    private PlaneDrawing() {}

    /** @param missing links or bodies in which something is missing, by name; empty for a model whose places nobody knows */
    static Optional<XyChart> of(Model model, List<String> missing) {
        return model.base().at().map(base -> chart(model, base, missing));
    }

    private static XyChart chart(Model model, Model.Point base, List<String> missing) {
        Map<String, Model.Point> centres = new LinkedHashMap<>();
        model.bodies().forEach(body -> body.at().ifPresent(at -> centres.put(Model.whole(body.name()), at)));
        Set<Model.Point> joints = new LinkedHashSet<>();
        Set<Model.Point> odd = new LinkedHashSet<>();
        List<Model.Point> arms = new ArrayList<>();
        for (Model.Link link : model.links()) {
            link.at().ifPresent(at -> {
                joints.add(at);
                Stream.of(link.from(), link.to()).map(Model::whole).filter(centres::containsKey)
                        .forEach(body -> arms.addAll(List.of(at, centres.get(body))));
                if (missing.contains(link.name())) {
                    odd.add(at);
                }
            });
        }
        centres.keySet().stream().filter(body -> missing.stream().map(Model::whole).anyMatch(body::equals))
                .forEach(body -> odd.add(centres.get(body)));
        Set<Model.Point> sensors = new LinkedHashSet<>(List.of(base));
        List<Model.Point> worn = new ArrayList<>();
        model.sensors().forEach(sensor -> sensor.at().ifPresent(at -> {
            sensors.add(at);
            Optional.ofNullable(centres.get(Model.whole(sensor.body()))).ifPresent(centre -> worn.addAll(List.of(at, centre)));
        }));
        List<XySeries> series = new ArrayList<>();
        series.add(joined("worn by", worn, XySeries.Style.DASHED).coloured(2));
        series.add(joined("held by", arms, XySeries.Style.LINE).coloured(3));
        series.add(points("centres of mass", centres.values()).coloured(0));
        series.add(points("joints", joints).coloured(3));
        series.add(points("sensors", sensors).coloured(2));
        if (!odd.isEmpty()) {
            series.add(points("what is missing acts here", odd).coloured(1));
        }
        List<Model.Point> all = Stream.of(centres.values(), joints, sensors).flatMap(Collection::stream).toList();
        double low = all.stream().mapToDouble(Model.Point::z).min().orElse(0) - MARGIN;
        double high = all.stream().mapToDouble(Model.Point::z).max().orElse(0) + MARGIN;
        double middle = (all.stream().mapToDouble(Model.Point::x).min().orElse(0)
                + all.stream().mapToDouble(Model.Point::x).max().orElse(0)) / 2;
        double half = SHAPE * (high - low) / 2;
        return new XyChart("The bodies from the side", ChartAxis.linear("Forward", "m").within(middle - half, middle + half),
                ChartAxis.linear("Up", "m").within(low, high), series);
    }

    private static XySeries points(String name, Collection<Model.Point> points) {
        return new XySeries(name, points.stream().mapToDouble(Model.Point::x).toArray(),
                points.stream().mapToDouble(Model.Point::z).toArray(), XySeries.Style.POINTS);
    }

    /** Each two of the points, joined. */
    private static XySeries joined(String name, List<Model.Point> pairs, XySeries.Style style) {
        double[] x = new double[pairs.size() / 2 * 3];
        double[] z = new double[x.length];
        for (int i = 0; i < pairs.size(); i += 2) {
            int at = i / 2 * 3;
            for (int end = 0; end < 2; end++) {
                x[at + end] = pairs.get(i + end).x();
                z[at + end] = pairs.get(i + end).z();
            }
            x[at + 2] = Double.NaN;
            z[at + 2] = Double.NaN;
        }
        return new XySeries(name, x, z, style);
    }
}
