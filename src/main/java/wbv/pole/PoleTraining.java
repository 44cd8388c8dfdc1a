package wbv.pole;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.ToDoubleBiFunction;
import wbv.filter.model.Bounds.Attribute;
import wbv.identify.Pole;
import wbv.identify.ResponsePool;
import wbv.identify.Samples;
import wbv.identify.SkyhookBody;
import wbv.identify.TunedResponse;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;

/** Learns, from recordings with all sensors, what the poles of a measured place say of places whose sensors will go. */
public final class PoleTraining implements Serializable {

    private static final long serialVersionUID = 1;

    private static final int ORDER = 4;
    private static final double LOW = 0.7;
    private static final double HIGH = 14;
    /** Windows that a pair of clusters must share before polygons are drawn for it. */
    private static final int FEWEST_PAIRS = 10;

    private final Layout layout;
    private final PoleWindows windows;
    private final List<String> trials = new ArrayList<>();
    private final int most;
    private final List<Window> seen = new ArrayList<>();

    /**
     * A window with all its samples: poles by place, and the bodies of one mode.
     *
     * @param who was seen in it
     */
    private record Window(String who, Samples samples, Map<Channel, double[]> outputs, Map<Channel, List<Pole>> poles,
            Map<Channel, SkyhookBody> bodies) implements Serializable {}

    /**
     * What was learned, and how the poles gathered.
     *
     * @param trained the result
     * @param places  clusters of the measured place, then of the absent ones
     * @param pairs   what the polygons that lead to bodies were drawn around, one for each absent place
     */
    public record Result(TrainedPoles trained, List<PlaceClusters> places, List<Pairs> pairs) {
        public Result {
            places = List.copyOf(places);
            pairs = List.copyOf(pairs);
        }
    }

    /**
     * Poles that were seen together, in one window each.
     *
     * @param absent   the absent place
     * @param measured main poles of the measured place
     * @param bodies   bodies of the absent place, as many
     */
    public record Pairs(Channel absent, List<Pole> measured, List<SkyhookBody> bodies) {
        public Pairs {
            measured = List.copyOf(measured);
            bodies = List.copyOf(bodies);
            if (measured.size() != bodies.size()) {
                throw new IllegalArgumentException("pairs need as many bodies as poles: " + measured.size() + ", "
                        + bodies.size());
            }
        }
    }

    /** A training that keeps every window. */
    public PoleTraining(Layout layout, PoleWindows windows) {
        this(layout, windows, Integer.MAX_VALUE);
    }

    /** @param most windows that are kept; beyond them the oldest goes */
    PoleTraining(Layout layout, PoleWindows windows, int most) {
        this.layout = layout;
        this.windows = windows;
        this.most = most;
    }

    /** A recording whose windows are identified. */
    public static final class Trial {
        private final String name;
        private final List<Window> windows = new ArrayList<>();

        private Trial(String name) {
            this.name = name;
        }
    }

    /** Takes a recording that {@link #examine} has identified. */
    public void add(Trial trial) {
        trials.add(trial.name);
        seen.addAll(trial.windows);
    }

    /**
     * Identifies the windows of a recording. Changes nothing, so recordings may be examined at the same time.
     *
     * @param name for messages and provenance
     * @throws DataFault if it lacks a channel
     */
    public Trial examine(String name, Recording recording) {
        layout.requireAll(name, recording);
        Trial trial = new Trial(name);
        double rate = recording.clock().rate();
        double[][] u = layout.inputs().stream().map(channel -> PoleWindows.bridged(recording.values(channel)))
                .toArray(double[][]::new);
        Map<Channel, double[]> outputs = new LinkedHashMap<>();
        outputs.put(layout.measured(), PoleWindows.bridged(recording.values(layout.measured())));
        layout.absent().forEach(channel -> outputs.put(channel, PoleWindows.bridged(recording.values(channel))));
        int samples = windows.samples(name, rate, u.length);
        int hop = windows.hopSamples(rate);
        String who = recording.metadata().subject().map(Object::toString).orElse(name);
        for (int from = 0; from + samples <= recording.length(); from += hop) {
            window(who, u, outputs, from, samples, rate).ifPresent(trial.windows::add);
        }
        return trial;
    }

    /**
     * Takes one window of a stream; one with a gap is passed over.
     *
     * @param u       inputs, as many samples as a window has. Not modified, kept.
     * @param outputs of the measured and the absent places. Not modified, kept.
     * @return whether it was taken
     */
    boolean take(String stream, double rate, double[][] u, Map<Channel, double[]> outputs) {
        if (!trials.contains(stream)) {
            trials.add(stream);
        }
        Optional<Window> whole = window(stream, u, outputs, 0, u[0].length, rate);
        whole.ifPresent(seen::add);
        while (seen.size() > most) {
            seen.remove(0);
        }
        return whole.isPresent();
    }

    private Optional<Window> window(String who, double[][] u, Map<Channel, double[]> outputs, int from, int samples, double rate) {
        Map<Channel, List<Pole>> poles = new LinkedHashMap<>();
        Map<Channel, double[]> cut = new LinkedHashMap<>();
        for (Map.Entry<Channel, double[]> output : outputs.entrySet()) {
            Optional<List<Pole>> modes = windows.window(u, output.getValue(), from, samples, rate);
            if (modes.isEmpty()) {
                return Optional.empty();
            }
            poles.put(output.getKey(), modes.get());
            cut.put(output.getKey(), Arrays.copyOfRange(output.getValue(), from, from + samples));
        }
        double[][] inputs = Arrays.stream(u).map(each -> Arrays.copyOfRange(each, from, from + samples)).toArray(double[][]::new);
        Map<Channel, SkyhookBody> bodies = new HashMap<>();
        double[][] others = Arrays.stream(inputs).skip(1).map(each -> PoleWindows.centred(each, 0, samples)).toArray(double[][]::new);
        for (Channel absent : layout.absent()) {
            SkyhookBody.of(rate, PoleWindows.centred(inputs[0], 0, samples), others, PoleWindows.centred(cut.get(absent), 0, samples))
                    .filter(body -> PoleWindows.plausible(body.frequency(), body.damping())).ifPresent(body -> bodies.put(absent, body));
        }
        return Optional.of(new Window(who, new Samples(rate, inputs, cut.get(layout.measured())), cut, poles, bodies));
    }

    /** Windows taken so far. */
    public int windows() {
        return seen.size();
    }

    /**
     * Gathers, outlines and fits.
     *
     * @throws DataFault if the measured place's poles do not gather
     */
    public Result finish() {
        PlaceClusters measured = clusters(layout.measured());
        int main = measured.largest();
        if (main == Density.NOISE) {
            throw new DataFault("the poles of " + layout.measured() + " form no cluster in " + seen.size()
                    + " windows; record longer, or with more motion of the base");
        }
        Map<Integer, Pole> mainPoles = byWindow(measured, main);
        List<PlaceClusters> places = new ArrayList<>(List.of(measured));
        List<PoleLink> links = new ArrayList<>();
        List<Pairs> pairs = new ArrayList<>();
        Map<Channel, TunedResponse> responses = new HashMap<>();
        Map<Channel, SkyhookBody> bodies = new HashMap<>();
        for (Channel absent : layout.absent()) {
            Map<Integer, SkyhookBody> body = new TreeMap<>();
            for (int i = 0; i < seen.size(); i++) {
                SkyhookBody found = seen.get(i).bodies().get(absent);
                if (found != null) {
                    body.put(i, found);
                }
            }
            links.add(link(absent, PoleLink.BODY, main, mainPoles, body, Attributes.OF_A_BODY, Attributes::of)
                    .orElseThrow(() -> new DataFault(absent
                            + " does not move like a body in enough windows; record longer, or with more motion of the base")));
            List<Integer> shared = shared(mainPoles, body);
            pairs.add(new Pairs(absent, shared.stream().map(mainPoles::get).toList(), shared.stream().map(body::get).toList()));
            bodies.put(absent, SkyhookBody.mean(body.values().stream().toList()));
            PlaceClusters clusters = clusters(absent);
            places.add(clusters);
            for (int m = 0; m < measured.count(); m++) {
                for (int c = 0; c < clusters.count(); c++) {
                    link(absent, "cluster " + c, m, byWindow(measured, m), byWindow(clusters, c),
                            Attributes.OF_A_POLE, Attributes::of).ifPresent(links::add);
                }
            }
            responses.put(absent, response(absent, mainPoles));
        }
        List<Pole> members = measured.members(main);
        ConstraintPolygon outline = ConstraintPolygon.around(Attribute.REAL, Attribute.IMAGINARY,
                members.stream().mapToDouble(Pole::re).toArray(), members.stream().mapToDouble(Pole::im).toArray(),
                ConstraintPolygon.ALPHA);
        Pole typical = new Pole(PolePlane.median(members.stream().mapToDouble(Pole::re).toArray()),
                PolePlane.median(members.stream().mapToDouble(Pole::im).toArray()));
        return new Result(new TrainedPoles(layout, windows, measured.plane(), measured.curve().epsilon(), outline, typical, links,
                responses,
                bodies, trials), places, pairs);
    }

    private PlaceClusters clusters(Channel place) {
        List<Pole> poles = new ArrayList<>();
        List<Integer> window = new ArrayList<>();
        for (int i = 0; i < seen.size(); i++) {
            for (Pole pole : seen.get(i).poles().get(place)) {
                poles.add(pole);
                window.add(i);
            }
        }
        if (!PlaceClusters.enough(poles)) {
            throw new DataFault("only " + poles.size() + " poles of " + place + " in " + seen.size()
                    + " windows without gaps; clusters need longer recordings (a window takes " + windows.length() + " s)");
        }
        return PlaceClusters.of(place, poles, window.stream().mapToInt(Integer::intValue).toArray());
    }

    /** The pole of a cluster in each window that has one. */
    private static Map<Integer, Pole> byWindow(PlaceClusters clusters, int label) {
        Map<Integer, Pole> poles = new TreeMap<>();
        for (int i = 0; i < clusters.poles().size(); i++) {
            if (clusters.dbscan()[i] == label) {
                poles.put(clusters.window()[i], clusters.poles().get(i));
            }
        }
        return poles;
    }

    private <T> Optional<PoleLink> link(Channel absent, String kind, int cluster, Map<Integer, Pole> measured, Map<Integer, T> other,
            List<Attribute> attributes, ToDoubleBiFunction<T, Attribute> value) {
        List<Integer> shared = shared(measured, other);
        if (shared.size() < FEWEST_PAIRS) {
            return Optional.empty();
        }
        List<ConstraintPolygon> polygons = new ArrayList<>();
        List<String> who = shared.stream().map(i -> seen.get(i).who()).toList();
        for (Attribute from : Attributes.OF_A_POLE) {
            double[] x = shared.stream().mapToDouble(i -> Attributes.of(measured.get(i), from)).toArray();
            for (Attribute to : attributes) {
                double[] y = shared.stream().mapToDouble(i -> value.applyAsDouble(other.get(i), to)).toArray();
                polygons.add(ConstraintPolygon.around(from, to, x, y, ConstraintPolygon.ALPHA, who));
            }
        }
        return Optional.of(new PoleLink(absent, kind, cluster, polygons));
    }

    /** Windows that have both. */
    private static List<Integer> shared(Map<Integer, Pole> measured, Map<Integer, ?> other) {
        return measured.keySet().stream().filter(other::containsKey).toList();
    }

    private TunedResponse response(Channel absent, Map<Integer, Pole> measured) {
        ResponsePool pool = new ResponsePool(layout.rates(), LOW, HIGH);
        measured.forEach((i, pole) -> {
            Window window = seen.get(i);
            pool.add(new Samples(window.samples().rate(), window.samples().u(), window.outputs().get(absent)),
                    2 * Math.PI * pole.frequency());
        });
        return pool.fitTuned(ORDER);
    }
}
