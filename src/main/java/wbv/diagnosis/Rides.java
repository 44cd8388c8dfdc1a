package wbv.diagnosis;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Recording;

/**
 * Several recordings of one subject with the same sensors, laid end to end with a pause between in which nothing is known, so that what
 * rang at the end of one is over where the next begins: one set of numbers is fitted to all of them. One that is to prove them comes last.
 *
 * @param recording  all of them, on the clock of the first
 * @param provedFrom time of the first sample that serves for the proof only [s]; empty where the end of the one recording does
 * @param moved      how much later the samples that prove stand than on their own clock [s]
 */
public record Rides(Recording recording, OptionalDouble provedFrom, double moved) {

    /** As long as a sitter rings after a ride, and a little longer [s]. */
    private static final double PAUSE = 4;
    /** Shorter, what rings at its start would be most of it [s]. */
    private static final double SHORTEST = 5;
    /** Relative difference of two rates that shifts the samples of a ride of an hour by less than one in five hundred thousand. */
    private static final double ALIKE = 1e-5;

    /** One recording, of which the end proves what was fitted to the rest. */
    public static Rides of(Recording one) {
        return new Rides(one, OptionalDouble.empty(), 0);
    }

    /**
     * Several.
     *
     * @param fitted what is fitted, in the order of their names, with the words that messages call them
     * @param proof  what is held out
     * @throws DataFault if they have another rate or no channel in common
     */
    public static Rides of(Map<String, Recording> fitted, Optional<Map.Entry<String, Recording>> proof) {
        Map<String, Recording> all = new LinkedHashMap<>(fitted);
        proof.ifPresent(last -> all.put(last.getKey(), last.getValue()));
        if (all.size() == 1) {
            return of(all.values().iterator().next());
        }
        Map.Entry<String, Recording> first = all.entrySet().iterator().next();
        double rate = first.getValue().clock().rate();
        List<Channel> channels = new ArrayList<>(first.getValue().channels());
        for (Map.Entry<String, Recording> each : all.entrySet()) {
            double own = each.getValue().clock().rate();
            if (Math.abs(own / rate - 1) > ALIKE) {
                throw DataFault.in(each.getKey(),
                        String.format(Locale.ROOT, "is sampled at %s Hz, %s at %s Hz: they need one rate", text(own),
                                first.getKey(), text(rate)));
            }
            if (each.getValue().duration() < SHORTEST) {
                throw DataFault.in(each.getKey(),
                        String.format(Locale.ROOT, "lasts %.3g s; one of several recordings needs at least %.0f s",
                                each.getValue().duration(), SHORTEST));
            }
            channels.retainAll(each.getValue().channels());
        }
        if (channels.isEmpty()) {
            throw DataFault.in(first.getKey(),
                    "has no channel in common with " + String.join(", ", fitted.keySet().stream().skip(1).toList()));
        }
        int pause = (int) Math.ceil(PAUSE * rate);
        int length = all.values().stream().mapToInt(each -> each.length() + pause).sum() - pause;
        Map<Channel, double[]> values = new LinkedHashMap<>();
        for (Channel channel : channels) {
            double[] joined = new double[length];
            Arrays.fill(joined, Double.NaN);
            int at = 0;
            for (Recording each : all.values()) {
                System.arraycopy(each.values(channel), 0, joined, at, each.length());
                at += each.length() + pause;
            }
            values.put(channel, joined);
        }
        Recording joined = new Recording(new Clock(first.getValue().clock().start(), rate), values, first.getValue().metadata());
        if (proof.isEmpty()) {
            return new Rides(joined, OptionalDouble.empty(), 0);
        }
        Recording last = proof.get().getValue();
        double from = joined.clock().time(length - last.length());
        return new Rides(joined, OptionalDouble.of(from), from - last.clock().start());
    }

    /** To eight digits, without needless zeros. */
    private static String text(double rate) {
        return new BigDecimal(rate).round(new MathContext(8)).stripTrailingZeros().toPlainString();
    }
}
