package wbv.rig.concealed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.recording.Quantity;
import wbv.rig.concealed.law.Lugre;
import wbv.rig.platform.Seeds;

class BenchTest {

    private static Bench bench(double first, Chain chain, Quantity quantity, double seconds) {
        return new Bench(chain, 0, 'z', quantity, first, first, 12 * first, seconds, false, 10, 1e-3);
    }

    private static Chain one(double mass, double stiffness, double damping) {
        return new Chain(List.of("mass"), new int[] {-1}, new double[] {mass}, new double[] {stiffness}, new double[] {damping});
    }

    /** At 5 and at 1000 Hz, from rest: a force that sets in as 1 - cos moves a mass on a spring as Laplace says. */
    @ParameterizedTest
    @CsvSource({"5, 0.7", "1000, 0.7", "1000, 1.6"})
    void aForceMovesAMassAsItsClosedForm(double first, double ratio) {
        double m = 2;
        double wn = 2 * Math.PI * first;
        double zeta = 0.05;
        Bench bench = bench(first, one(m, m * wn * wn, 2 * zeta * m * wn), Quantity.POSITION, 30 / first);
        double w = ratio * wn;
        double fine = bench.acquisition().fine();
        double[] force = IntStream.range(0, (int) (30 / first * fine)).mapToDouble(i -> 10 * (1 - Math.cos(w * i / fine))).toArray();
        double[] moved = bench.felt(bench.run(bench.setup(force), force, true), 0, Quantity.POSITION);
        double wd = wn * Math.sqrt(1 - zeta * zeta);
        double real = wn * wn - w * w;
        double imaginary = 2 * zeta * wn * w;
        double a = real / (real * real + imaginary * imaginary);
        double b = imaginary / (real * real + imaginary * imaginary);
        double p = 1 / (wn * wn) - a;
        double q = (zeta * wn * p - w * b) / wd;
        for (int i = 0; i < moved.length; i += 101) {
            double t = i / fine;
            double free = Math.exp(-zeta * wn * t) * (p * Math.cos(wd * t) + q * Math.sin(wd * t));
            double exact = 10 / m * (1 / (wn * wn) - a * Math.cos(w * t) - b * Math.sin(w * t) - free);
            // A force that is straight between fine samples is off by a twelfth of the square of the angle between them.
            assertEquals(exact, moved[i], 3e-3 * 10 / m / (wn * wn), "at " + t + " s");
        }
    }

    /** A free mass with bristles of friction: what the force does is what moves, what bends and what slips. */
    @Test
    void workBecomesMotionAndHeat() {
        double first = 20;
        double m = 5;
        double c = 30;
        double friction = 20;
        Bench bench = bench(first, one(m, 0, c), Quantity.POSITION, 4);
        double[] drive = UniformSeries.scaled(bench.drive(1, new Seeds(1).source("force")), 5);
        Setup setup = bench.setup(drive);
        double bristle = friction / 2e-5;
        setup.link(0, h -> new Lugre(0, c, friction, 1.2 * friction, 0.01, bristle));
        ChainPlant.Trace trace = bench.run(setup, drive, true);
        double fine = bench.acquisition().fine();
        double[] v = trace.rate()[0];
        double[] dry = IntStream.range(0, v.length).mapToDouble(i -> trace.force()[0][i] - c * v[i]).toArray();
        double most = m / 2 * IntStream.range(0, v.length).mapToDouble(i -> v[i] * v[i]).max().orElse(0);
        double put = 0;
        double lost = 0;
        for (int i = 1; i < v.length; i++) {
            put += (drive[i] * v[i] + drive[i - 1] * v[i - 1]) / 2 / fine;
            lost += (trace.force()[0][i] * v[i] + trace.force()[0][i - 1] * v[i - 1]) / 2 / fine;
            assertEquals(put, m * v[i] * v[i] / 2 + lost, 1e-3 * Math.max(put, most), "at " + i);
        }
        assertTrue(lost > 0.5 * put, "friction must take most of it");
        double held = IntStream.range(0, v.length).mapToDouble(i -> Math.abs(dry[i])).max().orElse(0);
        assertTrue(held > friction && held < 1.2 * friction * 1.01, "friction of " + held + " N");
    }

    /** Half the step, the same motion to a tenth of the least noise, whatever the law's bristles. */
    @Test
    void halfTheStepIsTheSameMotion() {
        double first = 300;
        double wn = 2 * Math.PI * first;
        Bench bench = bench(first, one(1, wn * wn, 0.06 * wn), Quantity.ACCELERATION, 0.5);
        double[] drive = bench.drive(1, new Seeds(2).source("force"));
        ChainPlant.Trace calm = bench.run(bench.setup(drive), drive, true);
        double travel = UniformSeries.rms(calm.extension()[0]);
        Setup setup = bench.setup(drive);
        setup.link(0, h -> new Lugre(wn * wn, 0.06 * wn, 6, 8, 0.3 * UniformSeries.rms(calm.rate()[0]), 6 / (0.03 * travel)));
        double rate = bench.acquisition().fine();
        double[] usual = bench.acquisition().rows(new ChainPlant(setup, rate, 5).run(new double[drive.length], rate).acceleration()[0]);
        double[] finer = bench.acquisition().rows(new ChainPlant(setup, rate, 10).run(new double[drive.length], rate).acceleration()[0]);
        assertEquals(0, UniformSeries.rms(UniformSeries.less(usual, finer)), 2e-4 * UniformSeries.rms(finer));
    }

    /** A linear fit of a bench that a force moves takes up wrong values to the last, whatever its sensors measure. */
    @ParameterizedTest
    @CsvSource({"ACCELERATION", "VELOCITY", "POSITION"})
    void aLinearFitTakesUpWrongValues(Quantity quantity) {
        Chain chain = new Chain(List.of("mass", "load"), new int[] {-1, 0}, new double[] {3, 1}, new double[] {5e4, 2e4},
                new double[] {30, 12});
        double[] hertz = chain.frequencies();
        Bench bench = new Bench(chain, 1, 'x', quantity, hertz[0], hertz[1], 12 * hertz[1], 12, false, 10, 1e-3);
        double[] drive = bench.drive(1, new Seeds(3).source("force"));
        ChainPlant.Trace trace = bench.run(bench.setup(drive), drive, true);
        double[][] outputs = {bench.acquisition().rows(bench.felt(trace, 0, quantity)),
            bench.acquisition().rows(bench.felt(trace, 1, quantity))};
        for (double left : bench.fit(bench.acquisition().rows(drive), outputs).left(chain.stiffer(1.1))) {
            assertTrue(left < 1e-4, "left " + left);
        }
    }

    /** Benches are what the proof says of them. */
    @Test
    void drawnBenchesStayInTheirRange() {
        double least = 1e9;
        double most = 0;
        for (int seed = 0; seed < 300; seed++) {
            Bench bench = Bench.draw(Bench.Kind.ANY, seed % 2 == 0, new Seeds(seed).source("bench"));
            least = Math.min(least, bench.first());
            most = Math.max(most, bench.first());
            assertTrue(bench.seconds() >= 2 && bench.seconds() <= 60, bench.toString());
            assertTrue(bench.seconds() * bench.first() > 40, "periods of " + bench);
            assertTrue(bench.isFree() || Math.abs(bench.chain().frequencies()[0] / bench.first() - 1) < 1e-9, bench.toString());
            assertTrue(bench.high() < bench.rate() / 2 && bench.last() < bench.rate() / 5, bench.toString());
        }
        assertTrue(least < 7 && most > 500, least + " to " + most);
    }
}
