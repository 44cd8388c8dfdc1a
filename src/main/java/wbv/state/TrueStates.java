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
 * @param states   one for each sample @param seatJerk how the seat really jerked [m/s³]. Not copied. @param headJerk the head
 */
public record TrueStates(List<MotionState> states, double[] seatJerk, double[] headJerk) {

    private static final List<String> COLUMNS = List.of("episode", "jolt", "seat_jerk_m_per_s3", "head_jerk_m_per_s3");

    public TrueStates {
        states = List.copyOf(states);
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
            List<MotionState> states = new ArrayList<>();
            List<double[]> jerks = new ArrayList<>();
            long line = 1;
            for (String text = reader.readLine(); text != null; text = reader.readLine()) {
                line++;
                try {
                    String[] cells = text.split(",");
                    double seat = Double.parseDouble(cells[at[2]]);
                    double head = Double.parseDouble(cells[at[3]]);
                    jerks.add(new double[] {seat, head});
                    states.add(PhysicalLabels.truth((int) Double.parseDouble(cells[at[0]]), Double.parseDouble(cells[at[1]]) > 0,
                            seat, head, thresholds));
                } catch (NumberFormatException | ArrayIndexOutOfBoundsException wrong) {
                    throw DataFault.at(file.toString(), line, "is no row of the rig's truth", wrong);
                }
            }
            return Optional.of(new TrueStates(states, jerks.stream().mapToDouble(each -> each[0]).toArray(),
                    jerks.stream().mapToDouble(each -> each[1]).toArray()));
        }
    }

    /** The states that a track says, against these. @throws DataFault if the lengths differ */
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
        if (track.length() != states.size()) {
            throw new DataFault("the truth beside the recording has " + states.size() + " rows, the recording "
                    + track.length() + "; they do not belong together");
        }
    }
}
