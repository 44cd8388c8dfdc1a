package wbv.body;

import wbv.body.number.Check;
import wbv.body.number.Key;
import wbv.recording.Channel;

/** An input beside the base's motion along the model's axis: measured motion of other axes, or a force nobody measured. */
public sealed interface Drive {

    /** The word of the mechanism vocabulary. */
    String mechanism();

    /** Whether it acts on a body; the others act in a link. */
    default boolean actsOnBody() {
        return false;
    }

    /**
     * The lower end of a link is lifted by rotation: arm times the angle.
     *
     * @param rate measured angular rate channel
     * @param arm [m]
     */
    record Rotation(@Key("rate") Channel rate, @Key("lever_arm_m") double arm) implements Drive {
        public Rotation {
            Check.finite("lever arm", "m", arm);
        }

        @Override
        public String mechanism() {
            return "coupling.rotation";
        }
    }

    /**
     * Relative motion along another axis stretches the link: stiffness times the displacement between its ends.
     *
     * @param upper acceleration across at the upper end
     * @param lower likewise at the lower end
     * @param stiffness [N/m]
     */
    record CrossAxis(@Key("upper") Channel upper, @Key("lower") Channel lower,
            @Key("cross_stiffness_N_per_m") double stiffness) implements Drive {
        public CrossAxis {
            Check.finite("cross stiffness", "N/m", stiffness);
        }

        @Override
        public String mechanism() {
            return "coupling.axis";
        }
    }

    /**
     * Relative motion along another axis stretches a link of which one end carries no sensor: that end swings across as one mass on a
     * spring and a dashpot on the base, and rides on the base's rotation at its height.
     */
    sealed interface Swings extends Drive permits UpperSwings, LowerSwings {

        @Override
        default String mechanism() {
            return "coupling.axis";
        }

        /** Measured acceleration of the base across. */
        Channel base();

        /** Measured rate of the base's rotation. */
        Channel rate();

        /** Acceleration across of the end that carries a sensor; that of the base where this end is the base. */
        Channel measured();

        /** [N/m] */
        double stiffness();

        /** Natural frequency of the swing [Hz]. */
        double frequency();

        /** Damping ratio of the swing [1]. */
        double damping();

        /** Of what swings over the base's axis of rotation, of the sign that goes with the rate's [m]. */
        double height();

        /** Whether it is the upper end that swings. */
        boolean above();

        private static void check(double stiffness, double frequency, double damping, double height) {
            Check.finite("cross stiffness", "N/m", stiffness);
            Check.positive("frequency of the swing", "Hz", frequency);
            Check.positive("damping ratio of the swing", "1", damping);
            Check.finite("height", "m", height);
        }
    }

    /**
     * The upper end swings: stiffness times (its displacement less that of the lower end).
     *
     * @param base acceleration across of the base
     * @param rate of the base's rotation
     * @param measured acceleration across of the lower end
     * @param stiffness [N/m]
     * @param frequency of the swing [Hz], &gt; 0
     * @param damping ratio of the swing [1], &gt; 0
     * @param height over the axis of rotation [m]
     */
    record UpperSwings(@Key("swings_on") Channel base, @Key("tilted_by") Channel rate, @Key("lower") Channel measured,
            @Key("cross_stiffness_N_per_m") double stiffness,
            @Key("swing_frequency_hz") double frequency, @Key("swing_damping_ratio") double damping, @Key("height_m") double height)
            implements Swings {
        public UpperSwings {
            Swings.check(stiffness, frequency, damping, height);
        }

        @Override
        public boolean above() {
            return true;
        }
    }

    /**
     * The lower end swings: stiffness times (the displacement of the upper end less its own).
     *
     * @param base as there
     * @param rate as there
     * @param measured acceleration across of the upper end
     * @param stiffness as there
     * @param frequency as there
     * @param damping as there
     * @param height as there
     */
    record LowerSwings(@Key("swings_on") Channel base, @Key("tilted_by") Channel rate, @Key("upper") Channel measured,
            @Key("cross_stiffness_N_per_m") double stiffness,
            @Key("swing_frequency_hz") double frequency, @Key("swing_damping_ratio") double damping, @Key("height_m") double height)
            implements Swings {
        public LowerSwings {
            Swings.check(stiffness, frequency, damping, height);
        }

        @Override
        public boolean above() {
            return false;
        }
    }

    /** What acceleration along another axis does, wherever it acts: mass times acceleration. */
    interface Across {

        /** Measured acceleration along the other axis. */
        Channel across();

        /** Mass that takes part [kg], of either sign. */
        double mass();
    }

    /**
     * Acceleration along another axis pushes a body along the model's: mass times acceleration.
     *
     * @param across measured acceleration along the other axis
     * @param mass that takes part [kg], of either sign
     */
    record AcrossBody(@Key("pushed_by") Channel across, @Key("coupled_mass_kg") double mass) implements Drive, Across {
        public AcrossBody {
            Check.finite("coupled mass", "kg", mass);
        }

        @Override
        public String mechanism() {
            return "coupling.axis";
        }

        @Override
        public boolean actsOnBody() {
            return true;
        }
    }

    /**
     * The same between the ends of a link.
     *
     * @param across as there
     * @param mass as there
     */
    record AcrossLink(@Key("across") Channel across, @Key("coupled_mass_kg") double mass) implements Drive, Across {
        public AcrossLink {
            Check.finite("coupled mass", "kg", mass);
        }

        @Override
        public String mechanism() {
            return "coupling.axis";
        }
    }

    /**
     * A steady force on a body: cosine cos(2πft) + sine sin(2πft).
     *
     * @param cosine [N]
     * @param sine [N]
     * @param frequency f [Hz], &gt; 0
     */
    record Tone(@Key("cosine_N") double cosine, @Key("sine_N") double sine, @Key("frequency_hz") double frequency) implements Drive {
        public Tone {
            Check.finite("cosine amplitude", "N", cosine);
            Check.finite("sine amplitude", "N", sine);
            Check.positive("frequency", "Hz", frequency);
        }

        @Override
        public String mechanism() {
            return "input.unmeasured";
        }

        @Override
        public boolean actsOnBody() {
            return true;
        }
    }

    /**
     * A body that moves when the recording begins: not a mechanism, but where it starts from. Its position then counts as 0.
     *
     * @param velocity against the base at the first sample [m/s]
     */
    record Launch(@Key("velocity_m_per_s") double velocity) implements Drive {
        public Launch {
            Check.finite("velocity at the start", "m/s", velocity);
        }

        @Override
        public String mechanism() {
            return "start";
        }

        @Override
        public boolean actsOnBody() {
            return true;
        }
    }

    /**
     * A force on a body that was measured: an input of the model, not a mechanism.
     *
     * @param channel what measured it [N]
     * @param offset what the sensor reads at no force [N]
     */
    record Measured(@Key("channel") Channel channel, @Key("offset_N") double offset) implements Drive {
        public Measured {
            Check.finite("offset", "N", offset);
        }

        @Override
        public String mechanism() {
            return "input.measured";
        }

        @Override
        public boolean actsOnBody() {
            return true;
        }
    }

    /**
     * What a measured force leaves out because its channel is late: the force by so much later less the force as it was recorded.
     *
     * @param channel what measured it [N]
     * @param delay [s]
     */
    record Late(@Key("late_channel") Channel channel, @Key("delay_s") double delay) implements Drive {
        public Late {
            Check.finite("delay", "s", delay);
        }

        @Override
        public String mechanism() {
            return "sensor.delay";
        }

        @Override
        public boolean actsOnBody() {
            return true;
        }
    }

    /**
     * What a measured force leaves out because its channel is AC coupled, see {@link SensorFault.AcCoupling}: the force that is lost is the
     * integral of what passes, times 2π corner. What it was when the recording began is the channel's offset.
     *
     * @param channel what measured it [N]
     * @param corner [Hz], &gt; 0
     */
    record Coupled(@Key("coupled_channel") Channel channel, @Key("corner_hz") double corner) implements Drive {
        public Coupled {
            Check.positive("corner of the AC coupling", "Hz", corner);
        }

        @Override
        public String mechanism() {
            return "sensor.ac-coupled";
        }

        @Override
        public boolean actsOnBody() {
            return true;
        }
    }

    /**
     * The force that another simulation gave for a link, as a channel of the recording.
     *
     * @param channel what it gave [N]
     * @param share part of it that acts, 1 for all
     */
    record Given(@Key("channel") Channel channel, @Key("share") double share) implements Drive {
        public Given {
            Check.finite("share", "1", share);
        }

        @Override
        public String mechanism() {
            return "given";
        }
    }
}
