package wbv.state;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.zip.GZIPInputStream;
import wbv.recording.DataFault;

/**
 * What truly happened on a simulated ride, sample by sample, as the rig wrote it beside the recording: {@code name.truth.csv.gz}
 * with the columns {@code episode}, {@code jolt}, {@code seat_jerk_m_per_s3} and {@code head_jerk_m_per_s3}.
 *
 * @param activities what was done to the sitter, one for each sample
 * @param states   one for each sample
 * @param seatJerk by sample, how the seat really jerked [m/s³]. Not copied.
 * @param headJerk the head, likewise
 */
public record TrueStates(List<Activity> activities, List<MotionState> states, double[] seatJerk, double[] headJerk) {

    private static final List<String> COLUMNS = List.of("episode", "jolt", "seat_jerk_m_per_s3", "head_jerk_m_per_s3");

    public TrueStates {
        activities = List.copyOf(activities);
        states = List.copyOf(states);
    }

    /**
     * From what the rig said row by row.
     *
     * No array is modified.
     *
     * @param episode by row [1]: 0 idle, 1 riding, 2 rocking
     * @param jolt by row [1]: whether above 0 one acts
     * @param seatJerk by row [m/s³]. Not copied.
     * @param headJerk likewise
     */
    public static TrueStates of(double[] episode, double[] jolt, double[] seatJerk, double[] headJerk, Thresholds thresholds) {
        List<Activity> activities = new ArrayList<>();
        List<MotionState> states = new ArrayList<>();
        for (int i = 0; i < episode.length; i++) {
            activities.add(PhysicalLabels.activity((int) episode[i], jolt[i] > 0));
            states.add(PhysicalLabels.truth(activities.get(i), seatJerk[i], headJerk[i], thresholds));
        }
        return new TrueStates(activities, states, seatJerk, headJerk);
    }

    /**
     * What one row of the rig's truth is.
     *
     * @param episode as for {@link #of}
     * @param jolting whether one acts
     * @param seatJerk [m/s³]
     * @param headJerk [m/s³]
     */
    public static MotionState state(int episode, boolean jolting, double seatJerk, double headJerk, Thresholds thresholds) {
        return PhysicalLabels.truth(PhysicalLabels.activity(episode, jolting), seatJerk, headJerk, thresholds);
    }

    /** The truth beside a recording; empty if there is none, or it says nothing of what happened. */
    public static Optional<TrueStates> beside(Path recording, Thresholds thresholds) throws IOException {
        String name = recording.getFileName().toString().replaceFirst("(?i)\\.(arff|csv)(\\.gz)?$", "");
        Path truth = recording.resolveSibling(name + ".truth.csv.gz");
        return Files.exists(truth) ? read(truth, thresholds) : Optional.empty();
    }

    private static Optional<TrueStates> read(Path file, Thresholds thresholds) throws IOException {
        try (InputStream in = Files.newInputStream(file); BufferedReader reader = new BufferedReader(
                new InputStreamReader(new GZIPInputStream(in), StandardCharsets.UTF_8))) {
            List<String> header = Arrays.asList(Optional.ofNullable(reader.readLine()).orElse("").split(","));
            int[] at = COLUMNS.stream().mapToInt(header::indexOf).toArray();
            if (Arrays.stream(at).anyMatch(i -> i < 0)) {
                return Optional.empty();
            }
            List<double[]> rows = new ArrayList<>();
            long line = 1;
            for (String text = reader.readLine(); text != null; text = reader.readLine()) {
                line++;
                try {
                    String[] cells = text.split(",");
                    rows.add(Arrays.stream(at).mapToDouble(i -> Double.parseDouble(cells[i])).toArray());
                } catch (NumberFormatException | ArrayIndexOutOfBoundsException wrong) {
                    throw DataFault.at(file.toString(), line, "is no row of the rig's truth", wrong);
                }
            }
            double[][] columns = new double[at.length][];
            for (int c = 0; c < at.length; c++) {
                int column = c;
                columns[c] = rows.stream().mapToDouble(row -> row[column]).toArray();
            }
            return Optional.of(of(columns[0], columns[1], columns[2], columns[3], thresholds));
        }
    }

    /**
     * The states that a track says, against these.
     *
     * @throws DataFault if the lengths differ
     */
    public Confusion against(StateTrack track, boolean live) {
        require(track);
        Confusion confusion = new Confusion();
        for (int i = 0; i < states.size(); i++) {
            confusion.add(states.get(i), live ? track.live(i) : track.state(i));
        }
        return confusion;
    }

    /** A track's forecast of a jerk, against whether one came. */
    public void addTo(Reliability reliability, StateTrack track, int horizon) {
        require(track);
        int ahead = track.samples(horizon);
        int last = -1;
        int[] next = new int[states.size()];
        for (int i = states.size() - 1; i >= 0; i--) {
            next[i] = last;
            last = states.get(i).jerk() ? i : last;
        }
        for (int i = 0; i + ahead < states.size(); i++) {
            reliability.add(track.forecast(horizon, i), next[i] >= 0 && next[i] <= i + ahead);
        }
    }

    private void require(StateTrack track) {
        require(track.length());
    }

    /** @throws DataFault if a recording has another number of samples */
    void require(int length) {
        if (length != states.size()) {
            throw new DataFault("the truth beside the recording has " + states.size() + " rows, the recording " + length
                    + "; they do not belong together");
        }
    }
}
