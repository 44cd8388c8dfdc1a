package wbv.rig;

import java.util.Random;

/** Measured frequency response of a plant: many sines at once, at rest first, then projected on whole periods. */
final class Response {

    private static final double H = 0.001;

    private final double[] frequency;
    private final double[][][] gain;
    private final double[] force;

    /**
     * @param spacing of the lines [Hz]; 1 / spacing must be a whole number of steps @param first @param last line [Hz]
     * @param axis of the platform, 0 to 2 @param rms of the platform [m/s²] @param warm time before measuring [s]
     */
    Response(Sitter sitter, Effects effects, double spacing, double first, double last, int axis, double rms, double warm) {
        int lines = (int) Math.round((last - first) / spacing) + 1;
        int places = sitter.places().size();
        frequency = new double[lines];
        double[] phase = new double[lines];
        Random random = new Random(1);
        for (int i = 0; i < lines; i++) {
            frequency[i] = first + i * spacing;
            phase[i] = 2 * Math.PI * random.nextDouble();
        }
        Plant plant = Plant.of(sitter, effects, H, 0);
        PlaceMotion platform = new PlaceMotion();
        double[][][] re = new double[places][6][lines];
        double[][][] im = new double[places][6][lines];
        int before = (int) Math.round(warm / H);
        int period = (int) Math.round(1 / spacing / H);
        double amplitude = rms * Math.sqrt(2.0 / lines);
        double[] forceRe = new double[lines];
        double[] forceIm = new double[lines];
        double[] sine = new double[lines];
        double[] cosine = new double[lines];
        for (int k = 1; k <= before + period; k++) {
            double sum = 0;
            for (int i = 0; i < lines; i++) {
                double angle = 2 * Math.PI * frequency[i] * k * H + phase[i];
                sine[i] = Math.sin(angle);
                cosine[i] = Math.cos(angle);
                sum += amplitude * sine[i];
            }
            platform.acceleration[axis] = sum;
            plant.step(platform);
            for (int i = 0; i < lines && k > before; i++) {
                forceRe[i] += plant.seatForce()[2] * sine[i];
                forceIm[i] += plant.seatForce()[2] * cosine[i];
            }
            for (int p = 0; p < places && k > before; p++) {
                for (int a = 0; a < 6; a++) {
                    double y = a < 3 ? plant.motion(p).acceleration[a] : plant.motion(p).spin[a - 3];
                    for (int i = 0; i < lines; i++) {
                        re[p][a][i] += y * sine[i];
                        im[p][a][i] += y * cosine[i];
                    }
                }
            }
        }
        force = new double[lines];
        for (int i = 0; i < lines; i++) {
            force[i] = 2 * Math.hypot(forceRe[i], forceIm[i]) / period / amplitude;
        }
        gain = new double[places][6][lines];
        for (int p = 0; p < places; p++) {
            for (int a = 0; a < 6; a++) {
                for (int i = 0; i < lines; i++) {
                    gain[p][a][i] = 2 * Math.hypot(re[p][a][i], im[p][a][i]) / period / amplitude;
                }
            }
        }
    }

    /** Modulus at a place along an axis (3 to 5: angular acceleration), line by line. */
    double[] gain(int place, int axis) {
        return gain[place][axis];
    }

    /** Modulus at a place over that at another, along z, line by line. */
    double[] transmissibility(int from, int to) {
        return over(gain[to][2], gain[from][2]);
    }

    /** Vertical force under the sitter over the vertical acceleration of a place [kg]. */
    double[] apparentMass(int place) {
        return over(force, gain[place][2]);
    }

    /** The line where a curve is greatest. */
    static int peak(double[] curve) {
        int best = 0;
        for (int i = 1; i < curve.length; i++) {
            best = curve[i] > curve[best] ? i : best;
        }
        return best;
    }

    private static double[] over(double[] a, double[] b) {
        double[] ratio = new double[a.length];
        for (int i = 0; i < a.length; i++) {
            ratio[i] = a[i] / b[i];
        }
        return ratio;
    }

    double frequency(int line) {
        return frequency[line];
    }

    /** The line with the largest gain. */
    int peak(int place, int axis) {
        return peak(gain[place][axis]);
    }

    /** Number of interior local maxima. */
    int peaks(int place, int axis) {
        return peaks(gain[place][axis]);
    }

    static int peaks(double[] curve) {
        int count = 0;
        for (int i = 1; i + 1 < curve.length; i++) {
            count += curve[i] > curve[i - 1] && curve[i] >= curve[i + 1] ? 1 : 0;
        }
        return count;
    }
}
