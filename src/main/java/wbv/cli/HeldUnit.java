package wbv.cli;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BiConsumer;
import java.util.stream.Collectors;
import wbv.body.Model;
import wbv.diagnosis.Diagnosed;
import wbv.diagnosis.surrogate.Simulated;
import wbv.diagnosis.surrogate.Surrogate;
import wbv.fmi.FittedValues;
import wbv.fmi.FmuSimulation;
import wbv.recording.AtomicFile;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.Recording;
import wbv.recording.format.RecordingWriter;
import wbv.result.OutputFolder;

/**
 * A recording held against a functional mock-up unit: as it is; where sensors do not explain the difference, with its tunable parameters
 * fitted; and where these do not either, as a simulation from which physics was left out.
 *
 * @param name of the unit, for messages
 * @param subject that it simulates, where the user says so
 * @param mass of all that its input moves [kg], likewise
 */
record HeldUnit(FmuSimulation unit, String name, Optional<Model.Subject> subject, OptionalDouble mass, Recording recording,
        OptionalDouble noise, boolean unitsKnown) {

    /** Part of a recording that is fitted, as in every diagnosis. */
    private static final double FITTED = 0.7;

    /**
     * Diagnoses, and writes {@code simulation.csv}, and {@code parameters.json} where these were fitted.
     *
     * @param driver what the user says drove it; else the vertical acceleration that it takes
     */
    Surrogate.Examined examined(Optional<Channel> driver, OutputFolder folder, List<String> notes, BiConsumer<String, Double> progress)
            throws IOException {
        Channel input = driver.orElseGet(this::driver);
        progress.accept("running the simulation", 0.0);
        Simulated simulated = new Simulated(unit.run(Map.of()), name, input, subject, mass);
        notes.addAll(unit.notes());
        RecordingWriter.write(folder.file("simulation.csv"), simulated.outputs());
        Optional<Surrogate.Examined> silent = Surrogate.unremarkable(recording, simulated, noise, unitsKnown, progress);
        if (silent.isPresent() || unit.parameters().isEmpty()) {
            return silent.isPresent() ? silent.get() : Surrogate.examine(recording, simulated, noise, unitsKnown, progress);
        }
        FittedValues fitted = FittedValues.of(unit, recording, (int) (FITTED * recording.length()), progress);
        Recording moved = unit.run(fitted.values());
        Optional<Surrogate.Examined> quiet = Surrogate.unremarkable(recording, simulated.with(moved), noise, unitsKnown, progress);
        if (quiet.isPresent()) {
            AtomicFile.write(folder.file("parameters.json"), json(fitted));
            RecordingWriter.write(folder.file("simulation.csv"), moved);
            Diagnosed found = quiet.get().diagnosed();
            return new Surrogate.Examined(quiet.get().surrogate(),
                    found.afterFitting(sentence(fitted), heldOut(simulated.outputs(), found.diagnosis().fit().heldOut())));
        }
        notes.add("other values of its parameters alone leave " + errors(fitted.after()) + " instead of " + errors(fitted.before())
                + " of what was recorded, which sensors do not explain; it is held against the recording with its own");
        return Surrogate.examine(recording, simulated, noise, unitsKnown, progress);
    }

    private Channel driver() {
        List<Channel> motions = unit.inputs().stream().filter(each -> each.quantity() == Quantity.ACCELERATION).toList();
        return motions.stream().filter(each -> each.axis() == 'z').findFirst().or(() -> motions.stream().findFirst())
                .orElseGet(() -> unit.inputs().get(0));
    }

    private static String errors(Map<Channel, Double> errors) {
        return errors.entrySet().stream().map(each -> String.format(Locale.ROOT, "%.1f %% (%s)", 100 * each.getValue(), each.getKey()))
                .collect(Collectors.joining(", "));
    }

    private String sentence(FittedValues fitted) {
        List<String> moved = new ArrayList<>();
        for (String each : fitted.moved()) {
            moved.add(String.format(Locale.ROOT, "%s %.4g ± %.2g%s instead of %.4g", each, fitted.values().get(each),
                    2 * fitted.std().get(each), unit.unitOf(each).isEmpty() ? "" : " " + unit.unitOf(each), fitted.given().get(each)));
        }
        return "No physics is missing; values of " + name + " were wrong: "
                + (moved.isEmpty() ? "no single one for sure, but together" : String.join(", ", moved)) + ".";
    }

    /** Errors of the simulation as it was, on the data held out. */
    private Map<String, Double> heldOut(Recording simulated, double[] window) {
        int from = (int) Math.max(0, recording.clock().nearest(window[0]));
        int to = (int) Math.min(recording.length(), recording.clock().nearest(window[1]) + 1);
        Map<String, Double> out = new LinkedHashMap<>();
        for (Channel channel : simulated.channels()) {
            if (recording.has(channel)) {
                double[] truth = recording.values(channel);
                double[] model = simulated.values(channel);
                double difference = 0;
                double whole = 0;
                for (int i = from; i < to; i++) {
                    boolean there = !Double.isNaN(truth[i]);
                    difference += there ? Math.pow(truth[i] - model[i], 2) : 0;
                    whole += there ? truth[i] * truth[i] : 0;
                }
                out.put(channel.toString(), Math.sqrt(difference / whole));
            }
        }
        return out;
    }

    /** What was fitted, a parameter a line. */
    private String json(FittedValues fitted) {
        return fitted.values().keySet().stream()
                .map(each -> String.format(Locale.ROOT, "  \"%s\": {\"given\": %s, \"fitted\": %s, \"std\": %s, \"unit\": \"%s\"}",
                        escaped(each), fitted.given().get(each), fitted.values().get(each), fitted.std().get(each),
                        escaped(unit.unitOf(each))))
                .collect(Collectors.joining(",\n", "{\n", "\n}\n"));
    }

    private static String escaped(String text) {
        return text.replace("\\", "\\\\").replace("\"", "\\\"");
    }
}
