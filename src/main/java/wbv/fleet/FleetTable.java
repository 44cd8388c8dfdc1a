package wbv.fleet;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import wbv.recording.AtomicFile;

/**
 * Tables across seats by the sensors' time, of what seats told: for each period every machine's exposure of the shift so far, on its
 * worst seat, and what was lost; and the seats that are worst off. In a period counts what a seat told last. The machine of a seat
 * is what stands before the last '/' of its name; a seat without is a machine by itself.
 */
public final class FleetTable {

    /** First line of machines.csv, with its end. */
    public static final String MACHINES = "from_s,to_s,machine,seats,a8_m_per_s2,minutes_to_action,minutes_to_limit,"
            + "worst_seat,lost_minutes\n";
    /** First line of worst.csv, with its end. */
    public static final String WORST = "from_s,to_s,rank,seat,a8_m_per_s2,minutes_to_action,minutes_to_limit,lost_minutes\n";
    private static final int LISTED = 10;
    private static final Comparator<
            Entry> WORST_FIRST = Comparator.<Entry>comparingDouble(each -> -each.known()).thenComparing(Entry::seat);

    private final double period;
    private final double rate;
    private final int a8;
    private final int lost;

    /**
     * Looks up the columns.
     *
     * @param header of the results
     * @param period of the tables [s]
     * @param rate   of the samples [Hz]
     */
    public FleetTable(String header, double period, double rate) {
        List<String> names = List.of(header.strip().split(","));
        this.period = period;
        this.rate = rate;
        this.a8 = names.indexOf("a8_m_per_s2");
        this.lost = names.indexOf("lost_samples");
    }

    /**
     * What a seat told last in a period.
     *
     * @param period number of it
     * @param time   by the sensor's clock [s]
     * @param seat   name, as rows have it
     * @param a8     exposure of the shift so far [m/s²], NaN where none is known
     * @param toAction minutes left to the action value, as its row has them
     * @param toLimit likewise
     * @param lostMinutes since the seat was first heard of
     */
    public record Entry(long period, double time, String seat, double a8, String toAction, String toLimit, double lostMinutes) {

        /** What its machine is called. */
        public String machine() {
            int slash = seat.lastIndexOf('/');
            return slash <= 0 ? seat : seat.startsWith("\"") ? seat.substring(0, slash) + '"' : seat.substring(0, slash);
        }

        private double known() {
            return Double.isNaN(a8) ? -1 : a8;
        }
    }

    /**
     * What a row says, for the period that its time falls in.
     *
     * @param row of the results
     */
    public Entry entry(CharSequence row) {
        int name = ResultRows.firstField(row);
        String[] fields = row.subSequence(name, row.length()).toString().strip().split(",", -1); // the first is empty
        boolean exposure = a8 >= 0;
        double time = Double.parseDouble(fields[1]);
        return new Entry((long) Math.floor(time / period), time, row.subSequence(0, name).toString(),
                exposure && !fields[a8].isEmpty() ? Double.parseDouble(fields[a8]) : Double.NaN,
                exposure ? fields[a8 + 2] : "", exposure ? fields[a8 + 3] : "", Double.parseDouble(fields[lost]) / rate / 60);
    }

    /**
     * Appends the rows of a period's machines, the worst first.
     *
     * @param entries one a seat, in any order
     */
    public void machines(Collection<Entry> entries, StringBuilder to) {
        Map<String, List<Entry>> machines = new TreeMap<>();
        entries.forEach(each -> machines.computeIfAbsent(each.machine(), name -> new ArrayList<>()).add(each));
        machines.values().forEach(seats -> seats.sort(WORST_FIRST));
        machines.entrySet().stream().sorted(Comparator.comparingDouble(each -> -each.getValue().get(0).known())).forEach(machine -> {
            List<Entry> seats = machine.getValue();
            Entry worst = seats.get(0);
            begin(worst, to);
            to.append(machine.getKey()).append(',').append(seats.size());
            exposure(worst, to);
            to.append(',').append(worst.seat());
            number(seats.stream().mapToDouble(Entry::lostMinutes).sum(), to);
            to.append('\n');
        });
    }

    /**
     * Appends the rows of a period's worst seats.
     *
     * @param entries one a seat, in any order
     */
    public void worst(Collection<Entry> entries, StringBuilder to) {
        List<Entry> seats = entries.stream().sorted(WORST_FIRST).limit(LISTED).toList();
        for (int k = 0; k < seats.size(); k++) {
            begin(seats.get(k), to);
            to.append(k + 1).append(',').append(seats.get(k).seat());
            exposure(seats.get(k), to);
            number(seats.get(k).lostMinutes(), to);
            to.append('\n');
        }
    }

    private void begin(Entry entry, StringBuilder to) {
        to.append(entry.period() * period).append(',').append((entry.period() + 1) * period).append(',');
    }

    private static void exposure(Entry entry, StringBuilder to) {
        number(entry.a8(), to);
        to.append(',').append(entry.toAction()).append(',').append(entry.toLimit());
    }

    private static void number(double value, StringBuilder to) {
        to.append(',');
        if (!Double.isNaN(value)) {
            to.append((float) value);
        }
    }

    /**
     * Writes machines.csv and worst.csv.
     *
     * @param results file with a header, the rows of each seat in their order
     */
    public void write(Path results, Path folder) throws IOException {
        Map<Long, Map<String, Entry>> periods = new TreeMap<>();
        try (BufferedReader in = Files.newBufferedReader(results)) {
            in.readLine();
            for (String row = in.readLine(); row != null; row = in.readLine()) {
                Entry entry = entry(row);
                periods.computeIfAbsent(entry.period(), each -> new LinkedHashMap<>()).put(entry.seat(), entry);
            }
        }
        StringBuilder machines = new StringBuilder(MACHINES);
        StringBuilder worst = new StringBuilder(WORST);
        periods.values().forEach(entries -> {
            machines(entries.values(), machines);
            worst(entries.values(), worst);
        });
        write(machines, folder.resolve("machines.csv"));
        write(worst, folder.resolve("worst.csv"));
    }

    private static void write(StringBuilder rows, Path file) throws IOException {
        try (AtomicFile whole = AtomicFile.begin(file)) {
            whole.stream().write(rows.toString().getBytes(StandardCharsets.UTF_8));
            whole.finish();
        }
    }
}
