package wbv.diagnosis.picture;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.law.Law;
import wbv.body.law.Learned;
import wbv.body.simulate.Swing;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.learn.LatentEstimator;
import wbv.diagnosis.learn.LatentForce;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.recording.Channel;
import wbv.signal.FrequencyResponse;
import wbv.signal.RealDft;

/**
 * Chooses the picture in which a mechanism shows: force over deflection, stiffness over time, a line in a spectrum, and so on.
 */
final class Portraits {

    private static final int DENSER = 4;
    private static final double SHOWN = 4;

    private final Evidence evidence;
    private final Fitter.State base;
    private final Fitter.State chosen;
    private final double rate;

    Portraits(Evidence evidence, Fitter.State base, Fitter.State chosen) {
        this.evidence = evidence;
        this.base = base;
        this.chosen = chosen;
        this.rate = evidence.recording().clock().rate();
    }

    /** Portraits of everything that was added, or else of the best place for what nothing explains. */
    List<Portrait> all(List<Diagnosis.Latent> latent) {
        List<Portrait> out = new ArrayList<>();
        List<Hypothesis> added = chosen.candidate().added();
        List<Hypothesis> found = added.subList(base.candidate().added().size(), added.size());
        found.stream().filter(hypothesis -> hypothesis.mechanism().equals(Learned.MECHANISM)).findFirst()
                .ifPresent(term -> out.addAll(learned(term)));
        for (Hypothesis hypothesis : out.isEmpty() ? found : List.<Hypothesis>of()) {
            hypothesis.additions().stream().limit(1).forEach(addition -> out.addAll(of(hypothesis, addition)));
        }
        if (out.isEmpty() && !latent.isEmpty()) {
            out.addAll(of(latent.get(0)));
        }
        return out;
    }

    private List<Portrait> of(Hypothesis hypothesis, Hypothesis.Addition addition) {
        if (addition instanceof Hypothesis.Addition.InLink in) {
            return new LinkPortraits(evidence, latent(false, in.link()), hypothesis.where(), in.link()).of(found(in.link()));
        }
        if (addition instanceof Hypothesis.Addition.Driven driven) {
            if (driven.drive() instanceof Drive.Tone) {
                return onBody(latent(true, driven.place()), hypothesis.where(), true);
            }
            Drive drive = chosen.candidate().at(chosen.x()).drives().stream()
                    .filter(at -> at.place() == driven.place() && at.drive().getClass() == driven.drive().getClass()).findFirst()
                    .orElseThrow().drive();
            return driven(drive, driven.place(), hypothesis.where());
        }
        if (addition instanceof Hypothesis.Addition.AtSensor at) {
            return new SensorPortraits(evidence, base, chosen, at.output()).of(at.fault());
        }
        return List.of(hidden(latent(true, ((Hypothesis.Addition.Hidden) addition).body()), hypothesis.where()));
    }

    /** What drives a place; a force whose sensor errs has no motion that it goes by, and is drawn as any other on a body. */
    private List<Portrait> driven(Drive drive, int place, String where) {
        if (drive instanceof Drive.Across across) {
            return List.of(pushed(latent(drive.actsOnBody(), place), across.across(), across.mass(), where));
        }
        boolean byMotion = drive instanceof Drive.Rotation || drive instanceof Drive.Swings || drive instanceof Drive.CrossAxis;
        return byMotion ? List.of(coupled(drive, place, where)) : onBody(latent(true, place), where, true);
    }

    /**
     * A law that was learned over the force that the recording asks for: in time, by deflection and speed, and one over the other.
     *
     * @param term one of it
     */
    private List<Portrait> learned(Hypothesis term) {
        int link = ((Hypothesis.Addition.InLink) term.additions().get(0)).link();
        LatentForce latent = latent(false, link);
        return new LinkPortraits(evidence, latent, term.where(), link).learned();
    }

    private List<Portrait> of(Diagnosis.Latent place) {
        for (int l = 0; l < evidence.model().links().size(); l++) {
            if (place.kind().equals("link") && evidence.model().links().get(l).name().equals(place.where())) {
                return new LinkPortraits(evidence, latent(false, l), place.where(), l).unnamed();
            }
        }
        for (int b = 0; b < evidence.model().bodies().size(); b++) {
            if (place.kind().equals("body") && evidence.model().bodies().get(b).name().equals(place.where())) {
                return onBody(latent(true, b), place.where(), false);
            }
        }
        for (int o = 0; o < evidence.outputs().size(); o++) {
            String name = new Place(place.kind().equals("device") ? Place.Kind.DEVICE : Place.Kind.SENSOR, o).name(evidence);
            if ((place.kind().equals("sensor") || place.kind().equals("device")) && name.equals(place.where())) {
                return new SensorPortraits(evidence, base, chosen, o).unnamed();
            }
        }
        return List.of();
    }

    private LatentForce latent(boolean onBody, int place) {
        return new LatentEstimator(evidence, base.candidate(), chosen, onBody, place).force();
    }

    /** The law that was added in a link, with the numbers found. */
    private Law found(int link) {
        Assembly full = chosen.candidate().at(chosen.x());
        return full.laws().subList(base.candidate().template().laws().size(), full.laws().size()).stream()
                .filter(at -> at.link() == link)
                .findFirst().orElseThrow().law();
    }

    /** A force on a body: its spectrum, and a few seconds of it. */
    private List<Portrait> onBody(LatentForce latent, String where, boolean named) {
        List<Portrait> out = new ArrayList<>();
        double[] force = latent.force();
        double[] law = latent.law();
        List<Portrait.Trail> lines = new ArrayList<>();
        lines.add(spectrum("force that the recording asks for", Portrait.Kind.MEASURED, force));
        if (named) {
            lines.add(spectrum("force found", Portrait.Kind.LAW, law));
        }
        String spacing = String.format(Locale.ROOT, "%.2g Hz apart", rate / force.length);
        out.add(new Portrait("Force on " + where + " over frequency", Portrait.Scale.of("Frequency", "Hz"),
                Portrait.Scale.of("Amplitude", "N"), lines,
                "Amplitude of a steady tone at each frequency, from the whole record (" + spacing + ")."));
        int from = evidence.heldOut().start();
        int count = (int) Math.min(evidence.heldOut().length() - rate, Math.round(SHOWN * rate));
        double[] time = IntStream.range(from, from + count).mapToDouble(i -> i / rate).toArray();
        List<Portrait.Trail> histories = new ArrayList<>();
        histories.add(Portrait.Trail.measured("force that the recording asks for", time,
                Arrays.copyOfRange(force, from, from + count), new double[0]));
        if (named) {
            histories.add(Portrait.Trail.law("force found", time, Arrays.copyOfRange(law, from, from + count)));
        }
        out.add(new Portrait("Force on " + where + " over time", Portrait.Scale.of("Time", "s"),
                Portrait.Scale.of("Force", "N"), histories, noted(latent, "Held-out part.")));
        return out;
    }

    /**
     * Amplitude of a steady tone by frequency: Hann's window, the highest of each four lines, which are four times as dense as
     * the record makes them.
     */
    private Portrait.Trail spectrum(String name, Portrait.Kind kind, double[] force) {
        RealDft transform = new RealDft(RealDft.fitting(DENSER * force.length));
        double[] tapered = new double[transform.length()];
        for (int i = 0; i < force.length; i++) {
            tapered[i] = force[i] * (1 - Math.cos(2 * Math.PI * (i + 0.5) / force.length));
        }
        double[] spectrum = transform.forward(tapered);
        double spacing = rate / transform.length();
        double top = evidence.fit().frequency(evidence.fit().lines() - 1);
        int first = (int) (1 / spacing) / DENSER;
        int count = (int) (top / spacing) / DENSER - first;
        double[] f = new double[count];
        double[] amplitude = new double[count];
        for (int line = 0; line < count; line++) {
            for (int k = DENSER * (first + line); k < DENSER * (first + line + 1); k++) {
                double own = 2 * Math.hypot(spectrum[2 * k], spectrum[2 * k + 1]) / force.length;
                f[line] = own > amplitude[line] ? k * spacing : f[line];
                amplitude[line] = Math.max(own, amplitude[line]);
            }
            f[line] = amplitude[line] > 0 ? f[line] : DENSER * (first + line) * spacing;
        }
        return new Portrait.Trail(name, kind, f, amplitude, new double[0]);
    }

    /** Force over acceleration: the mass that answers at each frequency. */
    private Portrait hidden(LatentForce latent, String where) {
        List<Portrait.Trail> trails = OutputCharts.response(latent.bodyAcceleration(), new double[][] {known(latent, latent.force()),
            latent.law()}, rate).map(h -> {
                int[] shown = shown(h.get(0), 1.5);
                double[] f = OutputCharts.pick(h.get(0).frequency(), shown);
                double[] mass = OutputCharts.pick(h.get(0).h1().magnitudes(), shown);
                double[] error = OutputCharts.pick(h.get(0).error(), shown);
                return List.of(Portrait.Trail.measured("as the recording asks", f, mass,
                        IntStream.range(0, f.length).mapToDouble(i -> mass[i] * error[i]).toArray()),
                        Portrait.Trail.law("hidden mass as found", f, OutputCharts.pick(h.get(1).h1().magnitudes(), shown)));
            }).orElse(List.of());
        return new Portrait("Mass that is felt at " + where + " beside the body's own",
                new Portrait.Scale("Frequency", "Hz", true),
                Portrait.Scale.of("Force over acceleration", "kg"), trails,
                "A mass on a spring is felt as itself at low frequencies, more at its "
                        + "resonance, and not at all far above it.");
    }

    /** What drives a link over the motion that is said to drive it: a line if it is so. */
    private Portrait coupled(Drive drive, int link, String where) {
        LatentForce latent = latent(false, link);
        if (drive instanceof Drive.Rotation rotation) {
            double[] tilt = integrated(evidence.series(rotation.rate()), 1);
            String slope = String.format(Locale.ROOT, "lever arm %.3g mm", 1e3 * rotation.arm()).replace('-', '−');
            return new Portrait("Lift of " + where + " over the tilt of " + rotation.rate().location(),
                    Portrait.Scale.of("Tilt about " + rotation.rate().axis(), "mrad"),
                    Portrait.Scale.of("Lift that the recording asks for", "mm"),
                    line(latent, tilt, integrated(latent.lift(link), 0), 1e3, rotation.arm(), slope),
                    "Tilt from the measured rate, above 1 Hz. The slope is the lever arm.");
        }
        double across = drive instanceof Drive.Swings swings ? swings.stiffness() : ((Drive.CrossAxis) drive).stiffness();
        String slope = String.format(Locale.ROOT, "stiffness across %.4g N/m", across).replace('-', '−');
        return new Portrait("Force in " + where + " over the motion across",
                Portrait.Scale.of("Relative displacement across", "mm"),
                Portrait.Scale.of("Force that the recording asks for", "N"),
                line(latent, stretched(drive), integrated(latent.force(), 0), 1, across, slope),
                noted(latent, "Above 1 Hz. The slope is the stiffness across."));
    }

    /** The force at a place over the acceleration across that is said to cause it. */
    private Portrait pushed(LatentForce latent, Channel across, double mass, String where) {
        double[] a = integrated(evidence.series(across), 0);
        List<Portrait.Trail> trails = new ArrayList<>(new Clouds(evidence, latent::known).samples(a, 1, integrated(latent.force(), 0), 1));
        double end = Arrays.stream(a).map(Math::abs).max().orElse(1);
        trails.add(Portrait.Trail.law(String.format(Locale.ROOT, "coupled mass %.3g kg", mass).replace('-', '−'),
                new double[] {-end, end}, new double[] {-end * mass, end * mass}));
        return new Portrait("Force at " + where + " over the acceleration of " + across,
                Portrait.Scale.of("Acceleration across", "m/s²"), Portrait.Scale.of("Force that the recording asks for", "N"), trails,
                noted(latent, "Above 1 Hz. The slope is the coupled mass."));
    }

    /**
     * Samples of y over x, shown in thousandths, and a straight line.
     *
     * @param unit factor of y to the unit shown
     */
    private List<Portrait.Trail> line(LatentForce latent, double[] x, double[] y, double unit, double slope, String name) {
        List<Portrait.Trail> trails = new ArrayList<>(new Clouds(evidence, latent::known).samples(x, 1e3, y, unit));
        double end = Arrays.stream(x).map(Math::abs).max().orElse(1);
        trails.add(Portrait.Trail.law(name, new double[] {-end * 1e3, end * 1e3},
                new double[] {-end * slope * unit, end * slope * unit}));
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

    private double[] known(LatentForce latent, double[] series) {
        return IntStream.range(0, series.length).mapToDouble(i -> latent.known(i) ? series[i] : Double.NaN).toArray();
    }

    private int[] shown(FrequencyResponse h, double from) {
        double top = evidence.fit().frequency(evidence.fit().lines() - 1);
        return IntStream.range(0, h.frequency().length).filter(k -> h.frequency()[k] >= from && h.frequency()[k] <= top
                && h.usable()[k]).toArray();
    }

    private static String noted(LatentForce latent, String words) {
        double scatter = 2 * latent.pointNoise();
        return words + String.format(Locale.ROOT, " The sensors' noise alone scatters a sample by ±%.2g N.", scatter);
    }
}
