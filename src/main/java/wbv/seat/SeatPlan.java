package wbv.seat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import wbv.exposure.Meter;
import wbv.exposure.SeatAxis;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.model.Spec;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.state.StateFilter;
import wbv.state.StateModel;
import wbv.state.StateTrack;
import wbv.state.markov.Forecast;

/** What is to be done with the packets of a seat. Made once and shared by all seats alike; holds what they need not hold each. */
public final class SeatPlan {

    private static final List<String> BASES = List.of("platform", "floor", "seat");
    private static final List<String> SEATS = List.of("seat", "platform", "floor");
    private static final List<String> FOLLOWED = List.of("head", "sternum", "pelvis", "seat");
    /** Lowest rate at which exposure is counted [Hz], with room for a quartz that runs slow. */
    private static final double LEAST_EXPOSURE_RATE = 49;

    private final double rate;
    private final List<Channel> channels;
    private final List<Body> bodies;
    private final Map<SeatAxis, Integer> axes;
    private final Map<SeatAxis, Meter> meters = new EnumMap<>(SeatAxis.class);
    private final boolean boxcar;
    private final Optional<StateModel> states;
    private final Optional<StateFilter> stateFilter;
    private final int[] stateColumns;
    private final List<Forecast> forecasts = new ArrayList<>();
    private final int interval;

    /**
     * A body to follow.
     *
     * @param input channel that shakes it
     * @param output channel of its motion
     */
    public record Body(Channel input, Channel output, EstimatorDesign design, Spec spec) {}

    /**
     * Looks for everything that is needed among the channels.
     *
     * @param rate     of the samples [Hz]
     * @param channels of a packet, in their order
     * @param bodies   to follow; their specs are of the same rate
     * @param place    whose exposure is measured along the axes that there are; empty for none
     * @param boxcar   true if the sensors' samples are means over the sampling period
     * @param states   model of states whose channels there are all
     * @param interval between results [samples], &gt;= 1
     * @throws DataFault if a channel that is needed is not there, or the rate is too low for exposure or not the model's
     */
    public SeatPlan(double rate, List<Channel> channels, List<Body> bodies, Optional<String> place, boolean boxcar,
            Optional<StateModel> states, int interval) {
        if (!(rate > 0) || interval < 1) {
            throw new IllegalArgumentException("rate must be > 0 Hz and the interval >= 1 sample: " + rate + ", " + interval);
        }
        this.rate = rate;
        this.channels = List.copyOf(channels);
        this.bodies = List.copyOf(bodies);
        this.boxcar = boxcar;
        this.states = states;
        this.interval = interval;
        for (Body body : bodies) {
            column(body.input());
            column(body.output());
            if (body.spec().rate() != rate) {
                throw new IllegalArgumentException("a body's rate must be that of the plan: " + body.spec().rate() + ", " + rate);
            }
        }
        this.axes = new EnumMap<>(SeatAxis.class);
        place.ifPresent(where -> axes.putAll(axes(where, channels)));
        if (!axes.isEmpty() && rate < LEAST_EXPOSURE_RATE) {
            throw new DataFault("exposure needs 50 Hz of sampling at least: " + rate);
        }
        axes.keySet().forEach(axis -> meters.put(axis, Meter.stream(axis.weighting().filter(), rate, boxcar)));
        if (place.isPresent() && axes.isEmpty()) {
            throw new DataFault("packets have no acceleration of " + place.get() + "; there are " + channels);
        }
        this.stateFilter = states.map(StateFilter::new);
        this.stateColumns = states.map(model -> model.features().channels().stream().mapToInt(this::column).toArray())
                .orElse(new int[0]);
        states.ifPresent(this::prepare);
    }

    private void prepare(StateModel model) {
        if (Math.abs(model.features().rate() / rate - 1) > 0.01) {
            throw new DataFault("the model of states was trained on " + model.features().rate() + " samples a second, packets have "
                    + rate + "; train one for this rate");
        }
        int delay = model.features().delay();
        for (double horizon : StateTrack.HORIZONS) {
            forecasts.add(new Forecast(model.chain(), model.jerks(), delay + 1,
                    delay + Math.max(1, (int) Math.round(horizon * model.features().rate()))));
        }
    }

    /**
     * The usual plan for channels: the vertical of platform, floor or seat shakes the head (or sternum, pelvis, seat), exposure
     * of seat, platform or floor where the rate allows it, results every second.
     *
     * @param rate   of the samples [Hz]
     * @param states used where the packets have its channels and rate
     */
    public static SeatPlan usual(double rate, List<Channel> channels, Method method, boolean boxcar, Optional<StateModel> states) {
        return usual(rate, channels, method, boxcar, states, (int) Math.max(1, Math.round(rate)));
    }

    /** The same with results every so many samples. */
    public static SeatPlan usual(double rate, List<Channel> channels, Method method, boolean boxcar, Optional<StateModel> states,
            int interval) {
        List<Body> bodies = new ArrayList<>();
        Optional<Channel> input = vertical(BASES, channels);
        Optional<Channel> output = vertical(FOLLOWED, channels.stream().filter(each -> !input.equals(Optional.of(each))).toList());
        if (input.isPresent() && output.isPresent()) {
            bodies.add(new Body(input.get(), output.get(), EstimatorDesign.of(method), Spec.at(rate)));
        }
        Optional<String> place = rate < LEAST_EXPOSURE_RATE ? Optional.empty()
                : SEATS.stream().filter(name -> !axes(name, channels).isEmpty()).findFirst();
        Optional<StateModel> usable = states.filter(model -> channels.containsAll(model.features().channels())
                && Math.abs(model.features().rate() / rate - 1) <= 0.01);
        if (bodies.isEmpty() && place.isEmpty()) {
            throw new DataFault("packets have neither the vertical acceleration of a base and of a body on it, such as platform.acc.z and"
                    + " head.acc.z, nor any acceleration of a seat: " + channels);
        }
        return new SeatPlan(rate, channels, bodies, place, boxcar, usable, interval);
    }

    private static Optional<Channel> vertical(List<String> places, List<Channel> channels) {
        return places.stream().map(place -> new Channel(place, Quantity.ACCELERATION, 'z')).filter(channels::contains).findFirst();
    }

    private static Map<SeatAxis, Integer> axes(String place, List<Channel> channels) {
        Map<SeatAxis, Integer> found = new EnumMap<>(SeatAxis.class);
        for (SeatAxis axis : SeatAxis.values()) {
            for (Quantity quantity : List.of(Quantity.ACCELERATION, Quantity.SPECIFIC_FORCE)) {
                int column = channels.indexOf(new Channel(place, quantity, axis.letter()));
                if (column >= 0) {
                    found.putIfAbsent(axis, column);
                }
            }
        }
        return found;
    }

    /**
     * Place of a channel in a sample.
     *
     * @throws DataFault if it is not there
     */
    int column(Channel channel) {
        int column = channels.indexOf(channel);
        if (column < 0) {
            throw new DataFault("packets have no channel " + channel + "; there are " + channels);
        }
        return column;
    }

    /** Of the packets [Hz]. */
    public double rate() {
        return rate;
    }

    /** Of the packets, in their order. */
    public List<Channel> channels() {
        return channels;
    }

    /** What bodies are followed; none where none was asked for. */
    public List<Body> bodies() {
        return bodies;
    }

    /** Axes whose exposure is measured, and where in a sample they are. */
    public Map<SeatAxis, Integer> axes() {
        return new EnumMap<>(axes);
    }

    /** Whether a sample is the mean over the sampling period, so that its droop is undone. */
    public boolean boxcar() {
        return boxcar;
    }

    /** What motion states are told by; empty where none are. */
    public Optional<StateModel> states() {
        return states;
    }

    /** Samples between results. */
    public int interval() {
        return interval;
    }

    /** A meter of an axis that has heard nothing. */
    Meter meter(SeatAxis axis) {
        return meters.get(axis).fresh();
    }

    /** A filter of the model's states that has heard nothing. */
    StateFilter stateFilter() {
        return stateFilter.orElseThrow();
    }

    /** Everything that seats' results depend on, in one line: seats saved under another plan do not go on under this one. */
    public String text() {
        return rate + " Hz " + channels + " " + bodies + " " + axes + (boxcar ? " boxcar" : "") + " every " + interval
                + states.map(model -> " states " + model.trials() + " " + model.chain().states() + " "
                        + model.thresholds() + " " + model.error() + " " + Arrays.hashCode(model.chain().initial()) + " "
                        + Arrays.deepHashCode(model.chain().transition()) + " " + model.chain().emissions().stream()
                                .flatMap(mixture -> mixture.components().stream()).map(each -> Arrays.hashCode(each.mean())).toList()
                                .hashCode())
                        .orElse("");
    }

    /** The channels that something is done with, in the order of the packets. */
    public List<Channel> needed() {
        Set<Channel> used = new HashSet<>();
        bodies.forEach(body -> used.addAll(List.of(body.input(), body.output())));
        axes.values().forEach(column -> used.add(channels.get(column)));
        states.ifPresent(model -> used.addAll(model.features().channels()));
        return channels.stream().filter(used::contains).toList();
    }

    int[] stateColumns() {
        return stateColumns;
    }

    List<Forecast> forecasts() {
        return forecasts;
    }

    /** Whether a packet has this plan's channels and rate. */
    public boolean fits(Packet packet) {
        return packet.channels() == channels.size() && Math.abs(packet.rate() / rate - 1) <= 0.01;
    }
}
