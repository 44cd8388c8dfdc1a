package wbv.recording.signals;

import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.IntToDoubleFunction;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.recording.Unit;

/**
 * The signals over time of a universal file: its datasets 58 and 58b, in units that they state themselves or, where they state none, that
 * dataset 164 does. Spectra and geometry are passed over.
 */
final class UffFile {

    private static final String TIME = "t";
    /** Two datasets have one clock if their rates and starts are within this share of each other. */
    private static final double SAME = 1e-6;

    private final String file;
    private final List<UffDataset> signals = new ArrayList<>();
    private final Map<String, String> notes = new LinkedHashMap<>();
    private Optional<double[]> factors = Optional.empty();
    private int others;

    private UffFile(String file) {
        this.file = file;
    }

    static SignalFile read(String file, InputStream content) throws IOException {
        UffFile uff = new UffFile(file);
        UffLines in = new UffLines(file, content);
        while (in.next()) {
            if (in.delimits()) {
                uff.dataset(in);
            }
        }
        return uff.signals();
    }

    private void dataset(UffLines in) throws IOException {
        String number = in.required().strip();
        if (number.equals("58") || number.startsWith("58b") || number.startsWith("58 ")) {
            UffDataset set = UffDataset.read(in);
            if (set.signal()) {
                signals.add(set);
            } else {
                others++;
            }
        } else if (number.equals("164")) {
            in.required();
            notes.put("units", in.field(10, 30));
            in.required();
            factors = Optional.of(new double[] {in.number(0, 25), in.number(25, 50), in.number(50, 75)});
        } else if (number.equals("151")) {
            in.required();
            if (!in.field(0, 80).isEmpty()) {
                notes.put("model", in.field(0, 80));
            }
        }
        while (!in.delimits() && in.next()) {
            // to the end of the dataset
        }
    }

    private SignalFile signals() {
        if (signals.isEmpty()) {
            throw DataFault.in(file, others == 0 ? "has no dataset 58, which signals stand in"
                    : "its " + others + " datasets 58 are spectra or the like; export the signals over time");
        }
        UffDataset first = signals.get(0);
        List<Label> labels = new ArrayList<>();
        List<IntToDoubleFunction> values = new ArrayList<>();
        boolean own = first.times().length > 0 || first.start() != 0;
        if (own) {
            labels.add(new Label(TIME, Optional.empty(), Optional.empty(), Optional.empty(), Optional.of("s"), 1));
            double[] times = times(first);
            values.add(sample -> times[sample]);
        }
        Set<String> names = new HashSet<>(Set.of(TIME));
        for (int i = 0; i < signals.size(); i++) {
            UffDataset set = signals.get(i);
            requireOneClock(first, set, i + 1);
            Label label = label(set, i + 1, names);
            names.add(label.name());
            labels.add(label);
            double[] scaled = scaled(set);
            values.add(sample -> scaled[sample]);
        }
        if (others > 0) {
            notes.put("not read", others + " datasets that are no signals over time");
        }
        return new Signals(labels, values, first.values().length, own ? Optional.of(TIME) : Optional.empty(),
                own ? OptionalDouble.empty() : OptionalDouble.of(first.rate()), notes);
    }

    private static double[] times(UffDataset set) {
        if (set.times().length > 0) {
            return set.times();
        }
        double[] times = new double[set.values().length];
        for (int i = 0; i < times.length; i++) {
            times[i] = set.start() + i / set.rate();
        }
        return times;
    }

    private void requireOneClock(UffDataset first, UffDataset other, int number) {
        boolean even = first.times().length == 0;
        boolean one = first.values().length == other.values().length && even == (other.times().length == 0)
                && (even ? Math.abs(first.rate() - other.rate()) <= SAME * first.rate()
                        && Math.abs(first.start() - other.start()) * first.rate() <= 1e-3
                        : Arrays.equals(first.times(), other.times()));
        if (!one) {
            throw DataFault.in(file,
                    "its signals have no common clock: " + clock(first) + " in the first, " + clock(other) + " in number " + number
                            + "; export those that belong together into a file of their own");
        }
    }

    private static String clock(UffDataset set) {
        return set.values().length + " samples"
                + (set.times().length > 0 ? " at times of their own" : " at " + set.rate() + " Hz from " + set.start() + " s");
    }

    private Label label(UffDataset set, int number, Set<String> taken) {
        Optional<Channel> named = Label.channel(set.title());
        String place = place(set);
        String made = set.title().isEmpty()
                ? (place + " " + set.axis().map(axis -> (set.direction() < 0 ? "-" : "+") + axis).orElse("")).strip() : set.title();
        String name = taken.contains(made) ? made + " #" + number : made;
        Optional<Quantity> quantity = named.map(Channel::quantity).or(set::quantity);
        Optional<String> unit = set.unit().isEmpty()
                ? quantity.filter(known -> factors.isPresent() && !known.unit().equals("V")).map(Quantity::unit)
                : UnitWords.of(set.unit())
                        .filter(symbol -> quantity.isEmpty() || Unit.of(symbol).orElseThrow().dimension().equals(quantity.get().unit()));
        return new Label(name, Optional.of(named.map(Channel::location).orElse(place)), quantity, named.map(Channel::axis).or(set::axis),
                unit, set.direction() < 0 ? -1 : 1);
    }

    /** Entity where each has one node; else with the node's number. */
    private String place(UffDataset set) {
        boolean alone = signals.stream().filter(other -> other.entity().equals(set.entity())).allMatch(other -> other.node() == set.node());
        return set.entity().isEmpty() ? "node_" + set.node() : alone ? set.entity() : set.entity() + "_" + set.node();
    }

    /** Numbers without a unit of their own are SI times the factors of dataset 164. */
    private double[] scaled(UffDataset set) {
        double[] values = set.values();
        if (set.unit().isEmpty() && factors.isPresent()) {
            double[] by = factors.get();
            boolean turns = Math.abs(set.direction()) > 3;
            double factor = switch (set.type()) {
                case 8, 11, 12 -> turns ? 1 : by[0];
                case 9, 13 -> by[1];
                default -> 1;
            };
            for (int i = 0; i < values.length; i++) {
                values[i] /= factor;
            }
        }
        return values;
    }
}
