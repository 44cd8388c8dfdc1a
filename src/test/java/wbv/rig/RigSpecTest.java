package wbv.rig;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class RigSpecTest {

    @ParameterizedTest
    @ValueSource(strings = {
        "",
        "subject=2 regime=4 seconds=120 seed=7 rate=60 effects=softening,cross",
        "sitter=one-dof zeta=0.3 f0=4.5 step=1.25@60 excitation=random:z:0.5-12:1.5 seconds=90 noise=0",
        "sitter=two-dof excitation=idle@5+sine:pitch:3:0.01@10+sweep@20+random:1-8:0.5 seconds=60.5",
        "subject=4 excitation=sweep:x:1-9:0.1-2.5:30 rate=256 filter=linear gravity=included channels=platform,head effects=none",
        "channels=head.acc.z,platform.gyr.x effects=usual,-noise,loss seed=-12",
        "subject=3 excitation=ride:1@60+ride:7@60 seed=7",
        "subject=random:7 mass=91.5 posture=erect regime=0",
        "subject=random:-3 posture=slouched channels=all,seat.force.z,head.mag.x"})
    void printedSpecReadsBackAsItself(String text) {
        RigSpec spec = RigSpec.parse(text);
        assertEquals(spec, RigSpec.parse(spec.toString()));
        assertEquals(spec.toString(), RigSpec.parse(spec.toString()).toString());
    }

    @Test
    void briefFactoryIsTheParsedSpec() {
        assertEquals(RigSpec.oneDof(0.3, 4.5, 1.5, 90, 5).withStiffnessStep(1.25, 60),
                RigSpec.parse("sitter=one-dof zeta=0.3 f0=4.5 step=1.25@60 excitation=random:z:0.5-12:1.5 seconds=90 seed=5"));
        assertEquals(RigSpec.person(3, 8, 30, 2), RigSpec.parse("subject=3 regime=8 seconds=30 seed=2"));
    }

    @Test
    void aPersonWearsTenSensorsWithSixChannels() {
        assertEquals(10, new Sitter.Person(Subject.of(1)).places().size());
        assertEquals(60, RigSpec.parse("").channels().size());
        assertEquals(2, RigSpec.oneDof(0.3, 5, 1, 10, 1).channels().size());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "speed=3 | speed=3",
        "subject=5 | subject must be 1 to 4: '5'",
        "regime=9 | regime must be 0 to 8: '9'",
        "subject=random:x | random:SEED",
        "mass=20 | mass must be 30 to 200 kg: 20.0",
        "posture=lying | 'lying'",
        "seed=x | seed must be a whole number: 'x'",
        "seed=1 seed=2 | said twice in the rig spec: seed",
        "rate=1200 | rate must be > 0 to 1000 Hz: 1200.0",
        "excitation=shake | 'shake'",
        "excitation=random:8-5:1 | upper edge of the band must be > 8.0 Hz: 5.0",
        "excitation=idle@120+regime:1 seconds=120 | leave 0 s",
        "excitation=idle@20+regime:1@9 seconds=28 | leave 8 s",
        "excitation=idle+regime:1 | only the last",
        "zeta=0.3 | zeta means nothing with person",
        "sitter=one-dof zeta=-1 | damping ratio must be 0 to 2: -1.0",
        "sitter=one-dof step=1.25 | factor@seconds",
        "effects=tremor | 'tremor'",
        "channels=knee | 'knee'",
        "channels=knee.acc.z | knee.acc.z",
        "channels=head.force.z | head.force.z",
        "channels=head,head.acc.x | once only"})
    void wrongWordIsNamed(String text, String named) {
        String message = assertThrows(IllegalArgumentException.class, () -> RigSpec.parse(text)).getMessage();
        assertTrue(message.contains(named), message);
    }

    @Test
    void lengthCutsOrExtendsTheLastExcitation() {
        RigSpec spec = RigSpec.parse("excitation=idle@5+regime:2@20 seconds=25");
        assertEquals("idle@5+regime:2@35", spec.withSeconds(40).program().toString());
        assertEquals("idle@3", spec.withSeconds(3).program().toString());
    }

    @Test
    void fourSubjectsHaveTheMeanAndDeviationOfTheThesis() {
        double mean = Subject.ALL.stream().mapToDouble(Subject::mass).average().orElseThrow();
        double squares = Subject.ALL.stream().mapToDouble(s -> Math.pow(s.mass() - mean, 2)).sum();
        assertEquals(79.4, mean, 1e-12);
        assertEquals(7.1, Math.sqrt(squares / 3), 1e-12);
    }

    /** 400 people: standard errors of mean and deviation are 0.35 and 0.25 kg. */
    @Test
    void thePopulationHasThePublishedMeanAndDeviation() {
        double[] mass = LongStream.range(0, 400).mapToDouble(seed -> Subject.random(seed).mass()).toArray();
        double mean = Arrays.stream(mass).average().orElseThrow();
        assertEquals(79.4, mean, 1.2);
        assertEquals(7.1, Math.sqrt(Arrays.stream(mass).map(m -> (m - mean) * (m - mean)).sum() / 399), 0.9);
        double within = LongStream.range(0, 400).mapToDouble(seed -> 5 * Subject.random(seed).tautness())
                .filter(f -> f >= 4.5 && f <= 5.5).count() / 400.0;
        assertEquals(0.95, within, 0.04, "first resonances from 4.5 to 5.5 Hz");
        assertEquals(Subject.random(7), Subject.random(7));
        assertEquals("subject=random:7", Subject.random(7).toString());
    }

    @Test
    void postureMovesTheResonanceAsPublished() {
        double slouched = Subject.of(1).withPosture(Posture.SLOUCHED).tautnessAsHeSits();
        double erect = Subject.of(1).withPosture(Posture.ERECT).tautnessAsHeSits();
        assertEquals(5.2 / 4.4, erect / slouched, 1e-12);
    }

    @Test
    void thePlatformRestsForWhatTheSegmentsLeave() {
        assertEquals("regime:4@60+idle@60", RigSpec.parse("excitation=regime:4@60 seconds=120").program().toString());
        assertEquals(60, RigSpec.parse("excitation=regime:4@60").program().seconds());
        assertEquals(120, RigSpec.parse("excitation=idle@20+regime:4").program().seconds());
    }

    @Test
    void effectsOfAPersonMeanNothingToALinearSitter() {
        assertEquals("noise,bias,drift,tilt,resolution", RigSpec.oneDof(0.3, 5, 1, 10, 1).effects().toString());
    }

    @Test
    void stiffnessStepOfAPersonIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> RigSpec.person(1, 1, 10, 1).withStiffnessStep(1.25, 5));
        assertThrows(IllegalArgumentException.class, () -> new Sitter.OneDof(0.3, 5, Optional.of(new Sitter.Step(0, 5))));
    }
}
