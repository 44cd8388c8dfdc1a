package wbv.rig.platform;

import org.apache.commons.math3.random.RandomGenerator;

/**
 * A ride on which things happen at random times that are known: rests, stretches under a regime with jolts, and rocking. All
 * sizes are assumed.
 *
 * <p>Riding lasts 8 to 20 s, rests 4 to 10 s, rocking 6 to 15 s; each swells and fades over a quarter of a second. A jolt is
 * a vertical acceleration A sin(2πt/T) sin(πt/T), which leaves no velocity behind, A from 4 to 9 m/s² up or down first, T
 * from 0.3 to 0.6 s; from one to the next 1.5 to 5 s. Rocking is roll or pitch at 0.5 to 0.9 Hz with a rate of 0.12 to
 * 0.25 rad/s over half the regime's vibration.
 */
final class EventfulRide implements PlatformCommand {

    /** After the end of a jolt the sitter still rings for this long [s] (assumed: three periods of 5 Hz and more). */
    private static final double RINGING = 0.5;
    private static final double FADE = 0.25;

    private final double h;
    private final long fade;
    private final RandomGenerator random;
    private final PlatformCommand vibration;
    private Episode episode = Episode.RIDING;
    private long step;
    private long steps;
    private boolean rested = true;
    private int rockingAxis;
    private double rockingFrequency;
    private double rockingRate;
    private long joltBegins;
    private double joltHeight;
    private double joltTime;

    /** @param vibration the regime, running */
    EventfulRide(PlatformCommand vibration, double h, RandomGenerator random) {
        this.vibration = vibration;
        this.h = h;
        this.fade = Math.round(FADE / h);
        this.random = random;
        begin(Episode.RIDING);
    }

    @Override
    public Episode episode() {
        return episode;
    }

    @Override
    public boolean jolting() {
        return episode == Episode.RIDING && step > joltBegins && step * h <= joltBegins * h + joltTime + RINGING;
    }

    @Override
    public void next(double gain, double[] command) {
        if (step == steps) {
            next();
        }
        double swell = swell(Math.min(step, steps - step));
        if (episode == Episode.RIDING) {
            vibration.next(gain * swell, command);
            command[Axis.Z.ordinal()] += gain * jolt();
        } else if (episode == Episode.ROCKING) {
            vibration.next(0.5 * gain * swell, command);
            command[rockingAxis] += gain * swell * rockingRate * StrictMath.sin(2 * Math.PI * rockingFrequency * step * h);
        }
        step++;
    }

    /** Rests and rocking come in random order, with riding between. */
    private void next() {
        if (episode != Episode.RIDING) {
            begin(Episode.RIDING);
        } else {
            rested = random.nextDouble() < (rested ? 0.3 : 0.7);
            begin(rested ? Episode.IDLE : Episode.ROCKING);
        }
    }

    private void begin(Episode other) {
        episode = other;
        step = 0;
        switch (other) {
            case RIDING -> {
                steps = steps(8, 20);
                joltTime = 0;
                joltBegins = 0;
                plan();
            }
            case IDLE -> steps = steps(4, 10);
            case ROCKING -> {
                steps = steps(6, 15);
                rockingAxis = (random.nextBoolean() ? Axis.ROLL : Axis.PITCH).ordinal();
                rockingFrequency = between(0.5, 0.9);
                rockingRate = between(0.12, 0.25);
            }
        }
    }

    /** The next jolt of this stretch; one that would not have rung out before its end is left out. */
    private void plan() {
        long from = joltBegins + steps(1.5, 5) + Math.round(joltTime / h);
        double height = between(4, 9) * (random.nextBoolean() ? 1 : -1);
        double time = between(0.3, 0.6);
        joltBegins = from * h + time + RINGING < steps * h ? from : Long.MAX_VALUE / 2;
        joltHeight = height;
        joltTime = time;
    }

    private double jolt() {
        double t = (step - joltBegins) * h;
        if (t > joltTime + RINGING) {
            plan();
            return 0;
        }
        return t > 0 && t < joltTime
                ? joltHeight * StrictMath.sin(2 * Math.PI * t / joltTime) * StrictMath.sin(Math.PI * t / joltTime) : 0;
    }

    private double swell(long stepsToEdge) {
        return stepsToEdge >= fade ? 1 : 0.5 - 0.5 * StrictMath.cos(Math.PI * stepsToEdge / fade);
    }

    private double between(double least, double most) {
        return least + (most - least) * random.nextDouble();
    }

    private long steps(double least, double most) {
        return Math.round(between(least, most) / h);
    }
}
