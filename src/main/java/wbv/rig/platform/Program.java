package wbv.rig.platform;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.Collectors;

/**
 * Excitations one after another. Each swells and fades over half a second (raised cosine), so that nothing jumps.
 *
 * @param segments at least one
 */
public record Program(List<Segment> segments) {

    private static final double FADE = 0.5;
    private static final double USUAL = 120;
    private static final double INSTANT = 0.0005;

    /**
     * An excitation for a while.
     *
     * @param excitation what
     * @param seconds how long [s], &gt; 0
     */
    public record Segment(PlatformExcitation excitation, double seconds) {
        public Segment {
            if (!(seconds > 0) || Double.isInfinite(seconds)) {
                throw new IllegalArgumentException("time of a segment must be > 0 s: " + seconds);
            }
        }

        @Override
        public String toString() {
            return excitation + "@" + SpecNumbers.plain(seconds);
        }
    }

    public Program {
        segments = List.copyOf(segments);
        if (segments.isEmpty()) {
            throw new IllegalArgumentException("a program needs at least one segment");
        }
    }

    /**
     * One excitation all the time.
     *
     * @param seconds [s]
     */
    public static Program of(PlatformExcitation excitation, double seconds) {
        return new Program(List.of(new Segment(excitation, seconds)));
    }

    /** Length [s]. */
    public double seconds() {
        return segments.stream().mapToDouble(Segment::seconds).sum();
    }

    /**
     * The program that a text says: {@code idle@5+random:0.5-12:1@60+sweep}. A segment without a time, which must be the
     * last, takes what the others leave of the whole; where none is, the platform rests for what they leave.
     *
     * @param whole length [s]; if empty, what the segments say, or two minutes for one without a time
     * @throws IllegalArgumentException if the text is no program or does not fit into the whole
     */
    public static Program parse(String text, OptionalDouble whole) {
        List<Segment> segments = new ArrayList<>();
        double left = whole.orElse(USUAL);
        String[] words = text.split("\\+", -1);
        boolean open = false;
        for (String word : words) {
            String[] part = word.split("@", -1);
            if (part.length > 2) {
                throw new IllegalArgumentException("a segment is an excitation, or excitation@seconds: '" + word + "'");
            }
            if (open) {
                throw new IllegalArgumentException(
                        "only the last segment may leave its time open, so not the one before '" + word + "'");
            }
            open = part.length == 1;
            double time = open ? left : SpecNumbers.parse("time of a segment", part[1]);
            if (whole.isPresent() && !(time > 0 && time <= left + INSTANT) || !(time > 0)) {
                throw new IllegalArgumentException("'" + word + "' does not fit: the segments before it leave "
                        + SpecNumbers.plain(Math.max(0, left)) + " s");
            }
            segments.add(new Segment(PlatformExcitation.parse(part[0]), time));
            left -= time;
        }
        if (whole.isPresent() && left > INSTANT) {
            segments.add(new Segment(new PlatformExcitation.Idle(), left));
        }
        return new Program(segments);
    }

    /** The same excitations, the last one cut or extended so that the whole takes this time [s]. */
    public Program lasting(double seconds) {
        List<Segment> kept = new ArrayList<>();
        double left = seconds;
        for (int i = 0; i < segments.size() && left > 0; i++) {
            Segment segment = segments.get(i);
            boolean last = i == segments.size() - 1;
            double time = last ? left : Math.min(segment.seconds(), left);
            kept.add(new Segment(segment.excitation(), time));
            left -= time;
        }
        return new Program(kept);
    }

    /** Whether it has rides on which things happen, so that what happens belongs to the truth. */
    public boolean eventful() {
        return segments.stream().anyMatch(segment -> segment.excitation() instanceof PlatformExcitation.Ride);
    }

    /**
     * The program from its beginning.
     *
     * @param h inner step [s]
     */
    public PlatformCommand drive(double h, Seeds seeds) {
        return new Playback(h, seeds);
    }

    @Override
    public String toString() {
        return segments.stream().map(Segment::toString).collect(Collectors.joining("+"));
    }

    private final class Playback implements PlatformCommand {
        private final double h;
        private final Seeds seeds;
        private final long fade;
        private int index = -1;
        private long step;
        private long steps;
        private PlatformCommand drive;

        Playback(double h, Seeds seeds) {
            this.h = h;
            this.seeds = seeds;
            this.fade = Math.round(FADE / h);
        }

        @Override
        public void next(double gain, double[] command) {
            while (index < segments.size() && step == steps) {
                index++;
                step = 0;
                if (index < segments.size()) {
                    Segment segment = segments.get(index);
                    steps = Math.round(segment.seconds() / h);
                    drive = segment.excitation().drive(h, seeds.of("segment " + index));
                }
            }
            if (index == segments.size()) {
                return;
            }
            drive.next(gain * swell(Math.min(step, steps - step)), command);
            step++;
        }

        @Override
        public Episode episode() {
            boolean still = index < 0 || index == segments.size()
                    || segments.get(index).excitation() instanceof PlatformExcitation.Idle;
            return still ? Episode.IDLE : drive.episode();
        }

        @Override
        public boolean jolting() {
            return index >= 0 && index < segments.size() && drive.jolting();
        }

        private double swell(long stepsToEdge) {
            return stepsToEdge >= fade ? 1 : 0.5 - 0.5 * StrictMath.cos(Math.PI * stepsToEdge / fade);
        }
    }
}
