package wbv.recording.format;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Header;
import wbv.recording.Metadata;
import wbv.recording.Quantity;
import wbv.recording.RowReader;
import wbv.recording.signals.Label;
import wbv.recording.signals.SignalFile;
import wbv.recording.signals.SignalKind;

/**
 * UFF 58, MAT, HDF5, Parquet and WAV. A signal that says what it measures, where, along which axis and in which unit is a channel; one that
 * says less is asked for in a column map, which then says everything. Signals of other quantities are passed over.
 */
record SignalFormat(SignalKind kind) implements Format {

    private static final String ADVICE = "say so in a column map: 'wbv map FILE' drafts one, --map takes it";

    @Override
    public boolean recognises(Head head) {
        return SignalKind.of(head.bytes()).filter(found -> found == kind).isPresent();
    }

    @Override
    public RowReader open(Source source, Context context) throws IOException {
        SignalFile signals = kind.open(source.name(), source.path(), source.content());
        List<String> names = signals.labels().stream().map(Label::name).toList();
        Map<String, String> notes = new LinkedHashMap<>(signals.notes());
        ColumnMap map = context.options().map().map(given -> given.time().own() ? given.timed(own(signals, source.name(), context)) : given)
                .orElseGet(() -> said(signals, source.name(), context, notes));
        MappedColumns columns = MappedColumns.of(source.name(), 0, names, map);
        Metadata metadata = context
                .metadata(new Metadata(map.time().rate().isPresent() ? map.time().rate() : signals.rate(), Map.of(), Optional.empty(),
                        Optional.empty(), OptionalDouble.empty(),
                        Optional.of(kind + " file"), notes))
                .withUnits(NamedColumns.known(columns.channels()));
        return new MappedReader(new SignalRows(source, signals, columns.slots()), columns, map.time(), metadata);
    }

    /** The time that the file knows itself. */
    private static ColumnMap.Time own(SignalFile signals, String file, Context context) {
        if (signals.time().isPresent()) {
            return new ColumnMap.Time(Optional.of(new ColumnMap.Column(signals.time().get(), "s", 1)), OptionalDouble.empty(), false);
        }
        OptionalDouble rate = context.rate(signals.rate());
        if (rate.isEmpty()) {
            throw DataFault.in(file, "has neither times (a signal t) nor a rate (a number fs); say it in Hz with --rate");
        }
        return new ColumnMap.Time(Optional.empty(), rate, false);
    }

    /** The map that the signals' own words make. */
    private static ColumnMap said(SignalFile signals, String file, Context context, Map<String, String> notes) {
        Map<Channel, ColumnMap.Column> channels = new LinkedHashMap<>();
        List<String> others = new ArrayList<>();
        for (Label label : signals.labels()) {
            if (signals.time().filter(label.name()::equals).isPresent()) {
                continue;
            }
            Optional<Quantity> quantity = label.quantity();
            if (quantity.isEmpty()) {
                others.add(label.name());
                continue;
            }
            Channel channel = channel(label, quantity.get(), file, context);
            String unit = label.unit().orElseThrow(() -> DataFault.in(file, "the signal '" + label.name() + "' (" + quantity.get().symbol()
                    + ") does not say its unit; " + ADVICE));
            ColumnMap.Column other = channels.put(channel, new ColumnMap.Column(label.name(), unit, label.sign()));
            if (other != null) {
                throw DataFault.in(file,
                        "the signals '" + other.name() + "' and '" + label.name() + "' are both " + channel + "; " + ADVICE);
            }
        }
        if (channels.isEmpty()) {
            throw DataFault.in(file, "no signal says what it measures and where; there are " + Header.shortened(others) + "; " + ADVICE);
        }
        if (!others.isEmpty()) {
            notes.merge("not read", String.join(", ", others), (one, two) -> one + ", " + two);
        }
        return new ColumnMap(file, own(signals, file, context), channels, List.of());
    }

    private static Channel channel(Label label, Quantity quantity, String file, Context context) {
        String place = label.place().map(name -> context.named(name).orElseGet(() -> Channel.isLocation(name) ? name : Context.word(name)))
                .orElseThrow(() -> DataFault.in(file, "the signal '" + label.name() + "' does not say its place; " + ADVICE));
        Optional<Character> axis = quantity.axes().length() == 1 ? Optional.of(quantity.axes().charAt(0)) : label.axis();
        return axis.filter(letter -> quantity.axes().indexOf(letter) >= 0).map(letter -> new Channel(place, quantity, letter))
                .orElseThrow(() -> DataFault.in(file,
                        "the signal '" + label.name() + "' (" + quantity.symbol() + ") does not say its direction; " + ADVICE));
    }
}
