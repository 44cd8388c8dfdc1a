package wbv.rig;

import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.zip.GZIPOutputStream;
import wbv.recording.AtomicFile;

/**
 * What is true beside a simulated recording: {@code name.truth.json} holds the experiment, the sitter's parameters at its
 * start and the constant errors of the sensors; {@code name.truth.csv.gz} holds, row by row as the recording, the
 * parameters to the last digit, on an eventful ride what happens, and where asked for the states and what ideal sensors would have given,
 * to seven digits.
 */
final class RigTruth implements Closeable {

    private final RigRun run;
    private final AtomicFile file;
    private final BufferedWriter out;
    private final double[] parameters;
    private final double[] events;
    private final double[] states;
    private final double[] ideal;
    private final StringBuilder line = new StringBuilder();

    /**
     * @param csv the file to write
     * @param full whether states and ideal outputs are wanted
     */
    RigTruth(RigRun run, Path csv, boolean full) throws IOException {
        this.run = run;
        this.file = AtomicFile.begin(csv);
        parameters = new double[run.parameters().size()];
        events = new double[run.events().size()];
        states = new double[full ? run.states().size() : 0];
        ideal = new double[full ? 1 + run.channels().size() : 0];
        out = new BufferedWriter(new OutputStreamWriter(new GZIPOutputStream(file.stream()), StandardCharsets.UTF_8));
        List<String> names = new ArrayList<>(List.of("t"));
        names.addAll(run.parameters());
        names.addAll(run.events());
        if (full) {
            names.addAll(run.states());
            run.channels().forEach(channel -> names.add(channel.toString()));
        }
        out.write(String.join(",", names) + "\n");
    }

    /**
     * Writes the truth of the last row read.
     *
     * @param t its time [s]
     */
    void write(double t) throws IOException {
        line.append(t);
        run.parameters(parameters);
        for (double parameter : parameters) {
            line.append(',').append(parameter);
        }
        run.events(events);
        append(events, 0);
        if (ideal.length > 0) {
            run.states(states);
            append(states, 0);
            run.ideal(ideal);
            append(ideal, 1);
        }
        out.append(line.append('\n'));
        line.setLength(0);
    }

    /** Writes the last byte; the file has no name yet. */
    void end() throws IOException {
        out.close();
    }

    /** Gives the file its name, after {@link #end}. */
    void finish() throws IOException {
        file.finish();
    }

    /** Lets go. Without {@link #finish} nothing is left behind. */
    @Override
    public void close() throws IOException {
        file.close();
    }

    /**
     * The constants of an experiment as JSON.
     *
     * @param run not yet read from
     */
    static String json(RigRun run) {
        double[] parameters = new double[run.parameters().size()];
        run.parameters(parameters);
        List<String> start = new ArrayList<>();
        for (int i = 0; i < parameters.length; i++) {
            start.add(pair(run.parameters().get(i), parameters[i]));
        }
        List<String> errors = new ArrayList<>();
        for (Map.Entry<String, Double> error : run.sensorErrors().entrySet()) {
            errors.add(pair(error.getKey(), error.getValue()));
        }
        StringBuilder json = new StringBuilder("{\n  \"rig\": \"").append(run.spec()).append("\",\n");
        if (run.spec().sitter() instanceof Sitter.Person person) {
            json.append("  \"subject_mass_kg\": ").append(person.subject().mass()).append(",\n");
        }
        json.append("  \"units\": \"omega [rad/s], tilt [rad], bias of acc and accg [m/s2], of gyr [rad/s]\",\n");
        json.append("  \"at_start\": {").append(String.join(", ", start)).append("},\n");
        json.append("  \"sensor_errors\": {\n    ").append(String.join(",\n    ", errors)).append("\n  }\n}\n");
        return json.toString();
    }

    private void append(double[] values, int first) {
        for (int i = first; i < values.length; i++) {
            line.append(',').append((float) values[i]);
        }
    }

    private static String pair(String name, double value) {
        return "\"" + name + "\": " + value;
    }
}
