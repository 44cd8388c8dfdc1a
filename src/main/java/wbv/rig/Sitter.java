package wbv.rig;

import java.util.List;
import java.util.Optional;
import wbv.rig.platform.SpecNumbers;

/** Who, or what, sits on the platform. */
public sealed interface Sitter {

    /** Where sensors can sit, {@code platform} first. */
    List<String> places();

    /**
     * A change of stiffness: all springs are multiplied at once, masses and dampers stay.
     *
     * @param factor new over old stiffness
     * @param time when [s]
     */
    record Step(double factor, double time) {
        /**
         * @param factor new over old stiffness, 0.001 to 1000
         * @param time when [s], &gt;= 0
         */
        public Step {
            if (!(factor >= 1e-3 && factor <= 1e3)) {
                throw new IllegalArgumentException("stiffness factor must be 0.001 to 1000: " + factor);
            }
            if (!(time >= 0) || Double.isInfinite(time)) {
                throw new IllegalArgumentException("time of the step must be >= 0 s: " + time);
            }
        }

        @Override
        public String toString() {
            return SpecNumbers.plain(factor) + "@" + SpecNumbers.plain(time);
        }
    }

    /**
     * One mass on one spring and damper, vertical: the head of the textbook. Its transmissibility is known in closed form,
     * (2ζωs + ω²) / (s² + 2ζωs + ω²).
     *
     * <p>Where it is coupled, the base's horizontal accelerations push the mass up as well, with m (c_x a_x + c_y a_y), as on
     * a slanting guide or a lever: its vertical acceleration gains s² / (s² + 2ζωs + ω²) · (c_x a_x + c_y a_y).
     *
     * @param zeta damping ratio, 0 to 2
     * @param frequency undamped natural frequency [Hz], to 50
     * @param step change of stiffness
     * @param crossX c_x [1], -2 to 2
     * @param crossY c_y [1], -2 to 2
     */
    record OneDof(double zeta, double frequency, Optional<Step> step, double crossX, double crossY) implements Sitter {

        /**
         * A body that the base's horizontal motion does not push up.
         *
         * @param zeta damping ratio
         * @param frequency [Hz]
         */
        public OneDof(double zeta, double frequency, Optional<Step> step) {
            this(zeta, frequency, step, 0, 0);
        }

        public OneDof {
            if (!(Math.abs(crossX) <= 2 && Math.abs(crossY) <= 2)) {
                throw new IllegalArgumentException("cross-coupling must be -2 to 2: " + crossX + ", " + crossY);
            }
            if (!(zeta >= 0 && zeta <= 2)) {
                throw new IllegalArgumentException("damping ratio must be 0 to 2: " + zeta);
            }
            if (!(frequency > 0 && frequency <= 50)) {
                throw new IllegalArgumentException("natural frequency must be > 0 to 50 Hz: " + frequency);
            }
        }

        @Override
        public List<String> places() {
            return List.of("platform", "seat", "head");
        }
    }

    /**
     * A torso and a head in series, vertical.
     *
     * @param torso mass [kg]
     * @param k1 seat-torso stiffness [N/m]
     * @param c1 its damping [N·s/m]
     * @param head  mass [kg]
     * @param k2 torso-head stiffness [N/m]
     * @param c2 its damping [N·s/m]
     * @param step change of stiffness
     */
    record TwoDof(double torso, double k1, double c1, double head, double k2, double c2, Optional<Step> step)
            implements Sitter {

        /** The series set ascribed to Allen (1978); assumed, for it was not checked against the original. */
        public static TwoDof allen(Optional<Step> step) {
            return new TwoDof(50.2, 74300, 2807, 5.5, 41000, 318, step);
        }

        public TwoDof {
            if (!(torso >= 0.01 && head >= 0.01 && torso <= 1e4 && head <= 1e4)) {
                throw new IllegalArgumentException("masses must be 0.01 to 10000 kg: " + torso + ", " + head);
            }
            if (!(k1 > 0 && k2 > 0 && k1 <= 1e9 && k2 <= 1e9)) {
                throw new IllegalArgumentException("stiffnesses must be > 0 to 1e9 N/m: " + k1 + ", " + k2);
            }
            if (!(c1 >= 0 && c2 >= 0 && c1 <= 1e7 && c2 <= 1e7)) {
                throw new IllegalArgumentException("dampings must be 0 to 1e7 N·s/m: " + c1 + ", " + c2);
            }
        }

        @Override
        public List<String> places() {
            return List.of("platform", "seat", "sternum", "head");
        }
    }

    /**
     * A whole person.
     *
     * @param subject who
     */
    record Person(Subject subject) implements Sitter {

        @Override
        public List<String> places() {
            return new Anatomy(subject.stature()).mounts().stream().map(Anatomy.Mount::name).toList();
        }
    }
}
