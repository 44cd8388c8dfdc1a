package wbv.network;

/**
 * A stretch of motion of one body, with what is true of it. Arrays are not copied: treat them as read-only.
 *
 * @param motion channel by channel, {@value Imaging#SAMPLES} samples each [m/s²]
 * @param truth  damping ratio and natural pulsation [rad/s] of each mode, slowest first, two numbers for each
 * @param rig    the experiment, by which it can be made again
 */
public record LabelledMotion(double[][] motion, double[] truth, String rig) {}
