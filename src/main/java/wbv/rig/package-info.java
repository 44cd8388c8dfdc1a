/**
 * The virtual experiment: a motion platform with six axes shakes a seat, a sitter and ten inertial sensors, and what is true
 * is written down beside what the sensors say.
 *
 * <p>A {@link wbv.rig.RigSpec} is one line of words, such as {@code subject=2 regime=4 seconds=120 seed=7}, and everything
 * follows from it: the {@link wbv.rig.platform.Program} of the {@link wbv.rig.Hexapod}, the {@link wbv.rig.Sitter}, the errors of every
 * {@link wbv.rig.Imu}. {@link wbv.rig.RigRun} plays it sample by sample in memory that does not grow; the same line gives the
 * same bytes.
 *
 * <p>The sizes of things are the thesis' (J. L. Coyte, <em>Seated Whole Body Vibration Modelling using Inertial Motion
 * Sensors</em>, University of Wollongong, 2020) where it states them, and are called assumed where it does not. Every
 * transcendental function is {@link java.lang.StrictMath}'s, so that a recording does not depend on the machine that made it.
 */
package wbv.rig;
