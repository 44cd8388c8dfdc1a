package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import wbv.signal.FrequencyResponse.Excited;

/** Apparent mass, impedance and absorbed power of a body of four masses whose equations are solved here. */
class DrivingPointTest {

    private static final double RATE = 120;
    private static final int LENGTH = 1 << 16;
    private static final double RIGID = 7;

    private static double[][] record(Random random, double noise) {
        double[] a = KnownBodies.spectrum(LENGTH, RATE, 0.4, 50, random);
        double[] force = new double[LENGTH];
        KnownBodies.pass(a, KnownBodies.apparentMass(KnownBodies.BOILEAU, RIGID), RATE, force);
        return new double[][] {KnownBodies.record(a, 0, random), KnownBodies.record(force, noise, random)};
    }

    @Test
    void apparentMassIsThatOfTheBody() {
        double[][] record = record(new Random(21), 20);
        SpectralMatrix spectra = KnownBodies.spectra(RATE, 2048, record);
        ResponseMatrix h = ResponseMatrix.of(spectra, 1, Excited.USUAL);
        ApparentMass mass = new ApparentMass(h.frequency(), h.h1(0, 0));
        ApparentMass bare = mass.without(RIGID);
        ComplexSeries impedance = mass.impedance();
        for (int k = 12; h.frequency()[k] < 45; k++) {
            double f = h.frequency()[k];
            double[] truth = KnownBodies.apparentMass(KnownBodies.BOILEAU, RIGID).at(f);
            double sd = h.deviation(0, 0)[k];
            double bias = 0.001 * Math.hypot(truth[0], truth[1]);
            assertEquals(truth[0], mass.mass().re()[k], 5 * sd + bias, f + " Hz");
            assertEquals(truth[1], mass.mass().im()[k], 5 * sd + bias, f + " Hz");
            assertEquals(truth[0] - RIGID, bare.mass().re()[k], 5 * sd + bias);
            assertEquals(-2 * Math.PI * f * mass.mass().im()[k], impedance.re()[k], 1e-9 * impedance.magnitude(k));
            assertEquals(2 * Math.PI * f * mass.mass().magnitude(k), impedance.magnitude(k), 1e-9 * impedance.magnitude(k));
        }
        // The body weighs 55.2 kg (Boileau and Rakheja); at 0.5 Hz it moves as one with the seat but for 1 %.
        double sitting = mass.sitting(h.usable(0, 0)).orElseThrow();
        assertEquals(55.2 + RIGID, sitting, 0.02 * (55.2 + RIGID));
        assertEquals(mass.mass().magnitude(80) / sitting, mass.normalised(sitting)[80], 1e-12);
    }

    /**
     * What goes in at the driving point is what the dashpots turn into heat: Σ c |Δv|², summed here over the lines of the record.
     * Force times velocity, averaged over the samples, is the same again.
     */
    @Test
    void thePowerBalanceCloses() {
        Random random = new Random(22);
        double[] a = KnownBodies.spectrum(LENGTH, RATE, 0.8, 50, random);
        double[] force = new double[LENGTH];
        KnownBodies.pass(a, KnownBodies.apparentMass(KnownBodies.BOILEAU, RIGID), RATE, force);
        double[] velocity = new double[LENGTH];
        KnownBodies.pass(a, f -> new double[] {0, -1 / (2 * Math.PI * f)}, RATE, velocity);
        double heat = 0;
        for (int k = 1; k < LENGTH / 2; k++) {
            double square = a[2 * k] * a[2 * k] + a[2 * k + 1] * a[2 * k + 1];
            if (square > 0) {
                double w = 2 * Math.PI * k * RATE / LENGTH;
                double[][] moved = KnownBodies.motions(KnownBodies.BOILEAU, w / (2 * Math.PI));
                for (int i = 0; i < moved.length; i++) {
                    double re = moved[i][0] - (i == 0 ? 1 : moved[i - 1][0]);
                    double im = moved[i][1] - (i == 0 ? 0 : moved[i - 1][1]);
                    heat += KnownBodies.BOILEAU[i][2] * (re * re + im * im) * square / (w * w) * 2 / LENGTH / LENGTH;
                }
            }
        }
        double[] f = KnownBodies.record(force, 0, random);
        double[] v = KnownBodies.record(velocity, 0, random);
        double mean = 0;
        for (int n = 0; n < LENGTH; n++) {
            mean += f[n] * v[n] / LENGTH;
        }
        assertEquals(heat, mean, 1e-9 * heat);
        SpectralMatrix spectra = KnownBodies.spectra(RATE, 2048, KnownBodies.record(a, 0, random), f);
        AbsorbedPower power = AbsorbedPower.of(spectra, 1, 0);
        assertEquals(heat, power.total(), 0.01 * heat);
        assertEquals(power.total(), power.between(0, 10) + power.between(10 + 1e-9, 60), 1e-9 * heat);
        assertEquals(power.total(), power.cumulative()[1024], 1e-9 * heat);
        // A force that the body puts on what moves it takes the power out again, and the sign says so.
        double[] against = java.util.Arrays.stream(f).map(value -> -value).toArray();
        assertEquals(-power.total(), AbsorbedPower.of(KnownBodies.spectra(RATE, 2048, KnownBodies.record(a, 0, random), against),
                1, 0)
                .total(), 1e-9 * heat);
    }

    @Test
    void aRigidMassAbsorbsNothing() {
        Random random = new Random(23);
        double[] a = KnownBodies.record(KnownBodies.spectrum(LENGTH, RATE, 0.8, 50, random), 0, random);
        double[] force = java.util.Arrays.stream(a).map(value -> 10 * value).toArray();
        assertEquals(0, AbsorbedPower.of(KnownBodies.spectra(RATE, 2048, a, force), 1, 0).total(), 1e-9);
    }

    /** People with the same damping and resonances from 4 to 6 Hz: the plain mean of the curves is lower and broader than all. */
    @Test
    void theMeanOfPeopleKeepsTheirResonance() {
        double[] frequency = new Segmentation(60, 1024, 0.5).frequencies();
        boolean[] usable = new boolean[frequency.length];
        for (int k = 0; k < usable.length; k++) {
            usable[k] = frequency[k] > 0.3 && frequency[k] < 20;
        }
        List<SubjectMean.Curve> people = new ArrayList<>();
        double[] natural = {4, 4.5, 5, 5.5, 6};
        for (double f0 : natural) {
            double[] curve = new double[frequency.length];
            for (int k = 0; k < curve.length; k++) {
                double[] h = KnownBodies.oneDegree(f0, 0.2).at(frequency[k]);
                curve[k] = Math.hypot(h[0], h[1]);
            }
            people.add(new SubjectMean.Curve(frequency, curve, usable));
        }
        SubjectMean mean = SubjectMean.of(people).orElseThrow();
        // ζ = 0.2: the peak is 2.7339 high and stands at 0.9647 of the natural frequency (closed form).
        assertEquals(5, mean.people());
        assertEquals(2.7339, mean.peak().height(), 0.002);
        assertEquals(0, mean.peakDeviation().height(), 0.005);
        assertEquals(0.9647 * 5, mean.peak().frequency(), 0.01);
        assertEquals(0.9647 * Math.sqrt(0.625), mean.peakDeviation().frequency(), 0.01);
        Peak stretched = Peak.of(frequency, mean.mean(), finite(mean.mean())).orElseThrow();
        Peak plain = Peak.of(frequency, mean.plain(), finite(mean.plain())).orElseThrow();
        assertEquals(2.7339, stretched.height(), 0.01);
        assertEquals(0.9647 * 5, stretched.frequency(), 0.03);
        assertTrue(plain.height() < 2.4, "the plain mean loses the peak: " + plain.height());
        assertTrue(SubjectMean.of(people.subList(0, 1)).isEmpty());
    }

    private static boolean[] finite(double[] values) {
        boolean[] all = new boolean[values.length];
        for (int k = 0; k < all.length; k++) {
            all[k] = Double.isFinite(values[k]);
        }
        return all;
    }
}
