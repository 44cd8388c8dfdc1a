package wbv.diagnosis;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.EngagingFriction;
import wbv.body.Law;
import wbv.body.LawAt;
import wbv.body.Learned;
import wbv.body.Model;
import wbv.body.Numbers;
import wbv.body.SensorFault;
import wbv.body.Settling;
import wbv.body.SlowDrift;
import wbv.body.StepChange;
import wbv.body.Structure;

/**
 * A mechanism at a place that the model may lack, as data: what it adds, which numbers it brings, within which bounds, and from
 * where a search for them starts.
 *
 * @param mechanism word of the vocabulary
 * @param where     link, body or channel
 * @param form      the law's form where a mechanism has several, empty otherwise
 * @param additions what comes to the model
 * @param numbers   what it brings, in the order of the additions' own numbers
 * @param starts    where to start
 */
record Hypothesis(String mechanism, String where, String form, List<Addition> additions, List<Number> numbers, List<Start> starts) {

    Hypothesis {
        additions = List.copyOf(additions);
        numbers = List.copyOf(numbers);
        starts = List.copyOf(starts);
    }

    /** What a hypothesis adds. */
    sealed interface Addition {
        record InLink(int link, Law law) implements Addition { }

        record Driven(int place, Drive drive) implements Addition { }

        record AtSensor(int output, SensorFault fault) implements Addition { }

        /** A hidden mass on a body; its numbers are mass, stiffness and damping. */
        record Hidden(int body, Model.HiddenMode mode) implements Addition { }
    }

    /** A number. @param unit size of one step for an additive number, 0 for one that is found by factors @param low @param high bounds */
    record Number(String key, double unit, double low, double high) { }

    /**
     * A place to start from.
     *
     * @param values  by number
     * @param columns groups of numbers that scale together with the strength of the effect, to first order; none where the effect has
     *                no linear amplitude
     */
    record Start(double[] values, List<int[]> columns) {

        /** One amplitude. */
        static Start scaled(double value) {
            return new Start(new double[] {value}, List.of(new int[] {0}));
        }
    }

    /** A template and its knobs after an addition. */
    record Extension(Assembly template, List<Knob> knobs) { }

    /** {@code mechanism@where}, with the form if it has one. */
    String name() {
        return mechanism + "@" + where + (form.isEmpty() ? "" : "[" + form + "]");
    }

    /** Whether naming it needs a free run: a law that is not linear. */
    boolean runsFree() {
        return additions.stream().anyMatch(a -> a instanceof Addition.InLink in && !in.law().isLinear());
    }

    /** Whether it is a law in a link, linear or not: physics follows its formula only so far. */
    boolean isLaw() {
        return additions.stream().anyMatch(a -> a instanceof Addition.InLink);
    }

    /** Whether it turns the model over rather than adding a little to it, so that no first-order look can see what it does. */
    boolean overturns() {
        return additions.stream().anyMatch(a -> a instanceof Addition.AtSensor at && at.fault() instanceof SensorFault.Rectifying
                || a instanceof Addition.InLink in && in.law() instanceof EngagingFriction);
    }

    /** Whether its numbers mean something by the clock alone: a moment, a rate of change, the phase of a tone. */
    boolean byTheClock() {
        return additions.stream().anyMatch(a -> a instanceof Addition.InLink in && byTheClock(in.law())
                || a instanceof Addition.Driven driven && byTheClock(driven.drive())
                || a instanceof Addition.AtSensor at && byTheClock(at.fault()));
    }

    /** The same of what a model has already. */
    static boolean byTheClock(Assembly assembly) {
        return assembly.laws().stream().anyMatch(at -> byTheClock(at.law())) || assembly.drives().stream().anyMatch(at -> byTheClock(at.drive()))
                || assembly.outputs().stream().flatMap(output -> output.faults().stream()).anyMatch(Hypothesis::byTheClock);
    }

    private static boolean byTheClock(Object physics) {
        return physics instanceof Learned law && law.byTheClock() || physics instanceof StepChange || physics instanceof SlowDrift || physics instanceof Settling || physics instanceof Drive.Tone
                || physics instanceof SensorFault.Delay delay && delay.drift() != 0;
    }

    /** Whether it blames a sensor. */
    boolean blamesSensor() {
        return additions.stream().anyMatch(a -> a instanceof Addition.AtSensor);
    }

    /** The template and knobs with what this adds. */
    Extension extend(Assembly template, List<Knob> knobs) {
        Assembly assembly = template;
        List<Knob> all = new ArrayList<>(knobs);
        int next = 0;
        for (Addition addition : additions) {
            if (addition instanceof Addition.InLink in) {
                List<LawAt> laws = new ArrayList<>(assembly.laws());
                laws.add(new LawAt(in.link(), in.law()));
                assembly = new Assembly(assembly.structure(), laws, assembly.drives(), assembly.outputs());
                next = add(all, next, Slot.Kind.LAW, laws.size() - 1, 0, Numbers.values((Record) in.law()).length);
            } else if (addition instanceof Addition.Driven driven) {
                List<Assembly.DriveAt> drives = new ArrayList<>(assembly.drives());
                drives.add(new Assembly.DriveAt(driven.place(), driven.drive()));
                assembly = new Assembly(assembly.structure(), assembly.laws(), drives, assembly.outputs());
                next = add(all, next, Slot.Kind.DRIVE, drives.size() - 1, 0, Numbers.values((Record) driven.drive()).length);
            } else if (addition instanceof Addition.AtSensor at) {
                List<Assembly.Output> outputs = new ArrayList<>(assembly.outputs());
                Assembly.Output output = outputs.get(at.output());
                List<SensorFault> faults = new ArrayList<>(output.faults());
                faults.add(at.fault());
                outputs.set(at.output(), new Assembly.Output(output.place(), output.reading(), faults));
                assembly = new Assembly(assembly.structure(), assembly.laws(), assembly.drives(), outputs);
                next = add(all, next, Slot.Kind.FAULT, at.output(), faults.size() - 1, Numbers.values((Record) at.fault()).length);
            } else {
                assembly = hide(assembly, (Addition.Hidden) addition);
                Structure s = assembly.structure();
                all.add(knob(next++, Slot.of(Slot.Kind.MASS, s.bodies() - 1)));
                all.add(knob(next++, Slot.of(Slot.Kind.STIFFNESS, s.links() - 1)));
                all.add(knob(next++, Slot.of(Slot.Kind.DAMPING, s.links() - 1)));
            }
        }
        return new Extension(assembly, all);
    }

    private static Assembly hide(Assembly assembly, Addition.Hidden hidden) {
        Structure s = assembly.structure();
        int n = s.bodies();
        Structure larger = new Structure(append(s.from(), hidden.body()), append(s.to(), n),
                append(s.stiffness(), hidden.mode().stiffness()), append(s.damping(), hidden.mode().damping()),
                append(s.mass(), hidden.mode().mass()));
        return new Assembly(larger, assembly.laws(), assembly.drives(), assembly.outputs());
    }

    private int add(List<Knob> all, int next, Slot.Kind kind, int at, int fault, int count) {
        for (int c = 0; c < count; c++) {
            all.add(knob(next + c, new Slot(kind, at, fault, c)));
        }
        return next + count;
    }

    private Knob knob(int i, Slot slot) {
        Number number = numbers.get(i);
        String name = where + " " + number.key();
        double reference = starts.get(0).values()[i];
        return number.unit() == 0 ? Knob.factor(name, slot, reference, number.low(), number.high(), Double.POSITIVE_INFINITY)
                : Knob.sum(name, slot, 0, number.unit(), number.low(), number.high(), Double.POSITIVE_INFINITY);
    }

    /** Positions of this hypothesis' numbers among the knobs of a candidate that contains it. */
    int[] positions(Candidate candidate) {
        int from = candidate.knobs().size();
        for (int i = candidate.added().size() - 1; i >= 0; i--) {
            Hypothesis each = candidate.added().get(i);
            from -= each.numbers().size();
            if (each == this) {
                break;
            }
        }
        int first = from;
        return IntStream.range(0, numbers.size()).map(i -> first + i).toArray();
    }

    private static int[] append(int[] array, int value) {
        int[] out = java.util.Arrays.copyOf(array, array.length + 1);
        out[array.length] = value;
        return out;
    }

    private static double[] append(double[] array, double value) {
        double[] out = java.util.Arrays.copyOf(array, array.length + 1);
        out[array.length] = value;
        return out;
    }
}
