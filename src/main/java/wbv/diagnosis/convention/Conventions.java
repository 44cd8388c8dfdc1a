package wbv.diagnosis.convention;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import wbv.body.Model;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.Recording;
import wbv.recording.Unit;

/** The conventions that a recording and a model may have otherwise than they are read. */
final class Conventions {

    private Conventions() {}

    /**
     * Of the channels that the model has to do with, and of its numbers.
     *
     * @param units     whether units are in question, of the model too, and not signs and names alone
     * @param modelsOwn whether the model's numbers are its user's: those of one that was fitted to a simulation hold whatever is read of
     *                      what drove it, so that only its outputs are in question
     */
    static List<Convention> of(Model model, Recording recording, boolean units, boolean modelsOwn) {
        // Of what no recording tells apart the first is named: a force, whose sign is anybody's choice, before a motion.
        List<Channel> sensors = (modelsOwn ? model.channels() : model.outputs()).stream()
                .sorted(Comparator.comparing(channel -> channel.quantity() != Quantity.FORCE)).toList();
        List<Convention> all = new ArrayList<>();
        for (Channel channel : sensors) {
            all.add(new Convention.Misread(channel, -1, ""));
            if (units) {
                misread(channel, all);
            }
        }
        for (int i = 0; i < sensors.size(); i++) {
            for (Channel other : sensors.subList(i + 1, sensors.size())) {
                exchanged(sensors.get(i), other, all);
            }
            // Of what the model does not read, another axis of the same sensor alone: what reads like a sensor's twin may be one.
            for (Channel other : recording.channels()) {
                if (!sensors.contains(other) && other.location().equals(sensors.get(i).location())) {
                    exchanged(sensors.get(i), other, all);
                }
            }
        }
        if (units && modelsOwn) {
            all.addAll(List.of(new Convention.InUnits("masses", 1, 1, 1e-3, "g"),
                    new Convention.InUnits("stiffnesses", 1e3, 1, 1, "N/mm"),
                    new Convention.InUnits("dampings", 1, 1e3, 1, "N s/mm"),
                    new Convention.InUnits("stiffnesses and dampings", 1e3, 1e3, 1, "N/mm and N s/mm")));
        }
        return all;
    }

    private static void misread(Channel channel, List<Convention> all) {
        List<Double> known = new ArrayList<>(List.of(1.0));
        for (String symbol : Unit.symbols(channel.quantity().unit()).split(", ")) {
            double factor = 1 / Unit.of(symbol).orElseThrow().toSi(1);
            if (known.stream().noneMatch(other -> Math.abs(other / factor - 1) < 1e-9)) {
                known.add(factor);
                all.add(new Convention.Misread(channel, factor, symbol));
                all.add(new Convention.Misread(channel, -factor, symbol));
            }
        }
    }

    private static void exchanged(Channel one, Channel other, List<Convention> all) {
        if (one.quantity() == other.quantity()) {
            all.add(new Convention.Exchanged(one, other));
        }
    }
}
