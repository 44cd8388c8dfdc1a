package wbv.diagnosis.surrogate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import wbv.body.Spectra;
import wbv.body.simulate.Excitation;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.Recording;
import wbv.signal.ScalarProduct;

/**
 * What bodies in a plane are to do, line by line: spectra of what moves their base, and of what a simulation gave of each output. A line is
 * two numbers side by side, its real and its imaginary part.
 *
 * @param omega   angular frequency of each line [rad/s]. Not copied
 * @param base    spectra of its acceleration along x [m/s²], along z and about y [rad/s²], zeros along what was not recorded. Not copied
 * @param outputs that are to be met
 */
record PlaneSpectra(double[] omega, double[][] base, List<Output> outputs) {

    /** Part of an output's energy that the lines hold which are fitted. */
    private static final double HELD = 0.999;
    /** A sitter's resonances are as wide as many lines; so many over the band tell them all. */
    private static final int MOST_LINES = 400;
    /** Along x, along z, about y. */
    private static final int MOTIONS = PlaneNet.MOTIONS;

    /**
     * An output.
     *
     * @param read  index among the readings of a net: three for a measured place
     * @param rate  whether it is an angular rate, not an acceleration
     * @param lines its spectrum. Not copied
     * @param size  root of the sum of its squares, by which what is missed of it counts
     */
    record Output(int read, boolean rate, double[] lines, double size) {
        Output(int read, boolean rate, double[] lines) {
            this(read, rate, lines, Math.sqrt(ScalarProduct.of(lines, lines)));
        }
    }

    PlaneSpectra {
        outputs = List.copyOf(outputs);
        int lines = 2 * omega.length;
        if (base.length != MOTIONS || Arrays.stream(base).anyMatch(axis -> axis.length != lines)
                || outputs.stream().anyMatch(output -> output.lines().length != lines)) {
            throw new IllegalArgumentException("spectra along x, along z and about y, and of all outputs, must have " + omega.length
                    + " lines");
        }
    }

    /**
     * So many lines of a recording as tell what its outputs do.
     *
     * @param together what moves the base beside what the outputs gave
     * @param axes     of the base that were recorded
     * @param places   in the order of a net's parts
     */
    static PlaneSpectra of(Recording together, List<Channel> axes, List<String> places, List<Channel> outputs) {
        double[] omega = new Excitation(together.clock().rate(), together.values(axes.get(0)), Map.of()).omega();
        List<double[]> spectra = outputs.stream().map(output -> spectrum(together, output)).toList();
        int lines = spectra.stream().mapToInt(PlaneSpectra::held).max().orElseThrow();
        int step = (lines + MOST_LINES - 1) / MOST_LINES;
        double[] kept = IntStream.iterate(1, k -> k < lines, k -> k + step).mapToDouble(k -> omega[k]).toArray();
        double[][] base = new double[MOTIONS][2 * kept.length];
        for (Channel axis : axes) {
            double[] own = every(spectrum(together, axis), step, lines);
            base[motion(axis)] = turns(axis) ? Spectra.timesJOmega(kept, own) : own;
        }
        List<Output> fitted = new ArrayList<>();
        for (int o = 0; o < outputs.size(); o++) {
            Channel output = outputs.get(o);
            fitted.add(new Output(MOTIONS * places.indexOf(output.location()) + motion(output), turns(output),
                    every(spectra.get(o), step, lines)));
        }
        return new PlaneSpectra(kept, base, fitted);
    }

    private static boolean turns(Channel channel) {
        return channel.quantity() == Quantity.ANGULAR_RATE;
    }

    private static int motion(Channel channel) {
        return turns(channel) ? 2 : channel.axis() == 'x' ? 0 : 1;
    }

    /** Every so many lines, but not that at no frequency. */
    private static double[] every(double[] spectrum, int step, int lines) {
        return IntStream.iterate(1, k -> k < lines, k -> k + step).flatMap(k -> IntStream.of(2 * k, 2 * k + 1))
                .mapToDouble(i -> spectrum[i]).toArray();
    }

    /**
     * Seen through Hann's window: what a body does late by τ is then wrong by about πτ over the length, a thousandth of a record of
     * minutes, where a window with steeper ends is wrong by percents.
     */
    private static double[] spectrum(Recording together, Channel channel) {
        double[] x = together.values(channel).clone();
        Arrays.setAll(x, i -> x[i] * (0.5 - 0.5 * Math.cos(2 * Math.PI * (i + 0.5) / x.length)));
        return new Excitation(together.clock().rate(), x, Map.of()).baseSpectrum();
    }

    /** Lines that hold nearly all of a spectrum's energy. */
    private static int held(double[] spectrum) {
        double all = ScalarProduct.of(spectrum, spectrum);
        int lines = spectrum.length / 2;
        double above = 0;
        while (lines > 2 && above < (1 - HELD) * all) {
            lines--;
            above += spectrum[2 * lines] * spectrum[2 * lines] + spectrum[2 * lines + 1] * spectrum[2 * lines + 1];
        }
        return lines;
    }
}
