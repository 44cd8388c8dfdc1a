package wbv.rig.concealed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.rig.concealed.law.Lugre;
import wbv.rig.platform.Seeds;

class PlanarPlantTest {

    private static final int SECOND = (int) UniformSeries.RATE;

    /** Bodies that nothing holds keep going straight, while the platform turns under them and is left behind. */
    @Test
    void whatNothingHoldsGoesStraightWhereverThePlatformTurns() {
        PlanarPerson loose = without(PlanarPerson.draw(new Seeds(1).source("sitter")), 0, 0);
        double turn = 1.7;
        double ahead = 0.9;
        int n = 2 * SECOND;
        double[] x = new double[n];
        double[] z = new double[n];
        double[] rate = new double[n];
        for (int s = 0; s < n; s++) {
            double angle = turn * s / UniformSeries.RATE;
            // An acceleration that always points the same way, in axes that turn.
            x[s] = ahead * Math.cos(angle);
            z[s] = ahead * Math.sin(angle);
            rate[s] = turn;
        }
        PlanarPlant plant = new PlanarPlant(new PlanarSetup(loose), PlanarPlant.COARSE);
        double[] start = plant.rest();
        start[9] = 0.4;
        start[10] = -0.2;
        start[11] = -turn;
        double[][] state = plant.run(new PlanarPlant.Base(x, z, rate, new double[n]), start).state();
        for (int s = 0; s < n; s += 240) {
            double t = s / UniformSeries.RATE;
            double px = state[0][s];
            double pz = state[1][s];
            // Seen from outside: z turns towards x.
            double outsideX = Math.cos(turn * t) * px + Math.sin(turn * t) * pz + ahead * t * t / 2;
            double outsideZ = Math.cos(turn * t) * pz - Math.sin(turn * t) * px;
            double[] at = loose.centre()[0];
            assertEquals(at[0] + (0.4 + turn * at[1]) * t, outsideX, 1e-6, "x at " + t);
            assertEquals(at[1] + (-0.2 - turn * at[0]) * t, outsideZ, 1e-6, "z at " + t);
            assertEquals(-turn * t, state[2][s], 1e-9);
        }
    }

    /** Large motion without damping: what moves and what is stretched add up to the same, always. */
    @Test
    void energyStays() {
        PlanarPerson springs = without(PlanarPerson.draw(new Seeds(2).source("sitter")), 1, 0);
        PlanarPlant plant = new PlanarPlant(new PlanarSetup(springs), PlanarPlant.FINE);
        double[] start = plant.rest();
        start[2] = 0.3;
        start[4] += 0.02;
        start[8] = -0.5;
        PlanarPlant.Trace trace = plant.run(still(3 * SECOND), start);
        double[] energy = new double[3 * SECOND];
        double swing = 0;
        for (int s = 0; s < energy.length; s++) {
            for (int i = 0; i < 3; i++) {
                energy[s] += springs.mass()[i] / 2 * (sq(trace.state()[9 + 3 * i][s]) + sq(trace.state()[10 + 3 * i][s]))
                        + springs.inertia()[i] / 2
                                * sq(trace.state()[11 + 3 * i][s]);
            }
            swing = Math.max(swing, energy[s]);
            for (int j = 0; j < springs.joints().size(); j++) {
                for (int q = 0; q < 3; q++) {
                    energy[s] += springs.joints().get(j).stiffness()[q] / 2 * sq(trace.extension()[j][q][s]);
                }
            }
        }
        assertTrue(swing > 0.3 * energy[0], "most of it must come and go");
        for (double e : energy) {
            assertEquals(energy[0], e, 1e-6 * energy[0]);
        }
    }

    /** Joints between bodies that touch nothing else: neither momentum changes, though forces act on arms that turn. */
    @Test
    void jointsMakeNoMomentum() {
        PlanarPerson whole = PlanarPerson.draw(new Seeds(3).source("sitter"));
        PlanarPerson floating = new PlanarPerson(whole.mass(), whole.inertia(), whole.centre(), whole.sensor(),
                whole.joints().stream().filter(joint -> joint.lower() >= 0).toList());
        PlanarPlant plant = new PlanarPlant(new PlanarSetup(floating), PlanarPlant.FINE);
        double[] start = plant.rest();
        start[5] = 0.4;
        start[9] = 1;
        start[17] = 3;
        double[][] state = plant.run(still(SECOND), start).state();
        double[] first = momenta(floating, state, 0);
        for (int s = 0; s < SECOND; s += 60) {
            double[] now = momenta(floating, state, s);
            for (int q = 0; q < 3; q++) {
                assertEquals(first[q], now[q], 1e-7 * Math.abs(first[0]), "of " + q + " at " + s);
            }
        }
    }

    private static double[] momenta(PlanarPerson person, double[][] state, int s) {
        double[] out = new double[3];
        for (int i = 0; i < 3; i++) {
            double px = person.mass()[i] * state[9 + 3 * i][s];
            double pz = person.mass()[i] * state[10 + 3 * i][s];
            out[0] += px;
            out[1] += pz;
            out[2] += state[3 * i + 1][s] * px - state[3 * i][s] * pz + person.inertia()[i] * state[11 + 3 * i][s];
        }
        return out;
    }

    /** One body on its cushion along z, shaken by a sine from rest on: the steady answer of a mass on a spring, from Laplace. */
    @ParameterizedTest
    @ValueSource(doubles = {2, 4.7, 9})
    void alongOneAxisItIsAMassOnASpring(double hertz) {
        double k = 60_000;
        double c = 900;
        double m = 50;
        PlanarPerson one = new PlanarPerson(new double[] {m, 1, 1}, new double[] {2, 1, 1}, new double[][] {{0, 0.2}, {0, 0.5}, {0, 0.8}},
                new double[][] {{0, 0.2}, {0, 0.5}, {0, 0.8}}, List.of(new PlanarPerson.Joint("cushion", -1, 0, new double[] {0, 0},
                        new double[] {1000, k, 100}, new double[] {10, c, 1})));
        double w = 2 * Math.PI * hertz;
        int n = 4 * SECOND;
        double[] z = new double[n];
        for (int s = 0; s < n; s++) {
            z[s] = Math.sin(w * s / UniformSeries.RATE);
        }
        double[] none = new double[n];
        double[] felt = new PlanarPlant(new PlanarSetup(one), PlanarPlant.FINE).run(new PlanarPlant.Base(none, z, none, none)).felt()[0][1];
        double real = k - m * w * w;
        double gain = Math.sqrt((k * k + c * c * w * w) / (real * real + c * c * w * w));
        double phase = Math.atan2(c * w, k) - Math.atan2(c * w, real);
        for (int s = 3 * SECOND; s < n - 3; s += 7) {
            assertEquals(gain * Math.sin(w * s / UniformSeries.RATE + phase), felt[s], 1e-5 * gain, "at " + s);
        }
    }

    /**
     * A law with sharp friction on a person who is shaken along all axes: half the step, the same motion to 0.1 % of it, a tenth of a
     * sensor's noise.
     */
    @Test
    void halfTheStepIsTheSameMotion() {
        PlanarPerson person = PlanarPerson.draw(new Seeds(4).source("sitter"));
        PlanarSetup setup = new PlanarSetup(person);
        PlanarPerson.Joint lumbar = person.joints().get(person.joint("lumbar"));
        double k = lumbar.stiffness()[PlanarPerson.Z];
        double c = lumbar.damping()[PlanarPerson.Z];
        setup.joint(person.joint("lumbar"), PlanarPerson.Z, h -> new Lugre(k, c, 30, 38, 0.005, 30 / 3e-5));
        int n = 4 * SECOND;
        PlanarPlant.Base base = PlanarPlant.Base.of(UniformSeries.lines(n, 0.5, 8, 0, 0.4, new Seeds(5).source("x")),
                UniformSeries.lines(n, 0.5, 10, 0, 1, new Seeds(5).source("z")),
                UniformSeries.rate(UniformSeries.lines(n, 0.5, 5, -1, 0.01, new Seeds(5).source("pitch"))));
        double[][][] usual = new PlanarPlant(setup, PlanarPlant.FINE).run(base).felt();
        double[][][] finer = new PlanarPlant(setup, 2 * PlanarPlant.FINE).run(base).felt();
        for (int i = 0; i < 3; i++) {
            for (int q = 0; q < 3; q++) {
                assertEquals(0, UniformSeries.rms(UniformSeries.less(usual[i][q], finer[i][q])), 1e-3 * UniformSeries.rms(finer[i][q]),
                        "body " + i + ", channel " + q);
            }
        }
    }

    private static PlanarPerson without(PlanarPerson person, double stiffness, double damping) {
        return new PlanarPerson(person.mass(), person.inertia(), person.centre(), person.sensor(),
                person.joints().stream()
                        .map(joint -> new PlanarPerson.Joint(joint.name(), joint.lower(), joint.upper(), joint.at(),
                                UniformSeries.scaled(joint.stiffness(), stiffness), UniformSeries.scaled(joint.damping(), damping)))
                        .toList());
    }

    private static PlanarPlant.Base still(int n) {
        return new PlanarPlant.Base(new double[n], new double[n], new double[n], new double[n]);
    }

    private static double sq(double x) {
        return x * x;
    }
}
