package wbv.control;

import wbv.filter.BodyEstimate;
import wbv.filter.Estimator;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.drift.Adwin;
import wbv.filter.model.Spec;
import wbv.recording.Unit;

/**
 * A sitter as streaming estimators find him: natural frequency and damping ratio between frame and trunk by {@link Estimator}, mass
 * by the mean force of the suspension's spring. Each number is the middle sitter's times a factor, and the factor is drawn towards 1
 * by how little is known: with σ of the estimate and σ₀ of sitters, {@code ln factor = ln(estimate/middle) σ₀² / (σ₀² + σ²)}.
 */
public final class FollowedSitter implements SitterSource {

    private static final double T = SeatController.STEP;
    /** Samples of the controller in one of the estimator. */
    private static final int SLOWER = 4;
    /** Time constant of the mean spring force [s]. */
    private static final double SLOW = 1.5;
    /** Friction that may bias the mean force [N], and what a one-mode body is off by, as a share. */
    private static final double FRICTION = 20;
    private static final double MODEL_ERROR = 0.05;
    /** Nobody is farther from the middle than this factor. */
    private static final double FARTHEST = 2;

    private final SeatHardware hardware;
    private final SitterPrior prior;
    private final Estimator estimator;
    private double frameSum;
    private double trunkSum;
    private int frames;
    private int trunks;
    private int count;
    private double weight;
    private double heard;
    private double mass = 1;
    private double frequency = 1;
    private double damping = 1;

    /** Nobody has been followed yet: the prior is believed. */
    public FollowedSitter(SeatHardware hardware, SitterPrior prior) {
        this.hardware = hardware;
        this.prior = prior;
        this.estimator = EstimatorDesign.of(Method.EKF_ADWIN).estimator(Spec.at(SeatController.RATE / SLOWER), Adwin::new);
    }

    @Override
    public void hear(SeatReadings readings) {
        weigh(readings.spring());
        if (Double.isFinite(readings.frame())) {
            frameSum += readings.frame();
            frames++;
        }
        if (Double.isFinite(readings.trunk())) {
            trunkSum += readings.trunk();
            trunks++;
        }
        if (++count == SLOWER) {
            BodyEstimate track = estimator.step(frames == 0 ? Double.NaN : frameSum / frames, trunks == 0 ? Double.NaN : trunkSum / trunks);
            frameSum = 0;
            trunkSum = 0;
            frames = 0;
            trunks = 0;
            count = 0;
            if (track.found()) {
                frequency = factor(track.frequency() / prior.frequency(), track.frequencyDeviation() / track.frequency(),
                        prior.frequencies());
                damping = factor(track.damping() / prior.damping(), track.dampingDeviation() / track.damping(), prior.dampings());
            }
        }
    }

    /** A running mean, corrected for its beginning. A lost reading changes nothing. */
    private void weigh(double spring) {
        if (!Double.isFinite(spring)) {
            return;
        }
        double forget = T / SLOW;
        weight += forget * (1 - weight);
        heard += forget * (spring - heard);
        double sitter = heard / weight / Unit.STANDARD_GRAVITY - hardware.frameMass();
        if (sitter > 0) {
            // Until two time constants have passed, the motion itself moves the mean.
            double deviation = FRICTION / Unit.STANDARD_GRAVITY / sitter + (1 - weight);
            mass = factor(sitter / prior.middle().mass(), deviation, prior.masses());
        }
    }

    private static double factor(double ratio, double deviation, double among) {
        double variance = deviation * deviation + MODEL_ERROR * MODEL_ERROR;
        double believed = Math.log(ratio) * among * among / (among * among + variance);
        double factor = Math.exp(believed);
        return factor >= 1 / FARTHEST ? Math.min(factor, FARTHEST) : 1 / FARTHEST;
    }

    /** What the estimator of the body says. The same object always. */
    public BodyEstimate track() {
        return estimator.track();
    }

    @Override
    public double rigid() {
        return mass * prior.middle().rigid();
    }

    @Override
    public double moving() {
        return mass * prior.middle().moving();
    }

    @Override
    public double frequency() {
        return frequency * prior.middle().frequency();
    }

    @Override
    public double damping() {
        return damping * prior.middle().damping();
    }
}
