package wbv.diagnosis.fit;

import java.util.ArrayList;
import java.util.function.Supplier;
import wbv.body.Assembly;
import wbv.body.Spectra;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.measured.SmallError;
import wbv.diagnosis.mechanism.Addition;

/**
 * What a model that stands for a simulation gets wrong of the way from a link's force to the outputs, where a law makes that another than
 * it was. A chain that was identified from what a base's motion does knows little of what a force within it does: fore and aft, about
 * joints, past bodies that it does not have. To each output the way may so differ by an impulse response of a third of a second, every
 * sample of it about as large as a part of the chain's own.
 */
final class WrongWay {

    /** Longest that the way may differ [s]: a turn of what sitters swing at 3 Hz, the slowest that a force in a link moves much. */
    private static final double LASTING = 1.0 / 3;
    /**
     * Root mean square of the difference over the chain's own way, at most. Assumed; chains identified from simulations by another engine,
     * pushed by the forces that were concealed from them, differed by 0.2 to 0.5.
     */
    private static final double PART = 0.5;

    /** The slowest mode of a sitter, fore and aft [rad/s]. */
    private static final double SLOWEST = 2 * Math.PI * 1.5;

    private WrongWay() {}

    /**
     * The errors of the ways of all forces of laws that a candidate adds, over as much of the recording as an excitation has; none where
     * these are not free.
     *
     * @param x of the candidate. Not modified.
     * @param ran what the candidate does there; asked only where ways are free
     */
    static ErrorShapes of(Excitation excitation, Candidate candidate, double[] x, Supplier<Simulator.Response> ran) {
        ErrorShapes all = new ErrorShapes(new ArrayList<>(), new ArrayList<>());
        int[] links = candidate.added().stream().flatMap(hypothesis -> hypothesis.additions().stream())
                .filter(Addition.InLink.class::isInstance).mapToInt(addition -> ((Addition.InLink) addition).link())
                .distinct().toArray();
        if (!candidate.freeWays() || links.length == 0) {
            return all;
        }
        Simulator.Response response = ran.get();
        if (response.diverged()) {
            return all;
        }
        Assembly assembly = candidate.at(x);
        Simulator.Linearised linear = new Simulator(excitation).linearised(assembly);
        int taps = (int) Math.round(LASTING * excitation.rate());
        for (int link : links) {
            double[] force = new double[2 * excitation.omega().length];
            for (int law = 0; law < response.forces().length; law++) {
                if (assembly.laws().get(law).link() == link) {
                    Spectra.add(force, response.forces()[law], 1);
                }
            }
            // What the link's own spring and dashpot give way to a law does not leave the link.
            double stiffness = assembly.structure().stiffness()[link] - candidate.given(Slot.of(Slot.Kind.STIFFNESS, link));
            double damping = assembly.structure().damping()[link] - candidate.given(Slot.of(Slot.Kind.DAMPING, link));
            double[] stretch = response.stretch()[link];
            Spectra.add(force, stretch, stiffness);
            Spectra.add(force, Spectra.timesJOmega(excitation.omega(), stretch), damping);
            double[] series = excitation.series(swinging(excitation.omega(), force));
            double[][] way = linear.ofLinkForce(link);
            for (int o = 0; o < way.length; o++) {
                double size = PART * Motion.rms(excitation.series(way[o]), taps);
                for (int tap = 0; tap < taps; tap++) {
                    all.addLate(new SmallError(SmallError.Kind.WAY, o, ""),
                            way.length, series, tap, size);
                }
            }
        }
        return all;
    }

    /**
     * A force without what is so slow that it moves nothing: below its modes a structure answers with the square of the frequency. Filters
     * in place.
     */
    private static double[] swinging(double[] omega, double[] force) {
        for (int k = 0; k < omega.length; k++) {
            double u = omega[k] / SLOWEST;
            double re = 1 - u * u;
            double im = Math.sqrt(2) * u;
            double factor = -u * u / (re * re + im * im);
            double own = force[2 * k];
            force[2 * k] = factor * (own * re + force[2 * k + 1] * im);
            force[2 * k + 1] = factor * (force[2 * k + 1] * re - own * im);
        }
        return force;
    }
}
