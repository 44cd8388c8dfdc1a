package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.LawAt;
import wbv.body.Model;
import wbv.body.Structure;
import wbv.body.law.Law;
import wbv.body.number.Modulator;
import wbv.body.number.Numbers;
import wbv.diagnosis.algebra.DampedEquations;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.fit.Normal;
import wbv.diagnosis.fit.Slot;

/**
 * The factor that all masses, and with them stiffness, damping and every force, have in common. Motion alone does not show it; what shows
 * it is that the user knows each mass, to about a tenth where nothing else is said. A fit holds the heaviest mass as given; here the factor
 * is estimated from all of them, each weighed by how well the fit knows its ratio, so that one mass that was given wrongly does not set the
 * scale of every force.
 *
 * @param factor    on what a fit with the heaviest mass held gives
 * @param deviation its relative standard deviation; 0 where forces were measured
 */
public record MassScale(double factor, double deviation) {

    /** All masses as the fit has them. */
    public static final MassScale NONE = new MassScale(1, 0);

    /**
     * The factor that a fit leaves open; 1 exactly where a force is measured, and where the model came with laws or drives, whose
     * forces are in newtons.
     *
     * @param state with slopes. Not modified.
     */
    public static MassScale of(Evidence evidence, Fitter.State state) {
        Assembly template = state.candidate().template();
        boolean kinematic = template.outputs().stream().allMatch(o -> o.reading() != Assembly.Reading.LINK_FORCE);
        Assembly users = evidence.model().assembly();
        // A law that came with the model has forces in newtons, which set the scale.
        if (!kinematic || !users.laws().isEmpty() || !users.drives().isEmpty()) {
            return NONE;
        }
        double[][] curvature = new Normal(state).curvature();
        int n = state.x().length;
        int bodies = evidence.model().bodies().size();
        double[][] a = new double[n + 1][];
        double[] b = new double[n + 1];
        double[] precision = evidence.model().bodies().stream().mapToDouble(MassScale::precision).toArray();
        for (int i = 0; i < n; i++) {
            a[i] = Arrays.copyOf(curvature[i], n + 1);
        }
        a[n] = new double[n + 1];
        a[n][n] = Arrays.stream(precision).sum();
        List<Integer> masses = new ArrayList<>();
        for (int i = 0; i < n; i++) {
            Knob knob = state.candidate().knobs().get(i);
            if (knob.slot().kind() == Slot.Kind.MASS && knob.slot().at() < bodies) {
                double own = precision[knob.slot().at()];
                double before = 1 / (knob.deviation() * knob.deviation());
                a[i][i] += own - before;
                a[i][n] = own;
                a[n][i] = own;
                b[i] = (before - own) * state.x()[i];
                b[n] -= own * state.x()[i];
                masses.add(i);
            }
        }
        boolean[] held = Arrays.copyOf(state.held(), n + 1);
        double[] best = DampedEquations.solve(a, b, held, 0);
        double[] unit = new double[n + 1];
        unit[n] = 1;
        double variance = DampedEquations.solve(a, unit, held, 0)[n];
        // Masses that contradict each other more than their user should tell that they are less well known (Birge 1932).
        double[] off = new double[bodies];
        Arrays.fill(off, best[n]);
        masses.forEach(i -> off[state.candidate().knobs().get(i).slot().at()] += state.x()[i] + best[i]);
        double scatter = IntStream.range(0, bodies).mapToDouble(body -> precision[body] * off[body] * off[body]).sum();
        double ratio = masses.isEmpty() ? 1 : Math.max(1, scatter / masses.size());
        return new MassScale(Math.exp(best[n]), Math.sqrt(variance * ratio));
    }

    /** Of the logarithm of a mass that the model gives [1]; 0 where it plays no part or is another's too. */
    private static double precision(Model.Body body) {
        double deviation = body.within().orElse(2 * Priors.MASS) / 2;
        return body.fixed() || body.massOf().isPresent() ? 0 : 1 / (deviation * deviation);
    }

    /** Whether a number, by its key, has the unit of a force or a mass in it. */
    public static boolean scales(String key) {
        return key.contains("_N") || key.contains("_kg");
    }

    /** The same fit at this scale: what it simulates is the same. */
    public Fitter.State applied(Fitter.State state) {
        Candidate old = state.candidate();
        Assembly template = applied(old.template());
        List<Knob> knobs = old.knobs().stream().map(knob -> scales(knob, old.template()) ? knob.scaled(factor) : knob).toList();
        return new Fitter.State(new Candidate(template, knobs, old.added(), old.freeWays()), state.x(), state.cost(), state.square(),
                state.raw(), state.errors(), state.slopes(), state.frame());
    }

    private boolean scales(Knob knob, Assembly assembly) {
        Slot slot = knob.slot();
        return switch (slot.kind()) {
            case STIFFNESS, DAMPING, MASS -> true;
            case LAW -> !relative(assembly.laws().get(slot.at()).law())
                    && scales(Numbers.keys(assembly.laws().get(slot.at()).law().getClass()).get(slot.component()));
            case DRIVE -> scales(Numbers.keys(assembly.drives().get(slot.at()).drive().getClass()).get(slot.component()));
            case FAULT -> false;
        };
    }

    /** Whether a law is a part of another force, which scales by itself. */
    private static boolean relative(Law law) {
        return law.modulator().otherLink().filter(other -> other.of() == Modulator.Of.LOAD).isPresent();
    }

    private Assembly applied(Assembly assembly) {
        Structure s = assembly.structure();
        double[] values = s.values();
        for (int i = 0; i < values.length; i++) {
            values[i] *= factor;
        }
        return new Assembly(s.with(values),
                assembly.laws().stream().map(at -> relative(at.law()) ? at : new LawAt(at.link(), (Law) applied((Record) at.law())))
                        .toList(),
                assembly.drives().stream().map(at -> new Assembly.DriveAt(at.place(), (Drive) applied((Record) at.drive())))
                        .toList(),
                assembly.outputs());
    }

    private Record applied(Record numbers) {
        List<String> keys = Numbers.keys(numbers.getClass());
        double[] values = Numbers.values(numbers);
        for (int i = 0; i < values.length; i++) {
            values[i] *= scales(keys.get(i)) ? factor : 1;
        }
        return Numbers.with(numbers, values);
    }
}
