package wbv.diagnosis.surrogate;

import java.util.List;
import wbv.body.Model;

/**
 * Equations of motion of a {@link PlaneNet} with n motions: M a + C v + K x = 0, a = ẍ + T b with the base's accelerations b; the
 * accelerations that sensors feel are R a. Arrays are not copied.
 *
 * @param mass      M, which is diagonal: n masses [kg] and inertias [kg m²]
 * @param damping   C, n by n
 * @param stiffness K, n by n
 * @param carried   T, n by 3
 * @param read      R, sensors by n, three sensors a measured part
 */
record PlaneMatrices(double[] mass, double[][] damping, double[][] stiffness, double[][] carried, double[][] read) {

    PlaneMatrices {
        int n = mass.length;
        if (damping.length != n || stiffness.length != n || carried.length != n) {
            throw new IllegalArgumentException("matrices of a net must have as many rows as it has motions: " + n);
        }
    }

    /** With a net's numbers where they are. */
    static PlaneMatrices of(PlaneNet net) {
        int n = net.motions();
        List<PlaneNet.Part> parts = net.parts();
        int measured = (int) parts.stream().filter(PlaneNet.Part::measured).count();
        PlaneMatrices out = new PlaneMatrices(new double[n], new double[n][n], new double[n][n], new double[n][PlaneNet.MOTIONS],
                new double[PlaneNet.MOTIONS * measured][n]);
        for (int i = 0; i < parts.size(); i++) {
            out.add(parts.get(i), net.first(i), PlaneNet.MOTIONS * i);
        }
        for (PlaneNet.Joint joint : net.joints()) {
            for (int motion = 0; motion < joint.motions(); motion++) {
                double[] stretch = stretch(net, joint, motion);
                add(out.stiffness, stretch, joint.stiffness(motion));
                add(out.damping, stretch, joint.damping(motion));
            }
        }
        return out;
    }

    /**
     * Adds a body.
     *
     * @param at     its first motion
     * @param sensor its first reading, where it has any
     */
    private void add(PlaneNet.Part part, int at, int sensor) {
        mass[at] = part.mass();
        mass[at + 1] = part.mass();
        carried[at] = new double[] {1, 0, part.z()};
        carried[at + 1] = new double[] {0, 1, -part.x()};
        if (part.measured()) {
            mass[at + 2] = part.inertia();
            carried[at + 2][2] = 1;
            read[sensor][at] = 1;
            read[sensor][at + 2] = part.sensors().z() - part.z();
            read[sensor + 1][at + 1] = 1;
            read[sensor + 1][at + 2] = part.x() - part.sensors().x();
            read[sensor + 2][at + 2] = 1;
        }
    }

    private static void add(double[][] matrix, double[] row, double factor) {
        for (int i = 0; i < row.length; i++) {
            for (int j = 0; row[i] != 0 && j < row.length; j++) {
                matrix[i][j] += factor * row[i] * row[j];
            }
        }
    }

    /** What each motion stretches a joint by. */
    private static double[] stretch(PlaneNet net, PlaneNet.Joint joint, int motion) {
        double[] out = new double[net.motions()];
        Model.Point point = net.point(joint);
        for (int end = 0; end < 2; end++) {
            int body = end == 0 ? joint.upper() : joint.lower();
            if (body >= 0) {
                PlaneNet.Part part = net.parts().get(body);
                double sign = end == 0 ? 1 : -1;
                out[net.first(body) + motion] += sign;
                if (part.measured() && motion < 2) {
                    out[net.first(body) + 2] += sign * (motion == 0 ? point.z() - part.z() : part.x() - point.x());
                }
            }
        }
        return out;
    }
}
