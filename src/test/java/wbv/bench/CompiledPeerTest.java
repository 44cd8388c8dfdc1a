package wbv.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.filter.BodyEstimate;
import wbv.filter.Estimator;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.model.Spec;
import wbv.learn.AdwinAlarm;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.rig.RigSpec;

/** That the C loop is the same arithmetic: written apart from the Java, it comes to the same numbers. */
class CompiledPeerTest {

    @Test
    void theCLoopFindsTheSameBody(@TempDir Path folder) throws Exception {
        Recording recording = RigSpec.oneDof(0.35, 5, 1, 60, 1).recording();
        double[] u = recording.values(Channel.parse("platform.acc.z"));
        double[] y = recording.values(Channel.parse("head.acc.z"));
        Optional<CompiledPeer> peer = CompiledPeer.in(folder, u, y);
        assumeTrue(peer.isPresent(), "no C compiler");
        same(peer.get().run("ekf", 1, 0), track(Method.EKF, u, y), 1e-9);
        // what adapts the noise is not in the loop: the same body within what is not known of it
        same(peer.get().run("ukf", 1, 0), track(Method.UNSCENTED, u, y), 0.005);
        same(peer.get().run("particle", 1, 500), track(Method.PARTICLE, u, y), 0.01);
    }

    private static BodyEstimate track(Method method, double[] u, double[] y) {
        Estimator estimator = EstimatorDesign.of(method).withParticles(500).estimator(Spec.at(60), () -> new AdwinAlarm(0.002));
        for (int i = 0; i < u.length; i++) {
            estimator.step(u[i], y[i]);
        }
        return estimator.track();
    }

    private static void same(CompiledPeer.Said said, BodyEstimate track, double tolerance) {
        assertEquals(1, said.frequency() / track.frequency(), tolerance);
        assertEquals(1, said.damping() / track.damping(), tolerance);
    }
}
