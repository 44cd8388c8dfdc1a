package wbv.body.simulate;

import java.util.Arrays;
import java.util.Optional;
import wbv.body.Row;
import wbv.body.Spectra;
import wbv.body.Structure;

/**
 * The linear part of a structure in the frequency domain: q = Z⁻¹ (-M 1 A - E Φ + f) at every spectral line, exact, with no step.
 *
 * <p>Spectra are arrays of 2K numbers, real and imaginary part of line k at 2k and 2k + 1. Z is symmetric and is inverted once
 * for all lines; after {@link #solve}, the answer to any force costs one multiplication a line.
 */
final class SpectralResponse {

    private final Excitation excitation;
    private final double[] omega;
    private final int lines;
    private Structure structure;
    private double[][] stiffness;
    /** Z⁻¹ as n·n spectra, symmetric: entry (i, j) at i n + j. */
    private double[][] inverse;
    private Optional<Brakes> brakes = Optional.empty();

    /** @param excitation whose lines are solved for */
    SpectralResponse(Excitation excitation) {
        this.excitation = excitation;
        this.omega = excitation.omega();
        this.lines = omega.length;
    }

    /**
     * Inverts Z for a structure whose links may carry further dynamic stiffness.
     *
     * @param further dynamic stiffness beside k + jωc, a spectrum by link; an empty array where a link has none. Not copied
     */
    void solve(Structure s, double[][] further) {
        structure = s;
        boolean plain = Arrays.stream(further).allMatch(each -> each.length == 0);
        SolvedLines.Solved solved = plain ? excitation.solved().of(s, () -> invert(s, further)) : invert(s, further);
        stiffness = solved.stiffness();
        inverse = solved.inverse();
        double[] atRest = new double[s.links()];
        Arrays.setAll(atRest, l -> further[l].length == 0 ? 0 : further[l][0]);
        brakes = s.held() || excitation.isUnit() ? Optional.empty() : Brakes.of(excitation, s, atRest, inverse);
    }

    private SolvedLines.Solved invert(Structure s, double[][] further) {
        int n = s.bodies();
        double[][] stiffness = new double[s.links()][2 * lines];
        for (int l = 0; l < s.links(); l++) {
            double[] out = stiffness[l];
            for (int k = 0; k < lines; k++) {
                out[2 * k] = s.stiffness()[l];
                out[2 * k + 1] = omega[k] * s.damping()[l];
            }
            for (int i = 0; i < further[l].length; i++) {
                out[i] += further[l][i];
            }
        }
        double[][] inverse = new double[n * n][];
        for (int i = 0; i < n; i++) {
            for (int j = i; j < n; j++) {
                inverse[i * n + j] = new double[2 * lines];
                inverse[j * n + i] = inverse[i * n + j];
            }
        }
        LineMatrices z = new LineMatrices(n);
        for (int first = 0; first < lines && !s.held(); first += LineMatrices.LINES) {   // a body held at rest answers nothing
            int count = Math.min(LineMatrices.LINES, lines - first);
            fill(s, stiffness, z, first, count);
            z.invert();
            for (int i = 0; i < n; i++) {
                for (int j = i; j < n; j++) {
                    z.get(i, j, inverse[i * n + j], first, count);
                }
            }
        }
        return new SolvedLines.Solved(s, stiffness, inverse);
    }

    /** Whether a part of the structure is held by no spring, and answers from rest. */
    boolean isFree() {
        return brakes.isPresent();
    }

    private void fill(Structure structure, double[][] stiffness, LineMatrices z, int first, int count) {
        z.clear();
        for (int l = 0; l < structure.links(); l++) {
            Row row = structure.stretch(l);
            for (int i = 0; i < row.at().length; i++) {
                for (int j = 0; j <= i; j++) {
                    z.add(row.at()[i], row.at()[j], stiffness[l], row.by()[i] * row.by()[j], first, count);
                }
            }
        }
        for (int i = 0; i < structure.bodies(); i++) {
            for (int k = 0; k < count; k++) {
                z.add(i, k, -omega[first + k] * omega[first + k] * structure.mass()[i]);
            }
        }
    }

    /** Dynamic stiffness of a link as solved. Not a copy. */
    double[] stiffness(int link) {
        return stiffness[link];
    }

    /** Displacements relative to the base under its acceleration alone, as new spectra by body. */
    double[][] motion() {
        int n = structure.bodies();
        double[][] q = new double[n][2 * lines];
        for (int axis = 0; axis < structure.axes(); axis++) {
            for (int j = 0; j < n; j++) {
                double carried = structure.kinematics().carried()[j][axis];
                if (carried != 0) {
                    addBodyForce(j, excitation.base(axis), -structure.mass()[j] * carried, q);
                }
            }
        }
        return q;
    }

    /**
     * Adds to q what a force on a body does; from rest where no spring holds it.
     *
     * @param force spectrum. Not modified.
     * @param q by body. Modified.
     */
    void addBodyForce(int body, double[] force, double factor, double[][] q) {
        if (brakes.isPresent()) {
            brakes.get().addForce(body, force, factor, inverse, q);
        } else {
            addSteady(body, force, factor, q);
        }
    }

    /** Adds to q what a force on a body does line by line, as frequency responses say. */
    void addSteady(int body, double[] force, double factor, double[][] q) {
        int n = structure.bodies();
        for (int i = 0; i < n; i++) {
            Spectra.addProduct(inverse[i * n + body], force, factor, q[i]);
        }
    }

    /**
     * Adds to q what a body does that moves at the first sample.
     *
     * @param velocity [m/s]
     * @param q by body. Modified.
     */
    void addLaunch(int body, double velocity, double[][] q) {
        double[] blow = new double[2 * lines];
        for (int k = 0; k < lines; k++) {
            blow[2 * k] = excitation.rate();   // a unit impulse
        }
        for (int b = 0; b < structure.bodies(); b++) {
            double rigid = brakes.isPresent() ? brakes.get().carried(b, body) : 0;
            double momentum = structure.mass()[body] * velocity * ((b == body ? 1 : 0) - rigid);
            if (momentum != 0) {
                addSteady(b, blow, momentum, q);
            }
        }
        brakes.ifPresent(each -> each.addLaunch(body, structure.mass()[body] * velocity, q));
    }

    /**
     * Adds to q what a force in a link does that pulls its ends together.
     *
     * @param force spectrum. Not modified.
     */
    void addLinkForce(int link, double[] force, double[][] q) {
        Row row = structure.stretch(link);
        for (int i = 0; i < row.at().length; i++) {
            addBodyForce(row.at()[i], force, -row.by()[i], q);
        }
    }

    /**
     * The relative displacement of a link, a new spectrum.
     *
     * @param q by body. Not modified.
     */
    double[] stretch(int link, double[][] q) {
        return structure.stretch(link).of(q, 2 * lines);
    }
}
