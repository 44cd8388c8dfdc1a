package wbv.control;

import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * What the designs of a seat's controller start from: the seat's equations with an {@link ApparentSitter} on it, the floor as a
 * {@link FloorBand} and the weighting Wk, sampled; the cost of a sample,
 *
 * <pre>
 * (Wk a)² + price (d / 20 mm)² + (u / (carried mass · 2 m/s²))²
 * </pre>
 *
 * with a the frame's acceleration [m/s²], d the deflection and u the force asked for; and how much of all that is not known. The
 * force is priced by the acceleration that it gives to what is carried, so that the same wishes hold whoever sits there. Nothing is
 * allocated but by the constructor.
 *
 * <p>States: d, d', stretch e of the sitter's spring, e', force f of actuator or damper, two of the floor (the first is its
 * acceleration), two of the weighting. {@code (m + m₀) a = -k d - c d' + k₁ e + c₁ e' + f}.
 */
final class SeatModel {

    /** States. */
    static final int N = 9;
    /** Sensors: deflection, floor, frame. */
    static final int SENSORS = 3;

    /**
     * Wk by a filter of second order, {@code (b₁ s + b₀) / (s² + a₁ s + a₀)} (Zuo and Nayfeh 2003, as recalled; within 0.1 of the exact
     * weighting from 1 to 20 Hz, where seats are judged).
     */
    static final double[] WEIGHTING = {546.1, 86.51, 1892, 82.17};

    private static final double T = SeatController.STEP;
    /** What a state is of the order of: m, m/s, m, m/s, N, m/s², m/s², s², s times m/s². */
    private static final double[] UNIT = {0.02, 0.2, 0.005, 0.1, 100, 1, 1, 1e-3, 0.02};
    private static final double STROKE = 0.02;
    /** What a force may do to all that is carried [m/s²]; assumed. The stroke, whose price is tuned, is weighed against it. */
    private static final double ACCELERATION = 2;
    /** Of what the model does not hold, friction above all, on the frame and on the sitter [N²·s]. */
    private static final double FRAME_NOISE = 100;
    private static final double SITTER_NOISE = 100;
    /**
     * Of the sensors, with what the model lacks [m, m/s², m/s²]: cushion and limbs ring on the frame at 20 to 50 Hz, which the model does
     * not hold. With a tenth of the frame's, or forces five times as cheap, actuator and cushion sing together there.
     */
    static final double[] SENSOR_NOISE = {5e-4, 0.05, 2};
    private static final int TERMS = 10;

    private final SeatHardware hardware;
    private final FloorBand floor;
    private final double price;
    private final DMatrixRMaj continuous = new DMatrixRMaj(N + 1, N + 1);
    private final DMatrixRMaj exponential = new DMatrixRMaj(N + 1, N + 1);
    private final DMatrixRMaj term = new DMatrixRMaj(N + 1, N + 1);
    private final DMatrixRMaj next = new DMatrixRMaj(N + 1, N + 1);
    private final DMatrixRMaj a = new DMatrixRMaj(N, N);
    private final DMatrixRMaj b = new DMatrixRMaj(N, 1);
    private final DMatrixRMaj c = new DMatrixRMaj(SENSORS, N);
    private final DMatrixRMaj cost = new DMatrixRMaj(N, N);
    private final DMatrixRMaj noise = new DMatrixRMaj(N, N);
    private final DMatrixRMaj pull = new DMatrixRMaj(N, N);
    private final DMatrixRMaj sight = new DMatrixRMaj(N, N);
    private final double[] stretch = new double[N];
    private final double[] frame = new double[N];
    private double rigid;
    private double moving;
    private double frequency;
    private double ratio;
    private double force;

    /**
     * @param floor what it is supposed to do
     * @param price of 20 mm of stroke in (m/s²)² of weighted acceleration, &gt; 0
     */
    SeatModel(SeatHardware hardware, FloorBand floor, double price) {
        if (!(price > 0) || Double.isInfinite(price)) {
            throw new IllegalArgumentException("price of the stroke must be > 0: " + price);
        }
        this.hardware = hardware;
        this.floor = floor;
        this.price = price;
        price();
    }

    /** From now on the sitter whom the source tells now; {@link #damp} is to follow. */
    void seat(SitterSource sitter) {
        rigid = sitter.rigid();
        moving = sitter.moving();
        frequency = sitter.frequency();
        ratio = sitter.damping();
        force = ACCELERATION * (hardware.frameMass() + rigid + moving);
    }

    /**
     * All equations.
     *
     * @param damping that is always there, which u comes on top of [N·s/m]
     */
    void damp(double damping) {
        model(damping);
        sample();
        shake();
        look();
        CommonOps_DDRM.multTransB(b, b, pull);
        CommonOps_DDRM.scale(force * force, pull);
    }

    /** Of a sample, N by N. */
    DMatrixRMaj a() {
        return a;
    }

    /** What a force does in a sample [1/N], N by 1. */
    DMatrixRMaj b() {
        return b;
    }

    /** What the sensors see, {@value #SENSORS} by N. */
    DMatrixRMaj c() {
        return c;
    }

    /** Of the states of a sample [(m/s²)²]. */
    DMatrixRMaj cost() {
        return cost;
    }

    /** Variance of what shakes the states in a sample. */
    DMatrixRMaj noise() {
        return noise;
    }

    /** {@code b bᵀ} over the price of a force. */
    DMatrixRMaj pull() {
        return pull;
    }

    /** {@code cᵀ R⁻¹ c}, R the variances of the sensors. */
    DMatrixRMaj sight() {
        return sight;
    }

    /** The force that costs 1 (m/s²)² [N]. */
    double force() {
        return force;
    }

    /** The equations in continuous time, states in their units, the force asked for as a further state that stays. */
    private void model(double damping) {
        double w = 2 * Math.PI * frequency;
        double k1 = moving * w * w;
        double c1 = 2 * ratio * moving * w;
        double mass = hardware.frameMass() + rigid;
        Arrays.fill(frame, 0);
        Arrays.fill(stretch, 0);
        frame[0] = -hardware.stiffness() / mass;
        frame[1] = -damping / mass;
        frame[2] = k1 / mass;
        frame[3] = c1 / mass;
        frame[4] = 1 / mass;
        stretch[2] = -k1 / moving;
        stretch[3] = -c1 / moving;
        continuous.zero();
        put(0, 1, 1);
        put(2, 3, 1);
        for (int j = 0; j < N; j++) {
            put(1, j, frame[j]);
            put(3, j, stretch[j] - frame[j]);
            put(8, j, frame[j]);
        }
        put(1, 5, -1);
        double lag = hardware.lag() + hardware.delay() + T / 2; // a delay and a hold, as so much more lag
        put(4, 4, -1 / lag);
        continuous.set(4, N, 1 / lag / UNIT[4]);
        double wf = 2 * Math.PI * floor.frequency();
        put(5, 5, -2 * floor.damping() * wf);
        put(5, 6, -wf);
        put(6, 5, wf);
        put(7, 8, 1);
        continuous.add(8, 7, -WEIGHTING[2] * UNIT[7] / UNIT[8]);
        continuous.add(8, 8, -WEIGHTING[3]);
        c.zero();
        c.set(0, 0, UNIT[0]);
        c.set(1, 5, UNIT[5]);
        for (int j = 0; j < N; j++) {
            c.set(2, j, frame[j] * UNIT[j]);
        }
    }

    private void put(int i, int j, double value) {
        continuous.set(i, j, value * UNIT[j] / UNIT[i]);
    }

    /** A and B of a sample: the exponential of the continuous equations, by Taylor's series of a part of the sample, squared back. */
    private void sample() {
        int halvings = 0;
        double norm = CommonOps_DDRM.elementMaxAbs(continuous) * (N + 1) * T;
        while (norm > 0.5) {
            norm /= 2;
            halvings++;
        }
        CommonOps_DDRM.scale(T / (1L << halvings), continuous);
        CommonOps_DDRM.setIdentity(exponential);
        CommonOps_DDRM.setIdentity(term);
        for (int i = 1; i <= TERMS; i++) {
            CommonOps_DDRM.mult(1.0 / i, term, continuous, next);
            term.setTo(next);
            CommonOps_DDRM.addEquals(exponential, term);
        }
        for (int i = 0; i < halvings; i++) {
            CommonOps_DDRM.mult(exponential, exponential, next);
            exponential.setTo(next);
        }
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < N; j++) {
                a.set(i, j, exponential.get(i, j));
            }
            b.set(i, 0, exponential.get(i, N));
        }
    }

    private void price() {
        cost.zero();
        addSquare(cost, 7, 8, WEIGHTING[0] * UNIT[7], WEIGHTING[1] * UNIT[8]);
        cost.add(0, 0, price * UNIT[0] * UNIT[0] / (STROKE * STROKE));
        regularise(cost);
    }

    private void shake() {
        noise.zero();
        double wf = 2 * Math.PI * floor.frequency();
        noise.add(5, 5, T * 4 * floor.damping() * wf * floor.rms() * floor.rms() / (UNIT[5] * UNIT[5]));
        double push = Math.sqrt(T * FRAME_NOISE) * frame[4];
        addSquare(noise, 1, 3, push / UNIT[1], -push / UNIT[3]);
        noise.add(3, 3, T * SITTER_NOISE * frame[4] * frame[4] / (UNIT[3] * UNIT[3]));
        regularise(noise);
    }

    private void look() {
        sight.zero();
        for (int m = 0; m < SENSORS; m++) {
            for (int i = 0; i < N; i++) {
                for (int j = 0; j < N; j++) {
                    sight.add(i, j, c.get(m, i) * c.get(m, j) / (SENSOR_NOISE[m] * SENSOR_NOISE[m]));
                }
            }
        }
    }

    /** No direction is quite free, so that equations have one solution. */
    private static void regularise(DMatrixRMaj m) {
        for (int i = 0; i < N; i++) {
            m.add(i, i, 1e-9);
        }
    }

    private static void addSquare(DMatrixRMaj into, int i, int j, double first, double second) {
        into.add(i, i, first * first);
        into.add(j, j, second * second);
        into.add(i, j, first * second);
        into.add(j, i, first * second);
    }
}
