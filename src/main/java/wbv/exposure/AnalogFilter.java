package wbv.exposure;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;

/**
 * A filter that a standard defines by its transfer function in s: sections in a row.
 *
 * @param sections their order does not matter
 * @param slowest  lowest corner frequency [Hz], which says how long the filter remembers
 */
public record AnalogFilter(List<AnalogSection> sections, double slowest) implements Serializable {

    /** Of a section's memory after a sample, that it has none. */
    private static final double FORGOTTEN = 0.1;

    public AnalogFilter {
        sections = List.copyOf(sections);
        if (!(slowest > 0)) {
            throw new IllegalArgumentException("lowest corner frequency must be > 0 Hz: " + slowest);
        }
    }

    /**
     * The complex response at a frequency [Hz].
     *
     * @param response real and imaginary part [1], two long. Modified.
     */
    public void response(double frequency, double[] response) {
        response[0] = 1;
        response[1] = 0;
        for (AnalogSection section : sections) {
            section.apply(2 * Math.PI * frequency, response);
        }
    }

    /** Modulus of the response [1] at a frequency [Hz]. */
    public double modulus(double frequency) {
        double[] response = new double[2];
        response(frequency, response);
        return Math.hypot(response[0], response[1]);
    }

    /**
     * The same filter for the integral of its input: for angular rates where a standard weights angular accelerations.
     *
     * @throws IllegalStateException if no section has room for a further s
     */
    public AnalogFilter differentiated() {
        List<AnalogSection> changed = new ArrayList<>(sections);
        for (int i = 0; i < changed.size(); i++) {
            if (changed.get(i).plain()) {
                changed.set(i, changed.get(i).differentiated());
                return new AnalogFilter(changed, slowest);
            }
        }
        throw new IllegalStateException("the filter has no low-pass section to be differentiated by");
    }

    /**
     * The filter as a cascade for samples, by the bilinear transform.
     *
     * @param rate [Hz]
     */
    public Cascade cascade(double rate) {
        return new Cascade(sections.stream().map(section -> section.bilinear(rate)).toList());
    }

    /**
     * The memory of the filter as a cascade for samples, by the matched transform, of which {@link Correction} makes the filter: sections
     * that forget within two samples are left to that.
     *
     * @param rate [Hz]
     * @param frequency where the moduli are true [Hz]
     */
    Cascade matched(double rate, double frequency) {
        return new Cascade(sections.stream().filter(section -> section.remembers(rate) > FORGOTTEN)
                .map(section -> section.matched(rate, frequency)).toList());
    }
}
