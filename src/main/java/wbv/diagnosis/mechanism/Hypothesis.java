package wbv.diagnosis.mechanism;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import wbv.body.SensorFault;
import wbv.body.law.Law;
import wbv.body.number.Numbers;

/**
 * A mechanism at a place that the model may lack, as data: what it adds, which numbers it brings, within which bounds, and from
 * where a search for them starts.
 *
 * @param kind      the mechanism
 * @param where     link, body or channel
 * @param form      the law's form where a mechanism has several, empty otherwise
 * @param additions what comes to the model
 * @param numbers   what it brings, in the order of the additions' own numbers
 * @param starts    where to start; the first is what numbers that are found by factors are measured against
 */
public record Hypothesis(Mechanism kind, String where, String form, List<Addition> additions, List<Number> numbers, List<Start> starts) {

    public Hypothesis {
        additions = List.copyOf(additions);
        numbers = List.copyOf(numbers);
        starts = List.copyOf(starts);
    }

    /**
     * A law in a link.
     *
     * @param bounds of the law's numbers, in their order; their keys are the law's
     */
    public static Hypothesis law(Mechanism kind, Scene.Link link, String form, Law law, List<Number> bounds, List<Start> starts) {
        return new Hypothesis(kind, link.name(), form, List.of(new Addition.InLink(link.index(), law)),
                Number.named(law.getClass(), bounds), starts);
    }

    /**
     * A fault of the sensor of an output.
     *
     * @param bounds as of a law
     */
    public static Hypothesis fault(Mechanism kind, Scene scene, int output, SensorFault fault, List<Number> bounds, List<Start> starts) {
        return fault(kind, scene, output, "", fault, bounds, starts);
    }

    /** The same in one of several forms. */
    public static Hypothesis fault(Mechanism kind, Scene scene, int output, String form, SensorFault fault, List<Number> bounds,
            List<Start> starts) {
        return new Hypothesis(kind, scene.outputs().get(output).toString(), form, List.of(new Addition.AtSensor(output, fault)),
                Number.named(fault.getClass(), bounds), starts);
    }

    /**
     * A fault of a device that several outputs read, whose channels have it with the same numbers.
     *
     * @param outputs of the device, as many as faults
     * @param faults of one kind
     * @param factors by fault, of each of its numbers over the first's
     * @param bounds  of the first's numbers
     */
    public static Hypothesis fault(Mechanism kind, Scene scene, List<Integer> outputs, List<SensorFault> faults, List<List<Double>> factors,
            List<Number> bounds, List<Start> starts) {
        List<Addition> additions = new ArrayList<>(List.of(new Addition.AtSensor(outputs.get(0), faults.get(0))));
        for (int i = 1; i < outputs.size(); i++) {
            additions.add(new Addition.Alike(scene.device(outputs.get(0)).get(0), outputs.get(i), faults.get(i), factors.get(i)));
        }
        return new Hypothesis(kind, scene.outputs().get(outputs.get(0)).location(), "", additions,
                Number.named(faults.get(0).getClass(), bounds), starts);
    }

    /**
     * A number.
     *
     * @param unit    of the number: size of one step for an additive number, 0 for one that is found by factors
     * @param low     bound, in the number's unit
     * @param high    bound, likewise
     * @param nothing value, likewise, at which an amplitude does nothing
     */
    public record Number(String key, double unit, double low, double high, double nothing) {

        /** Room of a number that is held, in its unit of steps: none that could be told. */
        private static final double HELD = 1e-6;

        /**
         * Nothing at 0.
         *
         * @param low in the number's unit
         * @param high likewise
         */
        public Number(String key, double unit, double low, double high) {
            this(key, unit, low, high, 0);
        }

        /** Whether it may have a value, in its unit. */
        public boolean mayBe(double value) {
            return low <= value && value <= high;
        }

        /**
         * Found by factors. Named by the law that it belongs to.
         *
         * @param low in the number's unit
         * @param high likewise
         */
        public static Number factor(double low, double high) {
            return new Number("", 0, low, high);
        }

        /**
         * Found by steps. Named by the law that it belongs to.
         *
         * @param low in the number's unit
         * @param high likewise
         */
        public static Number sum(double unit, double low, double high) {
            return new Number("", unit, low, high);
        }

        /**
         * One that a form of a law has not: it is 0. Named by the law that it belongs to.
         *
         * @param unit of the number, &gt; 0
         */
        public static Number none(double unit) {
            return new Number("", unit, 0, HELD * unit);
        }

        /** Whether it has room to move. */
        public boolean isFree() {
            return unit == 0 || high - low > HELD * unit;
        }

        /** The same number of an amplitude that does nothing at another value. */
        public Number about(double nothing) {
            return new Number(key, unit, low, high, nothing);
        }

        /** The same number by another key. */
        public Number named(String name) {
            return new Number(name, unit, low, high, nothing);
        }

        /** The numbers of a record by its keys, with bounds given in order. */
        public static List<Number> named(Class<?> type, List<Number> bounds) {
            List<String> keys = Numbers.keys(type);
            List<Number> out = new ArrayList<>();
            for (int i = 0; i < keys.size(); i++) {
                out.add(bounds.get(i).named(keys.get(i)));
            }
            return out;
        }
    }

    /**
     * Its laws with numbers, where all that it adds are laws in links.
     *
     * @param values one a number, in its unit. Not modified.
     */
    public List<Law> laws(double[] values) {
        List<Law> out = new ArrayList<>();
        double[] own = {};
        int next = 0;
        for (Addition addition : additions) {
            Record law = (Record) ((Addition.OfLink) addition).law();
            boolean alike = addition instanceof Addition.AlikeInLink;
            own = alike ? own : Arrays.copyOfRange(values, next, next + Numbers.values(law).length);
            next += alike ? 0 : own.length;
            out.add((Law) Numbers.with(law, addition instanceof Addition.AlikeInLink other ? other.numbers(own) : own));
        }
        return out;
    }

    /** What its laws choose beside their numbers, by key, see {@link Numbers#choices}. */
    public Map<String, String> choices() {
        Map<String, String> out = new LinkedHashMap<>();
        additions.stream().filter(Addition.OfLink.class::isInstance)
                .forEach(of -> out.putAll(Numbers.choices((Record) ((Addition.OfLink) of).law())));
        return out;
    }

    /** Word of the vocabulary. */
    public String mechanism() {
        return kind.word();
    }

    /** Keys of its numbers, in their order. */
    public List<String> keys() {
        return numbers.stream().map(Number::key).toList();
    }

    /** How many numbers a fit finds. */
    public int free() {
        return (int) numbers.stream().filter(Number::isFree).count();
    }

    /** {@code mechanism@where}, with the form if it has one. */
    public String name() {
        return claim() + (form.isEmpty() ? "" : "[" + form + "]");
    }

    /** {@code mechanism@where}, whatever its form. */
    public String claim() {
        return mechanism() + "@" + where;
    }

    /** Whether naming it needs a free run: a law that is not linear. */
    public boolean runsFree() {
        return additions.stream().anyMatch(Addition::runsFree);
    }

    /** Whether it is a law in a link, linear or not: physics follows its formula only so far. */
    public boolean isLaw() {
        return additions.stream().anyMatch(Addition.InLink.class::isInstance);
    }

    /** Whether it answers some time after what it answers to. */
    public boolean isLate() {
        return additions.stream().anyMatch(Addition::isLate);
    }

    /** Whether it turns the model over rather than adding a little to it, so that no first-order look can see what it does. */
    public boolean overturns() {
        return additions.stream().anyMatch(Addition::overturns);
    }

    /** Whether another at its place says the same more simply, and is preferred where both are about as likely. */
    public boolean yieldsTo(Hypothesis rival) {
        return rival.where.equals(where) && (kind.yieldsTo(rival) || byTheClock() && !rival.byTheClock() && kind.equals(rival.kind));
    }

    /** Whether its numbers mean something by the clock alone: a moment, a rate of change, the phase of a tone. */
    public boolean byTheClock() {
        return additions.stream().anyMatch(Addition::byTheClock);
    }
}
