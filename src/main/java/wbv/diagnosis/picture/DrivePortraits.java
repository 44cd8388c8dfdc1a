package wbv.diagnosis.picture;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import wbv.body.Drive;
import wbv.body.simulate.Swing;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.learn.LatentForce;
import wbv.recording.Channel;

/** The latent force at a place over the motion that is said to drive it. */
final class DrivePortraits {

    private final Evidence evidence;
    private final LatentForce latent;
    private final String where;

    DrivePortraits(Evidence evidence, LatentForce latent, String where) {
        this.evidence = evidence;
        this.latent = latent;
        this.where = where;
    }

    /** What drives a link over the motion that is said to drive it: a line if it is so. */
    Portrait over(Drive drive, int link) {
        if (drive instanceof Drive.Rotation rotation) {
            double[] tilt = integrated(evidence.series(rotation.rate()), 1);
            String slope = String.format(Locale.ROOT, "lever arm %.3g mm", 1e3 * rotation.arm()).replace('-', '−');
            return new Portrait("Lift of " + where + " over the tilt of " + rotation.rate().location(),
                    Portrait.Scale.of("Tilt about " + rotation.rate().axis(), "mrad"),
                    Portrait.Scale.of("Lift that the recording asks for", "mm"),
                    line(tilt, 1e3, integrated(latent.lift(link), 0), 1e3, rotation.arm(), slope),
                    "Tilt from the measured rate, above 1 Hz. The slope is the lever arm.");
        }
        double across = drive instanceof Drive.Swings swings ? swings.stiffness() : ((Drive.CrossAxis) drive).stiffness();
        String slope = String.format(Locale.ROOT, "stiffness across %.4g N/m", across).replace('-', '−');
        return new Portrait("Force in " + where + " over the motion across",
                Portrait.Scale.of("Relative displacement across", "mm"),
                Portrait.Scale.of("Force that the recording asks for", "N"),
                line(stretched(drive), 1e3, integrated(latent.force(), 0), 1, across, slope),
                Clouds.noted(latent, "Above 1 Hz. The slope is the stiffness across."));
    }

    /** The force at a place over the acceleration across that is said to cause it. */
    Portrait over(Drive.Across drive) {
        String slope = String.format(Locale.ROOT, "coupled mass %.3g kg", drive.mass()).replace('-', '−');
        return new Portrait("Force at " + where + " over the acceleration of " + drive.across(),
                Portrait.Scale.of("Acceleration across", "m/s²"), Portrait.Scale.of("Force that the recording asks for", "N"),
                line(integrated(evidence.series(drive.across()), 0), 1, integrated(latent.force(), 0), 1, drive.mass(), slope),
                Clouds.noted(latent, "Above 1 Hz. The slope is the coupled mass."));
    }

    /**
     * Samples of y over x, and a straight line.
     *
     * @param xUnit factor of x to the unit shown
     * @param yUnit likewise
     */
    private List<Portrait.Trail> line(double[] x, double xUnit, double[] y, double yUnit, double slope, String name) {
        List<Portrait.Trail> trails = new ArrayList<>(new Clouds(evidence, latent::known).samples(x, xUnit, y, yUnit));
        double end = Arrays.stream(x).map(Math::abs).max().orElse(1);
        trails.add(Portrait.Trail.law(name, new double[] {-end * xUnit, end * xUnit},
                new double[] {-end * slope * yUnit, end * slope * yUnit}));
        return trails;
    }

    /** Displacement between a link's ends across [m], with the swing of one that carries no sensor. */
    private double[] stretched(Drive drive) {
        if (drive instanceof Drive.Swings swings) {
            double[] measured = integrated(less(swings.measured(), swings.base()), 2);
            double[] swing = evidence.whole()
                    .series(Swing.of(swings, evidence.whole().omega(), smooth(swings.base()), smooth(swings.rate())));
            return IntStream.range(0, swing.length).mapToDouble(i -> (swings.above() ? 1 : -1) * (swing[i] - measured[i])).toArray();
        }
        Drive.CrossAxis cross = (Drive.CrossAxis) drive;
        return integrated(less(cross.upper(), cross.lower()), 2);
    }

    /** Spectrum of a channel above 1 Hz. */
    private double[] smooth(Channel channel) {
        return evidence.whole().spectrum(integrated(evidence.series(channel), 0));
    }

    private double[] less(Channel one, Channel other) {
        double[] out = evidence.series(one).clone();
        double[] away = evidence.series(other);
        for (int i = 0; i < out.length; i++) {
            out[i] -= away[i];
        }
        return out;
    }

    /** Integrated so many times, none to two, above 1 Hz. */
    private double[] integrated(double[] series, int times) {
        double[] spectrum = evidence.whole().spectrum(series);
        double[] omega = evidence.whole().omega();
        for (int k = 0; k < omega.length; k++) {
            double u = Math.pow(omega[k] / (2 * Math.PI), 8);
            double gain = k == 0 ? 0 : u / (1 + u) / Math.pow(omega[k], times);
            double re = spectrum[2 * k] * gain;
            double im = spectrum[2 * k + 1] * gain;
            spectrum[2 * k] = times == 0 ? re : times == 1 ? im : -re;
            spectrum[2 * k + 1] = times == 0 ? im : times == 1 ? -re : -im;
        }
        return evidence.whole().series(spectrum);
    }
}
