package wbv.recording;

/**
 * Which axes of a sensor point against those of ISO 2631-1, as the factors that bring its vectors right.
 *
 * @param x 1 or -1
 * @param y 1 or -1
 * @param z 1 or -1
 */
public record AxisSigns(int x, int y, int z) {

    public AxisSigns {
        if (Math.abs(x) != 1 || Math.abs(y) != 1 || Math.abs(z) != 1) {
            throw new IllegalArgumentException("an axis sign must be 1 or -1: " + x + " " + y + " " + z);
        }
    }

    /** The factor of an axis; 1 for a quaternion's real part. */
    public int of(char axis) {
        return axis == 'x' ? x : axis == 'y' ? y : axis == 'z' ? z : 1;
    }
}
