package wbv.rig;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import wbv.rig.platform.Regime;

/**
 * What the rig does, beside what the thesis and others report: the tables of docs/thesis.md, chapter 3. {@code sitters 100}
 * compares the answers of its people, so many of them drawn from the population, with those of people; {@code regimes 120} says
 * what the sensor on the platform reads in each regime of so many seconds.
 */
final class SitterProof {

    private static final Effects LINEAR = Effects.USUAL.without(Effect.SOFTENING);
    private static final int Z = 2;

    private SitterProof() {}

    public static void main(String[] args) {
        if (args[0].equals("regimes")) {
            regimes(Double.parseDouble(args[1]));
        } else {
            sitters(Integer.parseInt(args[1]));
        }
    }

    private static void regimes(double seconds) {
        System.out.println("| regime | x, y, z [m/s²], Table 3-3 | read | about x, y, z [°/s], Table 3-3 | read |");
        System.out.println("|---|---|---|---|---|");
        for (Regime regime : Regime.ALL) {
            RigRun run = RigSpec.parse("regime=" + regime.number() + " channels=platform seconds=" + seconds).run();
            double[] row = new double[7];
            double[] square = new double[6];
            long rows = 0;
            while (run.read(row)) {
                for (int i = 0; i < 6; i++) {
                    square[i] += row[1 + i] * row[1 + i];
                }
                rows++;
            }
            double[] rms = new double[6];
            for (int i = 0; i < 6; i++) {
                rms[i] = Math.sqrt(square[i] / rows) * (i < 3 ? 1 : 180 / Math.PI);
            }
            System.out.printf(Locale.ROOT, "| %d | %.3f %.3f %.3f | %.3f %.3f %.3f | %.3f %.3f %.3f | %.3f %.3f %.3f |%n",
                    regime.number(), regime.x(), regime.y(), regime.z(), rms[0], rms[1], rms[2], regime.roll(), regime.pitch(),
                    regime.yaw(), rms[3], rms[4], rms[5]);
        }
    }

    private static void sitters(int people) {
        System.out.println(
                "| sitter | head over seat, peak | at Hz | apparent mass over sitting mass, peak | at Hz | pelvis over platform, peaks "
                        + "at Hz |");
        System.out.println("|---|---|---|---|---|---|");
        Subject.ALL.forEach(subject -> row("subject " + subject.origin(), List.of(subject)));
        row("erect", List.of(Subject.of(1).withPosture(Posture.ERECT)));
        row("slouched", List.of(Subject.of(1).withPosture(Posture.SLOUCHED)));
        row("population of " + people + ", 5 to 95 %", IntStream.range(0, people).mapToObj(Subject::random).toList());
    }

    private static void row(String name, List<Subject> subjects) {
        List<double[]> figures = subjects.stream().map(SitterProof::figures).toList();
        List<String> cells = new ArrayList<>(List.of(name));
        for (int i = 0; i < 6; i++) {
            int each = i;
            double[] sorted = figures.stream().mapToDouble(f -> f[each]).filter(Double::isFinite).sorted().toArray();
            double low = sorted[(int) Math.round(0.05 * (sorted.length - 1))];
            double high = sorted[(int) Math.round(0.95 * (sorted.length - 1))];
            cells.add(sorted.length == 1 ? number(low) : number(low) + " to " + number(high));
        }
        long two = figures.stream().filter(f -> Double.isFinite(f[5])).count();
        String last = cells.remove(6) + (two < figures.size() ? " (" + two + " people)" : "");
        cells.set(5, cells.get(5) + "; " + last);
        System.out.println("| " + String.join(" | ", cells) + " |");
    }

    /** Peak of the head over the seat and its frequency, the same of the apparent mass, two peaks of the pelvis. */
    private static double[] figures(Subject subject) {
        Sitter sitter = new Sitter.Person(subject);
        List<String> places = sitter.places();
        int seat = places.indexOf("seat");
        Response response = new Response(sitter, LINEAR, 0.125, 1, 16, Z, 1, 20);
        double[] head = response.transmissibility(seat, places.indexOf("head"));
        double[] mass = response.apparentMass(seat);
        double[] pelvis = response.gain(places.indexOf("pelvis"), Z);
        int[] peaks = IntStream.range(1, pelvis.length - 1).filter(i -> pelvis[i] > pelvis[i - 1] && pelvis[i] >= pelvis[i + 1]).toArray();
        return new double[] {max(head), response.frequency(Response.peak(head)), max(mass) / (0.74 * subject.mass()),
            response.frequency(Response.peak(mass)), peaks.length > 0 ? response.frequency(peaks[0]) : Double.NaN,
            peaks.length > 1 ? response.frequency(peaks[1]) : Double.NaN};
    }

    private static double max(double[] curve) {
        return Arrays.stream(curve).max().orElseThrow();
    }

    private static String number(double value) {
        return String.format(Locale.ROOT, "%.2f", value);
    }
}
