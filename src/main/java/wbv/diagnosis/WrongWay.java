package wbv.diagnosis;

import java.util.ArrayList;
import wbv.body.Assembly;
import wbv.body.Excitation;
import wbv.body.Simulator;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * What a model that stands for a simulation gets wrong of the way from a law's force to the outputs. A chain that was identified from what a base's
 * motion does knows little of what a force within it does: fore and aft, about joints, past bodies that it does not have. To each output the way may
 * so differ by an impulse response of a third of a second, every sample of it about as large as a part of the chain's own.
 */
final class WrongWay {

    /** Longest that the way may differ [s]: a turn of what sitters swing at 3 Hz, the slowest that a force in a link moves much. */
    private static final double LASTING = 1.0 / 3;
    /**
     * Root mean square of the difference over the chain's own way. Assumed; chains identified from simulations by another engine, pushed by the forces
     * that were concealed from them, differed by 0.2 to 0.5.
     */
    private static final double PART = 0.3;

    private WrongWay() { }

    /**
     * The errors of the ways of all forces of laws that a candidate adds, over as much of the recording as an excitation has; none where the model
     * stands for itself.
     *
     * @param x of the candidate. Not modified.
     */
    static ErrorShapes of(Evidence evidence, Excitation excitation, Candidate candidate, double[] x) {
        ErrorShapes all = new ErrorShapes(new ArrayList<>(), new ArrayList<>());
        int[] links = candidate.added().stream().flatMap(hypothesis -> hypothesis.additions().stream())
                .filter(Hypothesis.Addition.InLink.class::isInstance).mapToInt(addition -> ((Hypothesis.Addition.InLink) addition).link()).distinct().toArray();
        if (!evidence.standsForSimulation() || links.length == 0) {
            return all;
        }
        Simulator simulator = new Simulator(excitation);
        Assembly assembly = candidate.at(x);
        Simulator.Response response = simulator.run(assembly, false);
        if (response.diverged()) {
            return all;
        }
        Simulator.Linearised linear = simulator.linearised(assembly);
        int taps = (int) Math.round(LASTING * excitation.rate());
        for (int link : links) {
            double[] force = new double[2 * excitation.omega().length];
            for (int law = 0; law < response.forces().length; law++) {
                for (int k = 0; k < force.length && assembly.laws().get(law).link() == link; k++) {
                    force[k] += response.forces()[law][k];
                }
            }
            double[] series = excitation.series(beyond(excitation.omega(), force, response.stretch()[link]));
            double[][] way = linear.ofLinkForce(link);
            for (int o = 0; o < way.length; o++) {
                double size = PART * size(excitation.series(way[o]), taps);
                for (int tap = 0; tap < taps; tap++) {
                    all.addLate(new SmallError(SmallError.Kind.WAY, o, ""),
                            way.length, series, tap, size);
                }
            }
        }
        return all;
    }

    /**
     * A force less what goes with the link's stretch and its rate, which the link's own spring and dashpot carry another way: or else a law with much of
     * that would have a reflex in the errors of its way.
     */
    private static double[] beyond(double[] omega, double[] force, double[] stretch) {
        double along = 0;
        double across = 0;
        double size = 0;
        double speed = 0;
        for (int k = 0; k < omega.length; k++) {
            double square = stretch[2 * k] * stretch[2 * k] + stretch[2 * k + 1] * stretch[2 * k + 1];
            along += force[2 * k] * stretch[2 * k] + force[2 * k + 1] * stretch[2 * k + 1];
            across += omega[k] * (force[2 * k + 1] * stretch[2 * k] - force[2 * k] * stretch[2 * k + 1]);
            size += square;
            speed += omega[k] * omega[k] * square;
        }
        double stiffness = size > 0 ? along / size : 0;
        double damping = speed > 0 ? across / speed : 0;
        double[] out = force.clone();
        for (int k = 0; k < omega.length; k++) {
            out[2 * k] -= stiffness * stretch[2 * k] - damping * omega[k] * stretch[2 * k + 1];
            out[2 * k + 1] -= stiffness * stretch[2 * k + 1] + damping * omega[k] * stretch[2 * k];
        }
        return out;
    }

    /** Root mean square of the beginning of an impulse response. */
    private static double size(double[] response, int taps) {
        double sum = 0;
        for (int i = 0; i < taps; i++) {
            sum += response[i] * response[i];
        }
        return Math.sqrt(sum / taps);
    }
}
