package wbv.network;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import wbv.recording.DataFault;
import wbv.recording.InputFile;

/**
 * What is known of the bodies in recordings: a CSV file, a line for each stretch,
 * {@code recording,from_s,to_s,damping,frequency_Hz}, or with {@code damping1,frequency1_Hz,damping2,frequency2_Hz} for two modes, the
 * slower first. Times are those of the recording's own clock. Lines that are empty or begin with {@code #} say nothing.
 *
 * @param file for messages
 * @param list in the order of the file
 */
public record Labels(String file, int modes, List<Label> list) {

    /** The first lines that are known. */
    public static final List<String> HEADERS = List.of("recording,from_s,to_s,damping,frequency_Hz",
            "recording,from_s,to_s,damping1,frequency1_Hz,damping2,frequency2_Hz");

    private static final double MOST_DAMPING = 3;
    private static final double WINDOW = Imaging.SAMPLES / Imaging.RATE;

    /**
     * A stretch whose body is known. Arrays are not copied: treat them as read-only.
     *
     * @param line      of the file
     * @param recording its name, or the end of its path
     * @param from      beginning [s]
     * @param to        end [s]
     * @param truth     damping ratio and natural pulsation [rad/s] of each mode, slowest first, two numbers for each
     */
    public record Label(long line, String recording, double from, double to, double[] truth) {}

    public Labels {
        list = List.copyOf(list);
    }

    /**
     * Reads a file of labels.
     *
     * @throws DataFault that names the line if the file is none of labels, or a label cannot be
     */
    public static Labels read(Path path) throws IOException {
        String name = path.toString();
        List<String> lines = InputFile.text(path, "labels are a CSV file that begins with " + HEADERS.get(0)).lines().toList();
        int modes = 1 + HEADERS.indexOf(lines.isEmpty() ? "" : lines.get(0).strip());
        if (modes < 1) {
            throw DataFault.at(name, 1, "labels begin with the line " + HEADERS.get(0) + " (or " + HEADERS.get(1) + "): '"
                    + (lines.isEmpty() ? "" : lines.get(0)) + "'");
        }
        List<Label> labels = new ArrayList<>();
        for (int i = 1; i < lines.size(); i++) {
            if (!lines.get(i).isBlank() && !lines.get(i).startsWith("#")) {
                Label label = label(name, i + 1L, lines.get(i), modes);
                labels.stream().filter(other -> other.recording.equals(label.recording) && other.from < label.to && label.from < other.to)
                        .findFirst().ifPresent(other -> {
                            throw DataFault.at(name, label.line, "overlaps line " + other.line + "; a stretch has one label");
                        });
                labels.add(label);
            }
        }
        if (labels.isEmpty()) {
            throw DataFault.in(name, "has no label; below its first line stands one for each stretch, as ride1.csv,0,60,0.35,4.9");
        }
        return new Labels(name, modes, labels);
    }

    /** Those of one recording, by its path or any end of it that begins with a name. */
    public Labels of(Path recording) {
        return new Labels(file, modes, list.stream().filter(label -> recording.normalize().endsWith(Path.of(label.recording).normalize()))
                .toList());
    }

    /** From the right, for a name may hold commas. */
    private static Label label(String file, long line, String text, int modes) {
        String[] cells = text.split(",", -1);
        int numbers = 2 + 2 * modes;
        if (cells.length < 1 + numbers) {
            throw DataFault.at(file, line, "a label has " + (1 + numbers) + " cells, " + HEADERS.get(modes - 1) + ": '" + text + "'");
        }
        double[] value = new double[numbers];
        for (int i = 0; i < numbers; i++) {
            String cell = cells[cells.length - numbers + i].strip();
            try {
                value[i] = Double.parseDouble(cell);
            } catch (NumberFormatException wrong) {
                throw DataFault.at(file, line, "is not a number: '" + cell + "'", wrong);
            }
            if (!Double.isFinite(value[i])) {
                throw DataFault.at(file, line, "must be a finite number: '" + cell + "'");
            }
        }
        if (!(value[1] - value[0] >= WINDOW)) {
            throw DataFault.at(file, line, "a stretch must hold a window, 3.65 s: " + value[0] + " to " + value[1] + " s");
        }
        double[] truth = new double[2 * modes];
        for (int i = 0; i < modes; i++) {
            double damping = value[2 + 2 * i];
            double frequency = value[3 + 2 * i];
            if (!(damping > 0 && damping <= MOST_DAMPING)) {
                throw DataFault.at(file, line, "a damping ratio must be > 0 to 3: " + damping);
            }
            if (!(frequency > 0 && frequency < Imaging.RATE / 2)) {
                throw DataFault.at(file, line, "a frequency must be > 0 to 30 Hz: " + frequency);
            }
            truth[2 * i] = damping;
            truth[2 * i + 1] = 2 * Math.PI * frequency;
        }
        if (modes == 2 && truth[1] > truth[3]) {
            throw DataFault.at(file, line, "the slower mode stands first: " + value[3] + " and " + value[5] + " Hz");
        }
        String recording = String.join(",", List.of(cells).subList(0, cells.length - numbers)).strip();
        recording = recording.length() > 1 && recording.startsWith("\"") && recording.endsWith("\"")
                ? recording.substring(1, recording.length() - 1) : recording;
        if (recording.isEmpty()) {
            throw DataFault.at(file, line, "the first cell names the recording");
        }
        try {
            Path.of(recording);
        } catch (InvalidPathException wrong) {
            throw DataFault.at(file, line, "the first cell must name a file: '" + recording + "'", wrong);
        }
        return new Label(line, recording, value[0], value[1], truth);
    }
}
