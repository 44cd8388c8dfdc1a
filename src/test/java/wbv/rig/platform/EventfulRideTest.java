package wbv.rig.platform;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import wbv.rig.RigRun;
import wbv.rig.RigSpec;

/** Rides on which things happen, and their truth. */
class EventfulRideTest {

    private static final String RIDE = "subject=2 excitation=ride:4 seconds=120 seed=3 channels=platform effects=none";

    @Tag("slow")
    @Test
    void whatHappensIsWhatThePlatformDoes() {
        RigRun run = RigSpec.parse(RIDE).run();
        double[] row = new double[7];
        double[] events = new double[4];
        int[] seen = new int[3];
        int jolts = 0;
        int since = 0;
        int before = -1;
        double joltPeak = 0;
        while (run.read(row)) {
            run.events(events);
            int episode = (int) events[0];
            since = episode == before ? since + 1 : 0;
            before = episode;
            seen[episode]++;
            double acceleration = Math.hypot(Math.hypot(row[1], row[2]), row[3]);
            double rate = Math.hypot(row[4], row[5]);
            if (episode == Episode.IDLE.ordinal() && since > 60) {
                assertTrue(acceleration < 0.02, "rest shakes: " + acceleration + " at " + row[0]);
            }
            if (events[1] > 0) {
                assertEquals(Episode.RIDING.ordinal(), episode, "jolts come on rides");
                jolts++;
                joltPeak = Math.max(joltPeak, Math.abs(row[3]));
            } else if (episode == Episode.RIDING.ordinal() && since > 60) {
                assertTrue(Math.abs(row[3]) < 2, "vibration alone, 0.3 m/s²: " + row[3] + " at " + row[0]);
                assertTrue(rate < 0.1, "no rocking: " + rate);
            }
        }
        for (int count : seen) {
            assertTrue(count > 200, "every kind of episode comes in two minutes: " + java.util.Arrays.toString(seen));
        }
        assertTrue(jolts > 300 && joltPeak > 3.5 && joltPeak < 10, jolts + ", " + joltPeak);
    }

    @Test
    void trueJerkIsTheSlopeOfWhatAnIdealSensorFeels() {
        // At the inner rate a row's interval is one step, so that the jerk is the difference of the accelerations themselves.
        RigRun run = RigSpec.parse("sitter=one-dof excitation=ride:1 seconds=6 seed=2 rate=1000 effects=none noise=0").run();
        int head = 1 + run.channels().indexOf(wbv.recording.Channel.parse("head.acc.z"));
        double[] row = new double[1 + run.channels().size()];
        double[] events = new double[4];
        double before = 0;
        double worst = 0;
        double most = 0;
        for (int i = 0; run.read(row); i++) {
            run.events(events);
            run.ideal(row);
            if (i > 0) {
                worst = Math.max(worst, Math.abs((row[head] - before) * 1000 - events[3]));
                most = Math.max(most, Math.abs(events[3]));
            }
            before = row[head];
        }
        assertTrue(most > 20 && worst < 0.05 * most, worst + " of " + most);
    }

    @Test
    void theSameSeedGivesTheSameEventsAndOtherProgramsHaveNone() {
        assertArrayEquals(events(RIDE), events(RIDE));
        assertEquals(List.of(), RigSpec.parse("regime=3 seconds=2").run().events());
        assertEquals("ride:4@120", RigSpec.parse(RIDE).program().toString());
    }

    private static double[] events(String text) {
        RigRun run = RigSpec.parse(text).withSeconds(20).run();
        double[] row = new double[7];
        double[] events = new double[4];
        double[] sums = new double[1200];
        for (int i = 0; run.read(row); i++) {
            run.events(events);
            sums[i] = events[0] + 10 * events[1] + events[2] + 1000 * events[3];
        }
        return sums;
    }
}
