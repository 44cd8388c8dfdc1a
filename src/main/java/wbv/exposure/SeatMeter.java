package wbv.exposure;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleConsumer;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.Quantity;
import wbv.recording.inspect.Finding;
import wbv.recording.inspect.Inspection;
import wbv.recording.inspect.RowSource;
import wbv.recording.inspect.UniformReader;
import wbv.signal.Detrend;
import wbv.signal.Envelope;
import wbv.signal.GapBridge;
import wbv.signal.PowerSpectrum;
import wbv.signal.Segmentation;
import wbv.signal.ThirdOctaves;

/** Measures a recording in two passes with flat memory: an inspection, then every axis through its exact weighting. */
public final class SeatMeter {

    /** Lowest rate that is accepted [Hz], with room for a quartz that runs slow. */
    private static final double LEAST_RATE = 49;
    private static final double LEAST_SECONDS = 5;
    private static final int HISTORY = 1000;
    /** Samples of each line that are gathered before they are handed out to all that measure. */
    private static final int GATHERED = 8192;
    /** Length of the segments of spectra [s]; it takes that to resolve the band of 0.5 Hz. */
    private static final double SEGMENT = 30;
    private static final List<String> SEATS = List.of("seat", "platform", "floor");
    private static final List<String> BASES = List.of("platform", "floor");

    private final Inspection inspection;
    private final Setup setup;
    private final double rate;
    private final String place;
    private final Optional<String> basePlace;
    private final List<Line> lines = new ArrayList<>();
    private final Map<SeatAxis, Line> seat = new EnumMap<>(SeatAxis.class);
    private final Map<SeatAxis, Line> base = new EnumMap<>(SeatAxis.class);
    private final Map<ComfortAxis, Line> comfort = new EnumMap<>(ComfortAxis.class);
    private final Map<SeatAxis, SeatMeasurement.History> histories = new EnumMap<>(SeatAxis.class);
    private final Map<SeatAxis, Bridged> spectra = new EnumMap<>(SeatAxis.class);
    private final SpinalDose spine = new SpinalDose();
    private final List<Runnable> endings = new ArrayList<>();

    /**
     * What to measure and how.
     *
     * @param place  of the seat; empty to choose seat, platform or floor
     * @param base   below the seat; empty to choose platform or floor
     * @param boxcar true if the sensors' samples are means over the sampling period
     */
    public record Setup(Optional<String> place, Optional<String> base, boolean boxcar) {}

    /** A spectrum that lost packets do not cost whole segments: where they are too many to be bridged, the mean stands in. */
    private static final class Bridged implements DoubleConsumer {
        private final GapBridge bridge;
        private final PowerSpectrum spectrum;
        private final double mean;
        private long taken;
        private long missing;

        private Bridged(GapBridge bridge, PowerSpectrum spectrum, double mean) {
            this.bridge = bridge;
            this.spectrum = spectrum;
            this.mean = mean;
        }

        @Override
        public void accept(double value) {
            double bridged = bridge.accept(value);
            if (++taken > bridge.delay()) {
                boolean absent = Double.isNaN(bridged);
                missing += absent ? 1 : 0;
                spectrum.accept(absent ? mean : bridged);
            }
        }

        /** The density of what was present [(m/s²)²/Hz]. */
        private double[] density() {
            double present = 1 - missing / (double) taken;
            return Arrays.stream(spectrum.density()).map(each -> each / present).toArray();
        }
    }

    /** A channel and what takes its samples. */
    private record Line(Channel channel, Meter meter, List<DoubleConsumer> others) {}

    /** What takes the samples of a line. */
    private record Taker(int line, DoubleConsumer measures) {}

    private final Optional<Meter> sickness;
    private final List<Taker> takers = new ArrayList<>();
    private double[][] gathered = new double[0][];
    private int rows;
    private int[] columns = new int[0];
    private int[][] zeroes = new int[0][];

    private SeatMeter(Inspection inspection, Setup setup) {
        this.inspection = inspection;
        this.setup = setup;
        rate = inspection.clock().rate();
        if (rate < LEAST_RATE) {
            throw DataFault.in(inspection.name(), "is sampled at " + RoundedNumber.text(rate, 4) + " Hz and so ends at "
                    + RoundedNumber.text(rate / 2, 3) + " Hz; exposure is counted up to 80 Hz and needs 50 Hz of sampling at least");
        }
        if (inspection.duration() < LEAST_SECONDS) {
            throw DataFault.in(inspection.name(), "lasts " + RoundedNumber.text(inspection.duration(), 2)
                    + " s; exposure needs 5 s at least, and minutes to say something of a day");
        }
        place = setup.place.orElseGet(() -> SEATS.stream().filter(name -> measured(name).isPresent()).findFirst()
                .orElseThrow(() -> DataFault.in(inspection.name(), "has no acceleration of seat, platform or floor; name the"
                        + " place with --seat: " + places())));
        Quantity quantity = measured(place).orElseThrow(() -> DataFault.in(inspection.name(), "has no acceleration of " + place
                + " that moves; there are " + places()));
        basePlace = setup.base.or(() -> BASES.stream().filter(name -> measured(name).isPresent()).findFirst())
                .filter(name -> !name.equals(place));
        if (setup.base.isPresent() && measured(setup.base.get()).isEmpty()) {
            throw DataFault.in(inspection.name(), "has no acceleration of " + setup.base.get() + "; there are " + places());
        }
        for (SeatAxis axis : SeatAxis.values()) {
            Channel channel = new Channel(place, quantity, axis.letter());
            if (moves(channel)) {
                seat.put(axis, seatLine(axis, channel));
                basePlace.flatMap(this::measured).map(kind -> new Channel(basePlace.get(), kind, axis.letter()))
                        .filter(this::moves)
                        .ifPresent(below -> base.put(axis, line(below, axis.weighting().filter())));
            }
        }
        for (ComfortAxis axis : ComfortAxis.values()) {
            comfortLine(axis);
        }
        Remarks.requireUnits(inspection, lines.stream().map(Line::channel).toList());
        Optional<Line> vertical = Optional.ofNullable(seat.get(SeatAxis.Z));
        sickness = vertical.map(line -> also(line, Weighting.WF.filter()));
        vertical.ifPresent(line -> also(line, new ExactWeigher(SpinalDose.filter(), rate, mean(line.channel), setup.boxcar,
                spine)));
    }

    /**
     * Measures.
     *
     * @param progress told the share of the recording that is done, 0 to 1 or NaN
     * @throws DataFault if the recording is too slow, too short, in the wrong unit, or has no acceleration at the place
     */
    public static SeatMeasurement measure(RowSource source, Setup setup, DoubleConsumer progress) throws IOException {
        Inspection inspection = source.inspect(share -> progress.accept(share / 2));
        try (UniformReader reader = source.uniform(inspection)) {
            SeatMeter meter = of(inspection, setup, reader.channels());
            double[] row = new double[1 + reader.channels().size()];
            for (long sample = 1; reader.read(row); sample++) {
                meter.accept(row);
                if (sample % 2048 == 0) {
                    progress.accept(0.5 + reader.fractionRead() / 2);
                }
            }
            return meter.finish(reader.metadata());
        }
    }

    /**
     * A meter for rows that come from elsewhere: {@link #accept} takes them, {@link #finish} says what they amount to.
     *
     * @param channels of the rows, in their order
     * @throws DataFault if the recording is too slow, too short, in the wrong unit, or has no acceleration at the place
     */
    public static SeatMeter of(Inspection inspection, Setup setup, List<Channel> channels) {
        SeatMeter meter = new SeatMeter(inspection, setup);
        meter.columns = meter.lines.stream().mapToInt(line -> 1 + channels.indexOf(line.channel)).toArray();
        meter.gathered = new double[meter.lines.size()][GATHERED];
        for (int i = 0; i < meter.lines.size(); i++) {
            Line line = meter.lines.get(i);
            meter.takers.add(new Taker(i, line.meter::accept));
            for (DoubleConsumer other : line.others) {
                meter.takers.add(new Taker(i, other));
            }
        }
        meter.zeroes = meter.lines.stream().map(line -> meter.unread(line.channel.location(), channels)).toArray(int[][]::new);
        return meter;
    }

    /** The kind of acceleration that moves at a place. */
    private Optional<Quantity> measured(String location) {
        for (Quantity quantity : List.of(Quantity.ACCELERATION, Quantity.SPECIFIC_FORCE)) {
            for (SeatAxis axis : SeatAxis.values()) {
                if (Channel.isLocation(location) && moves(new Channel(location, quantity, axis.letter()))) {
                    return Optional.of(quantity);
                }
            }
        }
        return Optional.empty();
    }

    /** True if a channel is there and is not the same number throughout. */
    private boolean moves(Channel channel) {
        return inspection.summaries().containsKey(channel) && inspection.summaries().get(channel).count() > 0
                && inspection.summaries().get(channel).max() > inspection.summaries().get(channel).min();
    }

    private List<String> places() {
        return inspection.summaries().keySet().stream().map(Channel::location).distinct().toList();
    }

    private double mean(Channel channel) {
        return inspection.summaries().get(channel).mean();
    }

    private Line seatLine(SeatAxis axis, Channel channel) {
        Envelope weighted = new Envelope(HISTORY);
        Envelope running = new Envelope(HISTORY);
        AnalogFilter filter = axis.weighting().filter();
        histories.put(axis, new SeatMeasurement.History(weighted, running, 1 / (rate * ExactWeigher.factor(filter, rate))));
        Line line = new Line(channel, Meter.exact(filter, rate, mean(channel), setup.boxcar, (value, mean) -> {
            weighted.accept(value);
            running.accept(mean);
        }), new ArrayList<>());
        lines.add(line);
        int length = Integer.highestOneBit((int) Math.min(2 * SEGMENT * rate, Math.max(8, inspection.samples() / 2)));
        PowerSpectrum spectrum = new PowerSpectrum(new Segmentation(rate, length, 0.5), Detrend.MEAN);
        Bridged bridged = new Bridged(new GapBridge(Weigher.longestBridge(rate)), spectrum, mean(channel));
        spectra.put(axis, bridged);
        line.others.add(bridged);
        return line;
    }

    private Line line(Channel channel, AnalogFilter filter) {
        Line line = new Line(channel, Meter.exact(filter, rate, mean(channel), setup.boxcar), new ArrayList<>());
        lines.add(line);
        return line;
    }

    private Meter also(Line line, AnalogFilter filter) {
        Meter meter = Meter.exact(filter, rate, mean(line.channel), setup.boxcar);
        line.others.add(meter::accept);
        endings.add(meter::finish);
        return meter;
    }

    private void also(Line line, Weigher weigher) {
        line.others.add(weigher::accept);
        endings.add(weigher::finish);
    }

    private void comfortLine(ComfortAxis axis) {
        String location = axis.rotates() ? place : axis.point();
        if (axis.point().equals("seat")) {
            return; // the same weightings as for health
        }
        List<Quantity> kinds = axis.rotates() ? List.of(Quantity.ANGULAR_RATE)
                : List.of(Quantity.ACCELERATION, Quantity.SPECIFIC_FORCE);
        kinds.stream().map(kind -> new Channel(location, kind, axis.axis())).filter(this::moves).findFirst()
                .ifPresent(channel -> comfort.put(axis, line(channel, axis.filter())));
    }

    /** Takes a row on the uniform clock: its time [s], then by channel what each reads, in its own unit; NaN is missing. Not modified. */
    public void accept(double[] row) {
        for (int i = 0; i < columns.length; i++) {
            gathered[i][rows] = allZero(row, zeroes[i]) ? Double.NaN : row[columns[i]];
        }
        if (++rows == GATHERED) {
            handOut();
        }
    }

    /**
     * Gives what was gathered to all that measure, side by side: none knows of another, so that the results are those of one after the
     * other.
     */
    private void handOut() {
        takers.parallelStream().forEach(taker -> {
            for (int i = 0; i < rows; i++) {
                taker.measures.accept(gathered[taker.line][i]);
            }
        });
        rows = 0;
    }

    /** Columns of a place that are exactly zero together where its sensor gave no reading; none if there is no such row. */
    private int[] unread(String location, List<Channel> channels) {
        boolean gaps = inspection.findings().stream().anyMatch(finding -> finding instanceof Finding.ZeroRows zero
                && zero.location().equals(location) && !zero.leading());
        return gaps ? channels.stream().filter(channel -> channel.location().equals(location))
                .mapToInt(channel -> 1 + channels.indexOf(channel)).toArray() : new int[0];
    }

    private static boolean allZero(double[] row, int[] columns) {
        for (int column : columns) {
            if (row[column] != 0) {
                return false;
            }
        }
        return columns.length > 0;
    }

    /**
     * Ends the stream and says what it amounts to. Feed nothing afterwards.
     *
     * @param metadata what is known of the recording
     * @throws DataFault if the seat's samples were missing all the time
     */
    public SeatMeasurement finish(Metadata metadata) {
        handOut();
        lines.forEach(line -> line.meter.finish());
        endings.forEach(Runnable::run);
        Map<SeatAxis, Vibration> axes = vibrations(seat);
        if (axes.isEmpty()) {
            throw DataFault.in(inspection.name(), "has no stretch of " + place + " without gaps that could be weighed");
        }
        Map<ComfortAxis, Double> levels = new EnumMap<>(ComfortAxis.class);
        axes.forEach((axis, vibration) -> levels.put(ComfortAxis.valueOf("SEAT_" + axis), vibration.rms()));
        comfort.forEach((axis, line) -> levels.put(axis, line.meter.vibration().rms()));
        Optional<SeatMeasurement.Spine> dose = Optional.ofNullable(axes.get(SeatAxis.Z))
                .map(z -> new SeatMeasurement.Spine(spine.dose(), spine.peaks(), z.seconds()));
        Optional<Remark> unit = AssumedUnit.of(inspection, metadata, seat.values().stream().map(Line::channel).toList(), axes);
        return new SeatMeasurement(inspection, metadata, place, setup.boxcar, axes, vibrations(base), basePlace, levels,
                sickness.map(Meter::vibration), dose, histories, thirdOctaves(), unit,
                Remarks.of(inspection, place, axes, setup.boxcar, lines.stream().map(Line::channel).toList(), unit));
    }

    /** The axes of which something could be measured. */
    private static Map<SeatAxis, Vibration> vibrations(Map<SeatAxis, Line> lines) {
        Map<SeatAxis, Vibration> all = new EnumMap<>(SeatAxis.class);
        lines.forEach((axis, line) -> {
            if (line.meter.vibration().seconds() > 0) {
                all.put(axis, line.meter.vibration());
            }
        });
        return all;
    }

    private Map<SeatAxis, SeatMeasurement.Spectrum> thirdOctaves() {
        Map<SeatAxis, SeatMeasurement.Spectrum> all = new EnumMap<>(SeatAxis.class);
        spectra.forEach((axis, spectrum) -> {
            if (spectrum.spectrum.averaged() > 0) {
                double step = spectrum.spectrum.segmentation().frequency(1);
                CoveredBand band = CoveredBand.of(axis.weighting(), rate);
                double[] density = spectrum.density();
                double to = band.to() * Math.pow(10, -0.05); // the last band ends where the recording does
                for (int k = 0; k < density.length && setup.boxcar; k++) {
                    density[k] *= Math.pow(Boxcar.gain(k * step / rate), 2);
                }
                all.put(axis, new SeatMeasurement.Spectrum(ThirdOctaves.of(density, step, band.from(), to, f -> 1),
                        ThirdOctaves.of(density, step, band.from(), to, axis.weighting()::factor)));
            }
        });
        return all;
    }
}
