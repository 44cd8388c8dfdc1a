package wbv.diagnosis.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.LawAt;
import wbv.body.Model;
import wbv.body.law.CubicSpring;
import wbv.body.law.Law;
import wbv.body.law.ScheduledFriction;
import wbv.body.law.ScheduledLink;
import wbv.body.law.StepChange;
import wbv.body.number.Modulator;
import wbv.body.number.Numbers;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.FittedScene;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.SpectralLines;
import wbv.diagnosis.learn.LatentEstimator;
import wbv.diagnosis.learn.LatentForce;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Library;
import wbv.diagnosis.mechanism.Start;
import wbv.diagnosis.search.Trial;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;

/**
 * Pictures of simulated records whose missing physics is known: a seat and a torso on a platform, the link between them not
 * linear.
 */
class PicturesTest {

    private static final double RATE = 60;
    private static final int SAMPLES = 2400;
    private static final double NOISE = 0.01;
    private static final double CUBIC = 1.5e10;
    private static final int LINK = 1;

    private static final Channel BASE = Channel.parse("platform.acc.z");
    private static final Channel SEAT = Channel.parse("seat.acc.z");
    private static final Channel TORSO = Channel.parse("sternum.acc.z");
    private static final Model MODEL = new Model("chain", Optional.empty(), 'z', new Model.Base("platform", Optional.of(BASE)),
            List.of(body("seat", 15, SEAT), body("torso", 40, TORSO)),
            List.of(link("platform", "seat", 70e3, 900), link("seat", "torso", 45e3, 800)));

    private static Model.Body body(String name, double mass, Channel sensor) {
        return new Model.Body(name, mass, Optional.of(sensor), List.of(), Optional.empty(), List.of());
    }

    private static Model.Link link(String from, String to, double stiffness, double damping) {
        return new Model.Link(from, to, stiffness, damping, Optional.empty(), List.of(), List.of());
    }

    /** A record with a law in the link between seat and torso, and what the truth was. */
    private record Trial(Evidence evidence, Candidate candidate, double[] deflection, double[] force) {
        static Trial with(Law law, double noise) {
            return with(law, noise, List.of());
        }

        static Trial with(Law law, double noise, List<Assembly.DriveAt> drives) {
            return with(law, noise, drives, Map.of());
        }

        /** @param further channels that a law goes by */
        static Trial with(Law law, double noise, List<Assembly.DriveAt> drives, Map<Channel, double[]> further) {
            Random random = new Random(7);
            double[] base = banded(random, 2, 9, 0.5);
            Excitation excitation = new Excitation(RATE, base, further);
            Assembly linear = MODEL.assembly();
            Assembly truth = new Assembly(linear.structure(), List.of(new LawAt(LINK, law)), drives, linear.outputs());
            Simulator.Response response = new Simulator(excitation).run(truth, false);
            Map<Channel, double[]> channels = new LinkedHashMap<>();
            channels.put(BASE, noisy(base, noise, random));
            channels.put(SEAT, noisy(excitation.series(response.outputs()[0]), noise, random));
            channels.put(TORSO, noisy(excitation.series(response.outputs()[1]), noise, random));
            channels.putAll(further);
            for (String across : List.of("platform.acc.x", "platform.acc.y", "seat.acc.x", "seat.acc.y", "sternum.acc.x", "sternum.acc.y",
                    "platform.gyr.x", "platform.gyr.y", "seat.gyr.x", "seat.gyr.y", "sternum.gyr.x", "sternum.gyr.y")) {
                channels.put(Channel.parse(across), noisy(banded(random, 2, 9, across.contains("gyr") ? 0.02 : 0.1), noise, random));
            }
            Evidence evidence = new Evidence(MODEL, new Recording(new Clock(0, RATE), channels, Metadata.NONE));
            return new Trial(evidence, Baseline.of(evidence), excitation.series(response.stretch()[LINK]),
                    excitation.series(response.forces()[0]));
        }

        LatentForce latent() {
            return new LatentEstimator(evidence, candidate, bare(), false, LINK).force();
        }

        /** The user's model with its own values, which are the true ones: nothing is fitted, nothing is assumed of a law. */
        Fitter.State bare() {
            Fitter fitter = new Fitter(evidence);
            return fitter.look(candidate, candidate.start(), fitter.frame(candidate, candidate.start(), evidence.fit()));
        }
    }

    /** Gaussian noise between two frequencies, of a given root mean square, from sines on a grid that does not repeat. */
    private static double[] banded(Random random, double low, double high, double rms) {
        double[] out = new double[SAMPLES];
        int sines = 300;
        for (int s = 0; s < sines; s++) {
            double f = low + (high - low) * random.nextDouble();
            double phase = 2 * Math.PI * random.nextDouble();
            for (int i = 0; i < SAMPLES; i++) {
                out[i] += rms * Math.sqrt(2.0 / sines) * Math.sin(2 * Math.PI * f * i / RATE + phase);
            }
        }
        return out;
    }

    private static double[] noisy(double[] x, double noise, Random random) {
        return Arrays.stream(x).map(value -> value + noise * random.nextGaussian()).toArray();
    }

    private static double rms(double[] x, double[] y, LatentForce known) {
        return Math.sqrt(IntStream.range(0, x.length).filter(known::known).mapToDouble(i -> Math.pow(x[i] - y[i], 2)).average()
                .orElseThrow());
    }

    /** The same band as the latent force has. */
    private static double[] inBand(Trial trial, double[] series) {
        double[] omega = trial.evidence().whole().omega();
        double[] spectrum = trial.evidence().whole().spectrum(series);
        double top = trial.evidence().fit().frequency(trial.evidence().fit().lines() - 1);
        for (int i = 0; i < spectrum.length; i++) {
            double f = omega[i / 2] / (2 * Math.PI);
            double u = Math.pow(f, 8);
            spectrum[i] *= u / (1 + u) * Math.max(0, Math.min(1, (top - f) / (0.1 * top)));
        }
        return trial.evidence().whole().series(spectrum);
    }

    @Test
    void latentForceOfACubicSpringIsItsCubeWithinTheNoiseItStates() {
        Trial trial = Trial.with(new CubicSpring(CUBIC), NOISE);
        LatentForce latent = trial.latent();
        double[] cube = inBand(trial, Arrays.stream(trial.deflection()).map(r -> CUBIC * r * r * r).toArray());
        double error = rms(latent.force(), cube, latent);
        double size = rms(cube, new double[SAMPLES], latent);
        assertTrue(size > 3 * latent.pointNoise(), "the force must stand out: " + size + " of " + latent.pointNoise() + " N");
        assertEquals(NOISE / trial.evidence().measured().inputNoise(), error / latent.pointNoise(), 0.1, "error over what is stated");
        assertTrue(rms(latent.displacement(), trial.deflection(), latent) < 2 * latent.pointNoise() / 45e3,
                "as well as the force is known");
    }

    @Test
    void withoutNoiseOnlyTheEndsOfTheBandAreLost() {
        Trial trial = Trial.with(new CubicSpring(CUBIC), 1e-5);
        LatentForce latent = trial.latent();
        double[] cube = inBand(trial, Arrays.stream(trial.deflection()).map(r -> CUBIC * r * r * r).toArray());
        assertTrue(rms(latent.force(), cube, latent) < 0.01 * rms(cube, new double[SAMPLES], latent));
    }

    @Test
    void nothingIsLatentWhereNothingIsMissing() {
        Trial trial = Trial.with(new CubicSpring(0), NOISE);
        LatentForce latent = trial.latent();
        assertEquals(NOISE / trial.evidence().measured().inputNoise(), rms(latent.force(), new double[SAMPLES],
                latent) / latent.pointNoise(), 0.1);
    }

    @Test
    void portraitOfANamedCubicSpringHoldsTheCurveAndItsMeansLieOnIt() {
        Trial trial = Trial.with(new CubicSpring(CUBIC), NOISE);
        Fitter.State base = trial.bare();
        Pictures pictures = pictures(trial, base, with(trial, new CubicSpring(CUBIC), CUBIC), List.of());
        assertTrue(pictures.completed());
        Portrait portrait = pictures.portraits().get(0);
        assertEquals("Latent force in seat-torso over deflection", portrait.title());
        Portrait.Trail law = trail(portrait, Portrait.Kind.LAW);
        for (int i = 0; i < law.x().length; i++) {
            assertEquals(CUBIC * Math.pow(law.x()[i] / 1e3, 3), law.y()[i], 1e-9);
        }
        Portrait.Trail mean = trail(portrait, Portrait.Kind.MEAN);
        int off = 0;
        for (int i = 0; i < mean.x().length; i++) {
            // Half a newton for what lies below 1 Hz and above the band.
            off += Math.abs(mean.y()[i] - CUBIC * Math.pow(mean.x()[i] / 1e3, 3)) > 3 * mean.deviation()[i] + 0.5 ? 1 : 0;
        }
        assertTrue(off <= mean.x().length / 8, off + " of " + mean.x().length + " means lie off the curve");
    }

    @Test
    void stiffnessOverTimeShowsAStepWhereAndHowLargeItWas() {
        Trial trial = Trial.with(new StepChange(20, 0.6, 0.6), NOISE);
        Pictures pictures = pictures(trial, trial.bare(), trial.bare(),
                List.of(new Diagnosis.Latent("link", "seat-torso", 1)));
        Portrait portrait = pictures.portraits().stream().filter(p -> p.title().startsWith("Stiffness")).findFirst()
                .orElseThrow();
        Portrait.Trail blocks = portrait.trails().get(0);
        int compared = 0;
        for (int b = 0; b < blocks.x().length; b++) {
            boolean whole = !Double.isNaN(blocks.y()[b]) && Math.abs(blocks.x()[b] - 20) > 2.1;
            if (whole) {
                double expected = blocks.x()[b] < 20 ? 45 : 27;
                assertEquals(expected, blocks.y()[b], 4 * blocks.deviation()[b] + 0.02 * expected, "at " + blocks.x()[b] + " s");
                compared++;
            }
        }
        assertTrue(compared >= 7, "blocks compared: " + compared);
    }

    /** A spring that goes by where a roller stands, from 15 % less to 25 % more, and friction that does. */
    @Test
    void whatGoesByAChannelIsDrawnOverIt() {
        Channel roller = Channel.parse("roller.pos.z");
        double[] place = IntStream.range(0, SAMPLES).mapToDouble(i -> 0.05 * Math.sin(0.03 * i / RATE * 2 * Math.PI + 1)).toArray();
        Modulator by = new Modulator.Level(roller, -0.05, 0.05);
        for (Law law : List.of(new ScheduledLink(ScheduledLink.Of.STIFFNESS, by, 0.2, 0.05, 0, 0),
                new ScheduledFriction(by, 20, 10, 0, 0, 0, 0.02))) {
            boolean spring = law instanceof ScheduledLink;
            Trial trial = Trial.with(law, NOISE, List.of(), Map.of(roller, place));
            double[] values = Numbers.values((Record) law);
            Hypothesis named = new Hypothesis(Library.standard().of(law.mechanism()).orElseThrow(), "seat-torso", "",
                    List.of(new Addition.InLink(LINK, law)),
                    Arrays.stream(values).mapToObj(any -> Hypothesis.Number.sum(1, -100, 100)).toList(),
                    List.of(Start.fixed(values)));
            Fitter.State chosen = state(trial, named, values);
            Portrait portrait = pictures(trial, trial.bare(), chosen, List.of()).portraits().get(0);
            assertEquals((spring ? "Stiffness change" : "Friction") + " in seat-torso over roller.pos.z", portrait.title());
            Portrait.Trail curve = trail(portrait, Portrait.Kind.LAW);
            Portrait.Trail levels = trail(portrait, Portrait.Kind.MEAN);
            assertEquals(-50, curve.x()[0], 1e-9);
            for (int i = 0; i < curve.x().length; i++) {
                double u = curve.x()[i] / 50;
                assertEquals(spring ? 100 * (0.2 * u + 0.05 * u * u) : 20 + 10 * u, curve.y()[i], 1e-9);
            }
            for (int b = 0; b < levels.x().length; b++) {
                double u = levels.x()[b] / 50;
                double expected = spring ? 100 * (0.2 * u + 0.05 * u * u) : 20 + 10 * u;
                assertEquals(expected, levels.y()[b], 4 * levels.deviation()[b] + 0.05 * Math.abs(expected), law + " at " + levels.x()[b]);
            }
        }
    }

    @Test
    void residualMapIsAtTheNoiseWhereNothingIsMissingAndFarAboveWhereSomethingIs() {
        Trial quiet = Trial.with(new CubicSpring(0), NOISE);
        double level = power(pictures(quiet, quiet.bare(), quiet.bare(), List.of()).views().get(1).map().after());
        assertEquals(Math.pow(NOISE / quiet.evidence().measured().inputNoise(), 2), level, 0.1);
        Trial loud = Trial.with(new CubicSpring(CUBIC), NOISE);
        assertTrue(power(pictures(loud, loud.bare(), loud.bare(), List.of()).views().get(1).map().after()) > 5);
    }

    /**
     * A tone of 12 N on the torso: the force that the recording asks for there has its amplitude at its frequency, and nothing
     * else.
     */
    @Test
    void forceOnABodyShowsAToneWithItsAmplitude() {
        Trial trial = Trial.with(new CubicSpring(0), NOISE, List.of(new Assembly.DriveAt(1, new Drive.Tone(12, 0, 6.3))));
        Portrait portrait = pictures(trial, trial.bare(), trial.bare(),
                List.of(new Diagnosis.Latent("body", "torso", 1)))
                .portraits().get(0);
        Portrait.Trail lines = trail(portrait, Portrait.Kind.MEASURED);
        int highest = IntStream.range(0, lines.y().length).reduce((a, b) -> lines.y()[a] > lines.y()[b] ? a : b).orElseThrow();
        assertEquals(6.3, lines.x()[highest], 0.01);
        assertEquals(12, lines.y()[highest], 0.3);
        double beside = IntStream.range(0, lines.y().length).filter(i -> Math.abs(lines.x()[i] - 6.3) > 0.2)
                .mapToDouble(i -> lines.y()[i])
                .max().orElseThrow();
        assertTrue(beside < 0.6, "greatest amplitude elsewhere: " + beside);
    }

    @Tag("slow")
    @Test
    void everyHypothesisOfTheBankHasAPortraitWithNumbersInIt() {
        Trial trial = Trial.with(new CubicSpring(CUBIC), NOISE);
        Fitter.State base = trial.bare();
        Assembly assembly = trial.candidate().at(base.x());
        List<Hypothesis> bank = Library.standard()
                .hypotheses(FittedScene.of(trial.evidence(), assembly, Motion.measured(trial.evidence(), assembly),
                        SpectralLines.of(base.residual(), trial.evidence().fit())));
        Set<String> mechanisms = new TreeSet<>();
        for (Hypothesis hypothesis : bank) {
            double[] start = hypothesis.starts().get(0).values();
            List<Portrait> portraits = pictures(trial, base, state(trial, hypothesis, start), List.of()).portraits();
            assertFalse(portraits.isEmpty(), hypothesis.name());
            for (Portrait portrait : portraits) {
                assertFalse(portrait.trails().isEmpty(), hypothesis.name());
                for (Portrait.Trail trail : portrait.trails()) {
                    assertTrue(trail.x().length > 0, hypothesis.name() + ": " + portrait.title() + ", " + trail.name());
                    assertTrue(Arrays.stream(trail.x()).allMatch(Double::isFinite), hypothesis.name() + ": " + portrait.title());
                    assertTrue(Arrays.stream(trail.y()).anyMatch(Double::isFinite), hypothesis.name() + ": " + portrait.title());
                }
            }
            mechanisms.add(hypothesis.mechanism());
        }
        assertTrue(mechanisms.size() >= 20, "mechanisms drawn: " + mechanisms);
    }

    @Test
    void tracesAndValuesAreThoseOfTheRecordAndTheModel() {
        Trial trial = Trial.with(new CubicSpring(CUBIC), NOISE);
        Pictures pictures = pictures(trial, trial.bare(), trial.bare(), List.of());
        assertEquals(List.of("seat.acc.z", "sternum.acc.z"), pictures.views().stream().map(Pictures.View::channel).toList());
        Pictures.Traces traces = pictures.views().get(1).heldOut();
        int first = trial.evidence().heldOut().start();
        assertEquals(first / RATE, traces.from());
        for (int i = 0; i < traces.measured().length; i++) {
            assertEquals(trial.evidence().measured(1)[first + i], traces.measured()[i]);
        }
        Pictures.Value stiffness = pictures.values().get(2);
        assertEquals("seat-torso", stiffness.where());
        assertEquals("stiffness_N_per_m", stiffness.key());
        assertEquals(45e3, stiffness.given(), 1e-9);
    }

    /**
     * Against Wilson and Hilferty's (1931) approximation of χ², another formula, good to a few units of the fourth digit here.
     */
    @Test
    void pValueIsTheUpperTailOfNoiseATenthStrongerThanEstimated() {
        Trial trial = Trial.with(new CubicSpring(0), NOISE);
        Pictures.View view = pictures(trial, trial.bare(), trial.bare(), List.of()).views().get(0);
        double spread = 2.0 / (9 * view.degrees());
        for (double times : new double[] {1, 1.08, 1.1, 1.12, 1.2}) {
            double z = (Math.cbrt(times / 1.1) - (1 - spread)) / Math.sqrt(spread);
            assertEquals(1 - new NormalDistribution().cumulativeProbability(z), view.pValue(times), 1e-4, "at " + times);
        }
        assertEquals(0, view.pValue(1000));
    }

    /** Mean power over that of the noise. */
    private static Pictures pictures(Trial trial, Fitter.State base, Fitter.State chosen, List<Diagnosis.Latent> latent) {
        return Pictures.of(trial.evidence(), trial.bare(), base, chosen, latent);
    }

    private static double power(double[][] decibels) {
        return Arrays.stream(decibels).flatMapToDouble(Arrays::stream).filter(Double::isFinite)
                .map(value -> Math.pow(10, value / 10)).average().orElseThrow();
    }

    private static Fitter.State with(Trial trial, Law law, double value) {
        Hypothesis hypothesis = new Hypothesis(Library.standard().of("stiffness.hardening").orElseThrow(), "seat-torso", "",
                List.of(new Addition.InLink(LINK, law)),
                List.of(Hypothesis.Number.sum(value, -10 * value, 10 * value).named("k3_N_per_m3")),
                List.of(Start.fixed(value)));
        return state(trial, hypothesis, new double[] {value});
    }

    private static Fitter.State state(Trial trial, Hypothesis hypothesis, double[] values) {
        Candidate with = trial.candidate().with(hypothesis);
        double[] x = trial.candidate().extended(trial.candidate().start(), with, hypothesis, values);
        Fitter fitter = new Fitter(trial.evidence());
        return fitter.look(with, x, fitter.frame(with, x, trial.evidence().fit()));
    }

    private static Portrait.Trail trail(Portrait portrait, Portrait.Kind kind) {
        return portrait.trails().stream().filter(trail -> trail.kind() == kind).findFirst().orElseThrow();
    }
}
