package wbv.diagnosis.picture;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.learn.LatentForce;
import wbv.signal.RealDft;

/** The latent force on a body over frequency and time, or as the mass that it is felt as. */
final class BodyPortraits {

    /** How many times as dense as the record makes them the lines of a spectrum are. */
    private static final int DENSER = 4;

    private final Evidence evidence;
    private final LatentForce latent;
    private final String where;
    private final double rate;

    BodyPortraits(Evidence evidence, LatentForce latent, String where) {
        this.evidence = evidence;
        this.latent = latent;
        this.where = where;
        this.rate = evidence.recording().clock().rate();
    }

    /**
     * Its spectrum, and a few seconds of it.
     *
     * @param named whether a force was found that makes it
     */
    List<Portrait> force(boolean named) {
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
        List<Portrait.Trail> histories = Clouds.histories(evidence, force, "force found", law).subList(0, named ? 2 : 1);
        out.add(new Portrait("Force on " + where + " over time", Portrait.Scale.of("Time", "s"),
                Portrait.Scale.of("Force", "N"), histories, Clouds.noted(latent, "Held-out part.")));
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
    Portrait mass() {
        List<Portrait.Trail> trails = OutputCharts.response(latent.bodyAcceleration(), new double[][] {latent.knownForce(),
            latent.law()}, rate).map(h -> {
                int[] shown = OutputCharts.usable(evidence, h.get(0), 1.5);
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
}
