package wbv.rig.platform;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/**
 * What the platform is told to do for a while. Levels are accelerations [m/s²] on the translations and rates [rad/s] on the
 * rotations.
 *
 * <p>Each case has a word, which {@link #parse} reads back: {@code idle}, {@code sine:z:5:1.5}, {@code random:z:0.5-12:1},
 * {@code sweep:z:1-9:0.1-2.5:60}, {@code regime:4}, {@code ride:4}; several at once are joined by commas.
 */
public sealed interface PlatformExcitation {

    /**
     * The excitation, started from its beginning.
     *
     * @param h inner step [s]
     * @param seeds its random phases
     */
    PlatformCommand drive(double h, Seeds seeds);

    /** Nothing moves. */
    record Idle() implements PlatformExcitation {
        @Override
        public PlatformCommand drive(double h, Seeds seeds) {
            return (gain, command) -> {};
        }

        @Override
        public String toString() {
            return "idle";
        }
    }

    /**
     * A steady sine.
     *
     * @param axis moved axis
     * @param frequency [Hz], to 50
     * @param amplitude peak [m/s² or rad/s], &gt;= 0
     */
    record Sine(Axis axis, double frequency, double amplitude) implements PlatformExcitation {
        public Sine {
            requireFrequency("sine frequency", frequency);
            requireLevel("sine amplitude", amplitude);
        }

        @Override
        public PlatformCommand drive(double h, Seeds seeds) {
            return new Chirp(this.axis, h, frequency, frequency, amplitude, amplitude, 1);
        }

        @Override
        public String toString() {
            return "sine:" + axis + ':' + SpecNumbers.plain(frequency) + ':' + SpecNumbers.plain(amplitude);
        }
    }

    /**
     * Random motion, nearly normal, with a flat spectrum in a band: a line in every quarter of a hertz, and four at least, each
     * wandering within its cell. The platform follows it flatly to 12 Hz, and by half at 20 Hz in power.
     *
     * @param low lower edge [Hz]
     * @param high upper edge [Hz], to 50
     * @param rms root mean square [m/s² or rad/s], &gt;= 0
     */
    record Random(Axis axis, double low, double high, double rms) implements PlatformExcitation {
        public Random {
            requireFrequency("lower edge of the band", low);
            requireFrequency("upper edge of the band", high);
            if (!(high > low)) {
                throw new IllegalArgumentException("upper edge of the band must be > " + low + " Hz: " + high);
            }
            requireLevel("rms", rms);
        }

        @Override
        public PlatformCommand drive(double h, Seeds seeds) {
            int count = Math.max(4, (int) Math.round((high - low) / 0.25));
            WanderingLines lines = new WanderingLines(count, low, high, rms, h, seeds.source("lines"));
            int index = axis.ordinal();
            return (gain, command) -> command[index] += gain * lines.next();
        }

        @Override
        public String toString() {
            return "random:" + axis + ':' + SpecNumbers.plain(low) + '-' + SpecNumbers.plain(high) + ':' + SpecNumbers.plain(rms);
        }
    }

    /**
     * A sine whose frequency and amplitude run linearly, together, from one value to another; then it starts again, without a
     * jump of phase. Frequency and amplitude are confounded, so softening looks like resonance.
     *
     * @param startFrequency [Hz]
     * @param endFrequency [Hz], to 50
     * @param startAmplitude peak [m/s² or rad/s]
     * @param endAmplitude peak, in the same unit
     * @param seconds time of one run [s], &gt; 0
     */
    record Sweep(Axis axis, double startFrequency, double endFrequency, double startAmplitude, double endAmplitude,
            double seconds) implements PlatformExcitation {

        /**
         * Chapter 4 of the thesis: 1 to 9 Hz while 0.1 to 2.5 m/s² on z.
         *
         * @param seconds time of one run [s]
         */
        public static Sweep chapter4(double seconds) {
            return new Sweep(Axis.Z, 1, 9, 0.1, 2.5, seconds);
        }

        public Sweep {
            requireFrequency("start frequency", startFrequency);
            requireFrequency("end frequency", endFrequency);
            requireLevel("start amplitude", startAmplitude);
            requireLevel("end amplitude", endAmplitude);
            if (!(seconds > 0) || Double.isInfinite(seconds)) {
                throw new IllegalArgumentException("time of a sweep must be > 0 s: " + seconds);
            }
        }

        @Override
        public PlatformCommand drive(double h, Seeds seeds) {
            return new Chirp(axis, h, startFrequency, endFrequency, startAmplitude, endAmplitude, seconds);
        }

        @Override
        public String toString() {
            return "sweep:" + axis + ':' + SpecNumbers.plain(startFrequency) + '-' + SpecNumbers.plain(endFrequency) + ':'
                    + SpecNumbers.plain(startAmplitude) + '-' + SpecNumbers.plain(endAmplitude) + ':' + SpecNumbers.plain(seconds);
        }
    }

    /**
     * One of the nine regimes.
     *
     * @param number 0 to 8
     */
    record OfRegime(int number) implements PlatformExcitation {
        public OfRegime {
            Regime.of(number);
        }

        @Override
        public PlatformCommand drive(double h, Seeds seeds) {
            return Regime.of(number).drive(h, seeds);
        }

        @Override
        public String toString() {
            return "regime:" + number;
        }
    }

    /**
     * Rests, a regime with jolts, and rocking at random times, which stand in the truth.
     *
     * @param number of the regime, 0 to 8
     */
    record Ride(int number) implements PlatformExcitation {
        public Ride {
            Regime.of(number);
        }

        @Override
        public PlatformCommand drive(double h, Seeds seeds) {
            return new EventfulRide(Regime.of(number).drive(h, seeds.of("vibration")), h, seeds.source("episodes"));
        }

        @Override
        public String toString() {
            return "ride:" + number;
        }
    }

    /**
     * Several at once, each with random phases of its own.
     *
     * @param parts two or more, themselves single
     */
    record Together(List<PlatformExcitation> parts) implements PlatformExcitation {
        public Together {
            parts = List.copyOf(parts);
            if (parts.size() < 2 || parts.stream().anyMatch(part -> part instanceof Together || part instanceof Ride)) {
                throw new IllegalArgumentException("two or more excitations can go at once, rides excepted: " + parts);
            }
        }

        @Override
        public PlatformCommand drive(double h, Seeds seeds) {
            List<PlatformCommand> drives = new ArrayList<>();
            for (int i = 0; i < parts.size(); i++) {
                drives.add(parts.get(i).drive(h, seeds.of("part " + i)));
            }
            return (gain, command) -> {
                for (int i = 0; i < drives.size(); i++) {
                    drives.get(i).next(gain, command);
                }
            };
        }

        @Override
        public String toString() {
            return parts.stream().map(PlatformExcitation::toString).collect(Collectors.joining(","));
        }
    }

    /**
     * The excitation that a word says; the axis may be left out and is then z.
     *
     * @throws IllegalArgumentException if the word is none
     */
    static PlatformExcitation parse(String word) {
        if (word.indexOf(',') >= 0) {
            return new Together(Arrays.stream(word.split(",", -1)).map(PlatformExcitation::parse).toList());
        }
        String[] part = word.split(":", -1);
        boolean axisNamed = part.length > 1 && !part[1].isEmpty() && Character.isLetter(part[1].charAt(0));
        Axis axis = axisNamed ? Axis.parse(part[1]) : Axis.Z;
        int i = axisNamed ? 2 : 1;
        int count = part.length - i;
        if (part[0].equals("idle") && part.length == 1) {
            return new Idle();
        }
        if (part[0].equals("regime") && part.length == 2) {
            return new OfRegime(SpecNumbers.parseIndex("regime", part[1], 0, Regime.LAST_NUMBER));
        }
        if (part[0].equals("ride") && part.length == 2) {
            return new Ride(SpecNumbers.parseIndex("regime of the ride", part[1], 0, Regime.LAST_NUMBER));
        }
        if (part[0].equals("sine") && count == 2) {
            return new Sine(axis, SpecNumbers.parse("sine frequency", part[i]), SpecNumbers.parse("sine amplitude", part[i + 1]));
        }
        if (part[0].equals("random") && count == 2) {
            double[] band = range("band", part[i]);
            return new Random(axis, band[0], band[1], SpecNumbers.parse("rms", part[i + 1]));
        }
        if (part[0].equals("sweep") && count == 3) {
            double[] frequency = range("sweep frequencies", part[i]);
            double[] amplitude = range("sweep amplitudes", part[i + 1]);
            return new Sweep(axis, frequency[0], frequency[1], amplitude[0], amplitude[1],
                    SpecNumbers.parse("time of a sweep", part[i + 2]));
        }
        if (word.equals("sweep")) {
            return Sweep.chapter4(60);
        }
        throw new IllegalArgumentException("an excitation is idle, regime:4, ride:4, sine:z:5:1, random:z:0.5-12:1, sweep or "
                + "sweep:z:1-9:0.1-2.5:60: '" + word + "'");
    }

    private static double[] range(String what, String word) {
        String[] ends = word.split("-", -1);
        if (ends.length != 2) {
            throw new IllegalArgumentException(what + " must be two numbers as 0.5-12: '" + word + "'");
        }
        return new double[] {SpecNumbers.parse(what, ends[0]), SpecNumbers.parse(what, ends[1])};
    }

    private static void requireFrequency(String what, double frequency) {
        if (!(frequency > 0 && frequency <= 50)) {
            throw new IllegalArgumentException(what + " must be > 0 to 50 Hz: " + frequency);
        }
    }

    private static void requireLevel(String what, double level) {
        if (!(level >= 0) || Double.isInfinite(level)) {
            throw new IllegalArgumentException(what + " must be >= 0: " + level);
        }
    }
}
