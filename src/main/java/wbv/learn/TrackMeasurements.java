package wbv.learn;

import java.util.Locale;
import moa.core.Measurement;
import wbv.filter.BodyEstimate;
import wbv.filter.ShareExplained;
import wbv.filter.model.Spec;

/** A {@link BodyEstimate} as a sentence and as MOA's measurements, under names that never change. */
public final class TrackMeasurements {

    private TrackMeasurements() {}

    /** Fourteen measurements, units in their names. */
    public static Measurement[] of(BodyEstimate track, ShareExplained explained) {
        return new Measurement[] {
            new Measurement("natural frequency [Hz]", track.frequency()),
            new Measurement("natural frequency sd [Hz]", track.frequencyDeviation()),
            new Measurement("damping ratio [1]", track.damping()),
            new Measurement("damping ratio sd [1]", track.dampingDeviation()),
            new Measurement("normalised innovation squared [1]", track.nis()),
            new Measurement("unexplained output sd [m/s2]", track.outputNoise()),
            new Measurement("alarm window [samples]", track.width()),
            new Measurement("cuts", track.cuts()),
            new Measurement("changes", track.changes()),
            new Measurement("divergences", track.divergences()),
            new Measurement("lost samples", explained.lost()),
            new Measurement("share explained [1]", explained.share()),
            new Measurement("gaps", track.gaps()),
            new Measurement("missing samples", track.missing()),
        };
    }

    static String sentence(BodyEstimate track, ShareExplained explained, Spec spec) {
        StringBuilder modes = new StringBuilder();
        for (int m = 0; m < track.modes(); m++) {
            modes.append(String.format(Locale.ROOT, "%snatural frequency %.3f ± %.3f Hz, damping ratio %.3f ± %.3f", m == 0 ? ""
                    : "; ",
                    track.frequency(m), track.frequencyDeviation(m), track.damping(m), track.dampingDeviation(m)));
        }
        return String.format(Locale.ROOT,
                "%s of freedom at %.4g Hz: %s (one standard deviation)%s; %.3g m/s² (or rad/s) of the output "
                        + "is not explained; the predictions explain %.1f %% of its variance, and nothing at %d samples; %d cuts, %d "
                        + "divergences, %d gaps.",
                track.modes() == 1 ? "One degree" : "Two degrees",
                spec.rate(),
                modes, track.settled() ? "" : ", not settled", track.outputNoise(), 100 * explained.share(),
                explained.lost(), track.cuts(), track.divergences(), track.gaps());
    }
}
