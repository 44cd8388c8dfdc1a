package wbv.body;

import java.util.Optional;
import wbv.body.number.Check;
import wbv.body.number.Key;
import wbv.recording.Channel;

/** What a sensor does to the motion it should report. Faults of one sensor act in the order in which they are listed. Thesis: Eq. 2-30. */
public sealed interface SensorFault {

    /** The word of the mechanism vocabulary, such as {@code sensor.delay}. */
    String mechanism();

    /**
     * What the fault does to the true reading at all times alike: a filter, or nothing. A clock that runs off delays by as much as it does
     * on average.
     *
     * @param seconds length of the recording [s]
     */
    default Optional<SensorFault> filter(double seconds) {
        if (this instanceof Late late) {
            return Optional.of(new Delay(late.mean(seconds), 0));
        }
        return this instanceof MountResonance || this instanceof AcCoupling || this instanceof Gain ? Optional.of(this) : Optional.empty();
    }

    /**
     * The sensor rides on its strap: second-order resonance (thesis Eq. 2-33 to 2-37, as corrected).
     *
     * @param frequency of the mount [Hz], &gt; 0
     * @param dampingRatio of the mount [1], &gt; 0
     */
    record MountResonance(@Key("frequency_hz") double frequency, @Key("damping_ratio") double dampingRatio) implements SensorFault {
        public MountResonance {
            Check.positive("mount frequency", "Hz", frequency);
            Check.positive("mount damping ratio", "1", dampingRatio);
        }

        @Override
        public String mechanism() {
            return "sensor.mount";
        }
    }

    /**
     * The same where what it rides on stiffens as it is stretched, as skin and straps do: {@code ẍ + 2ζω ẋ + ω²(x + c x³) = -a}, of which
     * the sensor reads {@code a + ẍ}; for c = 0 {@link MountResonance}.
     *
     * @param frequency of small motion [Hz], &gt; 0
     * @param dampingRatio of small motion [1], &gt; 0
     * @param cubic c [1/m²], at least 0
     */
    record StiffeningMount(@Key("frequency_hz") double frequency, @Key("damping_ratio") double dampingRatio,
            @Key("cubic_per_m2") double cubic)
            implements SensorFault {
        public StiffeningMount {
            Check.positive("mount frequency", "Hz", frequency);
            Check.positive("mount damping ratio", "1", dampingRatio);
            Check.notNegative("mount stiffening", "1/m²", cubic);
        }

        @Override
        public String mechanism() {
            return "sensor.mount";
        }
    }

    /**
     * The sensor is AC coupled, as charge amplifiers and the inputs of many recorders are: a first-order high-pass
     * {@code j f / fc / (1 + j f / fc)}, by which a constant is lost and whatever is slow leads. What the filter holds when a recording
     * begins is what a silence before it leaves there; a recording that begins otherwise differs by a part that decays with
     * {@code exp(-2π fc t)}, which is what a constant added before the filter makes.
     *
     * @param corner fc, where 0.707 is left and the phase leads by 45° [Hz], &gt; 0
     */
    record AcCoupling(@Key("corner_hz") double corner) implements SensorFault {
        public AcCoupling {
            Check.positive("corner of the AC coupling", "Hz", corner);
        }

        @Override
        public String mechanism() {
            return "sensor.ac-coupled";
        }
    }

    /**
     * The sensor is turned, and all its axes with it. Its other axes' readings are what was recorded, so in their terms the faulty reading
     * is {@code z √(1 + tan²α + tan²β) + x' tan α + y' tan β}: exact, from the third column of a rotation.
     *
     * @param across channel of the one axis
     * @param beside of the other
     * @param towardsX tilt to across [rad]
     * @param towardsY tilt to beside [rad], both within ±1
     */
    record Misalignment(@Key("across") Channel across, @Key("beside") Channel beside, @Key("towards_x_rad") double towardsX,
            @Key("towards_y_rad") double towardsY) implements SensorFault {
        public Misalignment {
            Check.within("tilt towards x", "rad", towardsX, -1, 1);
            Check.within("tilt towards y", "rad", towardsY, -1, 1);
        }

        @Override
        public String mechanism() {
            return "sensor.misalignment";
        }
    }

    /**
     * The sensor is turned about one axis, and all its axes with it. In terms of what its axis across reads, likewise turned, it reads
     * {@code z / cos α + x' tan α}: exact.
     *
     * @param across channel of the axis towards which it is turned
     * @param angle α [rad], within ±1
     */
    record Turned(@Key("across") Channel across, @Key("angle_rad") double angle) implements SensorFault {
        public Turned {
            Check.within("angle", "rad", angle, -1, 1);
        }

        @Override
        public String mechanism() {
            return "sensor.misalignment";
        }
    }

    /** Samples are late. */
    sealed interface Late extends SensorFault {

        /**
         * By how much [s].
         *
         * @param t since the recording began [s]
         */
        double at(double t);

        /**
         * By how much on average [s].
         *
         * @param seconds length of the recording [s]
         */
        double mean(double seconds);

        /** Whether not always by as much. */
        boolean varies();

        /** Whether they are early at some time or other. */
        boolean isEarly();

        @Override
        default String mechanism() {
            return "sensor.delay";
        }
    }

    /**
     * Samples are late, and later and later where the sensor's clock runs slow.
     *
     * @param delay [s]
     * @param drift [s/s]
     */
    record Delay(@Key("delay_s") double delay, @Key("drift_s_per_s") double drift) implements Late {
        public Delay {
            Check.finite("delay", "s", delay);
            Check.within("clock drift", "s/s", drift, -0.01, 0.01);
        }

        @Override
        public double at(double t) {
            return delay + drift * t;
        }

        @Override
        public double mean(double seconds) {
            return at(seconds / 2);
        }

        /** Whether the clock runs off by more than a second in ten years, which no recording shows. */
        @Override
        public boolean varies() {
            return Math.abs(drift) > 3e-9;
        }

        @Override
        public boolean isEarly() {
            return delay < 0 || drift < 0;
        }
    }

    /**
     * Samples are late by what comes and goes, as where a clock is set right from time to time or a link is busy now and then: d + a cos ωt
     * + b sin ωt.
     *
     * @param delay d [s]
     * @param cosine a [s]
     * @param sine b [s]
     * @param frequency ω/2π [Hz], &gt; 0
     */
    record WanderingDelay(@Key("delay_s") double delay, @Key("cosine_s") double cosine, @Key("sine_s") double sine,
            @Key("wandering_hz") double frequency) implements Late {

        public WanderingDelay {
            Check.finite("delay", "s", delay);
            Check.finite("cosine of the delay", "s", cosine);
            Check.finite("sine of the delay", "s", sine);
            Check.positive("frequency at which a delay wanders", "Hz", frequency);
        }

        @Override
        public double at(double t) {
            double phase = 2 * Math.PI * frequency * t;
            return delay + cosine * Math.cos(phase) + sine * Math.sin(phase);
        }

        /** {@inheritDoc} Whole periods. */
        @Override
        public double mean(double seconds) {
            return delay;
        }

        @Override
        public boolean varies() {
            return true;
        }

        @Override
        public boolean isEarly() {
            return delay < swing();
        }

        /** The most that comes and goes [s]. */
        public double swing() {
            return Math.hypot(cosine, sine);
        }
    }

    /**
     * No fault: what else moves the sensor that is known and no part of the model, such as what a simulation gave beside the linear model
     * that stands for it.
     *
     * @param channel that holds it, in the sensor's unit
     */
    record Beside(@Key("beside") Channel channel) implements SensorFault {
        @Override
        public String mechanism() {
            return "beside";
        }
    }

    /**
     * A constant is added.
     *
     * @param bias in the channel's unit
     */
    record Bias(@Key("bias") double bias) implements SensorFault {
        public Bias {
            Check.finite("bias", "channel's unit", bias);
        }

        @Override
        public String mechanism() {
            return "sensor.bias";
        }
    }

    /**
     * Wrong sensitivity.
     *
     * @param factor reported over true, not 0
     */
    record Gain(@Key("factor") double factor) implements SensorFault {
        public Gain {
            Check.finite("gain factor", "1", factor);
        }

        @Override
        public String mechanism() {
            return "sensor.gain";
        }
    }

    /**
     * Values beyond a range are cut.
     *
     * @param low
     * @param high in the channel's unit, low &lt; high
     */
    record Clipping(@Key("low") double low, @Key("high") double high) implements SensorFault {
        public Clipping {
            Check.above("upper clipping level", "channel's unit", high, low);
        }

        @Override
        public String mechanism() {
            return "sensor.clipping";
        }
    }

    /**
     * Values are rounded to whole steps.
     *
     * @param step [the channel's unit], &gt; 0
     * @param level one of the values that it can have, in the channel's unit
     */
    record Quantised(@Key("step") double step, @Key("level") double level) implements SensorFault {
        public Quantised {
            Check.positive("step", "channel's unit", step);
            Check.finite("level", "channel's unit", level);
        }

        @Override
        public String mechanism() {
            return "sensor.quantised";
        }
    }

    /** The sign is lost. */
    record Rectifying() implements SensorFault {
        @Override
        public String mechanism() {
            return "sensor.rectifying";
        }
    }

    /**
     * The sensor sits off the point: rotation adds arm times angular acceleration.
     *
     * @param rate of rotation
     * @param arm [m]
     */
    record LeverArm(@Key("rate") Channel rate, @Key("lever_arm_m") double arm) implements SensorFault {
        public LeverArm {
            Check.finite("lever arm", "m", arm);
        }

        @Override
        public String mechanism() {
            return "coupling.rotation";
        }
    }
}
