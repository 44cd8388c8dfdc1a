package wbv.body.simulate;

import java.util.function.IntFunction;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.Spectra;
import wbv.body.number.Numbers;
import wbv.recording.Channel;

/** The forces of an assembly's drives on an excitation, and how far they lift the lower ends of links, as spectra. */
final class DriveForces {

    private final Excitation excitation;
    private final Assembly assembly;
    private final IntFunction<double[]> stiffness;

    /** @param stiffness dynamic stiffness of a link, all that is linear in it: it carries that much less where its lower end is lifted */
    DriveForces(Excitation excitation, Assembly assembly, IntFunction<double[]> stiffness) {
        this.excitation = excitation;
        this.assembly = assembly;
        this.stiffness = stiffness;
    }

    /** How far drive d lifts the lower end of its link [m]; empty where it lifts none. */
    double[] lift(int d) {
        return assembly.drives().get(d).drive() instanceof Drive.Rotation rotation ? lift(rotation.rate(), rotation.arm()) : new double[0];
    }

    /** Derivative of that to a parameter; empty where there is none. */
    double[] liftSlope(int d, int p) {
        return assembly.drives().get(d).drive() instanceof Drive.Rotation rotation && p == assembly.driveIndex(d)
                ? lift(rotation.rate(), 1) : new double[0];
    }

    /** Derivative of the force of drive d to a parameter; empty where there is none. */
    double[] slope(int d, int p) {
        Assembly.DriveAt at = assembly.drives().get(d);
        int links = assembly.structure().links();
        if (at.drive() instanceof Drive.Rotation rotation && p < 2 * links && p % links == at.place()) {
            double[] lift = lift(rotation.rate(), rotation.arm());
            double[] out = new double[lift.length];
            Spectra.add(out, p < links ? lift : Spectra.timesJOmega(excitation.omega(), lift), -1);
            return out;
        }
        if (at.drive() instanceof Drive.Launch) {
            return new double[0];   // a start, and no force
        }
        int own = p - assembly.driveIndex(d);
        double[] values = Numbers.values((Record) at.drive());
        if (own < 0 || own >= values.length) {
            return new double[0];
        }
        double h = 1e-5 * Math.max(Math.abs(values[own]), 1e-3);
        values[own] += h;
        double[] high = of(at.place(), (Drive) Numbers.with((Record) at.drive(), values));
        values[own] -= 2 * h;
        double[] low = of(at.place(), (Drive) Numbers.with((Record) at.drive(), values));
        for (int i = 0; i < high.length; i++) {
            high[i] = (high[i] - low[i]) / (2 * h);
        }
        return high;
    }

    /** Spectrum of the force of drive d, in its link or on its body. */
    double[] of(int d) {
        Assembly.DriveAt at = assembly.drives().get(d);
        return of(at.place(), at.drive());
    }

    private double[] of(int place, Drive drive) {
        if (drive instanceof Drive.Tone tone) {
            double[] series = new double[excitation.samples()];
            for (int j = 0; j < series.length; j++) {
                double phase = 2 * Math.PI * tone.frequency() * j / excitation.rate();
                series[j] = tone.cosine() * Math.cos(phase) + tone.sine() * Math.sin(phase);
            }
            return excitation.spectrum(series);
        }
        if (drive instanceof Drive.Launch) {
            return new double[2 * excitation.omega().length];
        }
        if (drive instanceof Drive.Measured measured) {
            double[] constant = new double[excitation.samples()];
            java.util.Arrays.fill(constant, -measured.offset());
            double[] out = excitation.spectrum(constant);
            Spectra.add(out, excitation.other(measured.channel()), 1);
            return out;
        }
        if (drive instanceof Drive.Late late) {
            double[] out = excitation.other(late.channel()).clone();
            for (int k = 0; k < excitation.omega().length; k++) {
                double turn = excitation.omega()[k] * late.delay();
                double re = out[2 * k];
                double im = out[2 * k + 1];
                out[2 * k] = re * (Math.cos(turn) - 1) - im * Math.sin(turn);
                out[2 * k + 1] = im * (Math.cos(turn) - 1) + re * Math.sin(turn);
            }
            return out;
        }
        if (drive instanceof Drive.Coupled coupled) {
            double[] passed = excitation.series(excitation.other(coupled.channel()));
            double[] lost = new double[passed.length];
            for (int j = 1; j < lost.length; j++) {
                lost[j] = lost[j - 1] + Math.PI * coupled.corner() / excitation.rate() * (passed[j - 1] + passed[j]);
            }
            return excitation.spectrum(lost);
        }
        if (drive instanceof Drive.Given given) {
            return scaled(excitation.other(given.channel()), given.share());
        }
        if (drive instanceof Drive.CrossAxis cross) {
            return apart(cross.upper(), cross.lower(), cross.stiffness());
        }
        if (drive instanceof Drive.Swings swings) {
            double pull = swings.above() ? swings.stiffness() : -swings.stiffness();
            double[] out = apart(swings.measured(), swings.base(), -pull);
            Spectra.add(out, Swing.of(swings, excitation.omega(), excitation.other(swings.base()), excitation.other(swings.rate())), pull);
            return out;
        }
        if (drive instanceof Drive.Across across) {
            return scaled(excitation.other(across.across()), across.mass());
        }
        Drive.Rotation rotation = (Drive.Rotation) drive;
        double[] out = new double[2 * excitation.omega().length];
        Spectra.addProduct(stiffness.apply(place), lift(rotation.rate(), rotation.arm()), -1, out);
        return out;
    }

    /** How far two places are apart across, from their accelerations, times a factor. */
    private double[] apart(Channel one, Channel other, double factor) {
        double[] out = excitation.other(one).clone();
        Spectra.add(out, excitation.other(other), -1);
        return twiceIntegrated(out, factor);
    }

    private double[] scaled(double[] spectrum, double factor) {
        double[] out = new double[spectrum.length];
        Spectra.add(out, spectrum, factor);
        return out;
    }

    /** arm times the angle, from the measured rate. */
    private double[] lift(Channel rate, double arm) {
        double[] omega = excitation.omega();
        double[] measured = excitation.other(rate);
        double[] out = new double[measured.length];
        for (int k = 1; k < omega.length; k++) {
            out[2 * k] = arm * measured[2 * k + 1] / omega[k];
            out[2 * k + 1] = -arm * measured[2 * k] / omega[k];
        }
        return out;
    }

    /** Displacement from acceleration above 0.6 Hz; below, drift would drown it. */
    private double[] twiceIntegrated(double[] acceleration, double factor) {
        double[] omega = excitation.omega();
        for (int k = 0; k < omega.length; k++) {
            double gain = k == 0 ? 0 : -factor * Swing.passed(omega[k]) / (omega[k] * omega[k]);
            acceleration[2 * k] *= gain;
            acceleration[2 * k + 1] *= gain;
        }
        return acceleration;
    }
}
