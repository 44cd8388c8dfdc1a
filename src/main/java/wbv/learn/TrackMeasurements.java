package wbv.learn;

import moa.core.Measurement;
import wbv.filter.Track;

/** A {@link Track} as MOA's measurements, under names that never change. */
public final class TrackMeasurements {

    private TrackMeasurements() { }

    public static Measurement[] of(Track track) {
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
            new Measurement("gaps", track.gaps()),
            new Measurement("missing samples", track.missing()),
        };
    }
}
