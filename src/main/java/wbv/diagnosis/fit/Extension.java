package wbv.diagnosis.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import wbv.body.Assembly;
import wbv.body.LawAt;
import wbv.body.SensorFault;
import wbv.body.Structure;
import wbv.body.number.Numbers;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis;

/** A template and its knobs after an addition. */
record Extension(Assembly template, List<Knob> knobs) {

    /** What a template and its knobs become with what a hypothesis adds. */
    static Extension of(Assembly template, List<Knob> knobs, Hypothesis hypothesis) {
        Assembly assembly = template;
        List<Knob> all = new ArrayList<>(knobs);
        int next = 0;
        for (Addition addition : hypothesis.additions()) {
            if (addition instanceof Addition.OfLink of) {
                List<LawAt> laws = new ArrayList<>(assembly.laws());
                laws.add(new LawAt(of.link(), of.law()));
                assembly = new Assembly(assembly.structure(), laws, assembly.drives(), assembly.outputs());
                if (of instanceof Addition.AlikeInLink alike) {
                    tie(all, Slot.Kind.LAW, laws.size() - 1, 0, alike.factors());
                } else {
                    next = add(all, hypothesis, next, Slot.Kind.LAW, laws.size() - 1, 0, Numbers.values((Record) of.law()).length);
                }
            } else if (addition instanceof Addition.Driven driven) {
                List<Assembly.DriveAt> drives = new ArrayList<>(assembly.drives());
                drives.add(new Assembly.DriveAt(driven.place(), driven.drive()));
                assembly = new Assembly(assembly.structure(), assembly.laws(), drives, assembly.outputs());
                next = add(all, hypothesis, next, Slot.Kind.DRIVE, drives.size() - 1, 0, Numbers.values((Record) driven.drive()).length);
            } else if (addition instanceof Addition.OfSensor of) {
                List<Assembly.Output> outputs = new ArrayList<>(assembly.outputs());
                Assembly.Output output = outputs.get(of.output());
                List<SensorFault> faults = new ArrayList<>(output.faults());
                faults.add(of.fault());
                outputs.set(of.output(), output.with(faults));
                assembly = new Assembly(assembly.structure(), assembly.laws(), assembly.drives(), outputs);
                if (of instanceof Addition.Alike alike) {
                    tie(all, Slot.Kind.FAULT, of.output(), faults.size() - 1, alike.factors());
                } else {
                    next = add(all, hypothesis, next, Slot.Kind.FAULT, of.output(), faults.size() - 1,
                            Numbers.values((Record) of.fault()).length);
                }
            } else {
                assembly = hide(assembly, (Addition.Hidden) addition);
                Structure s = assembly.structure();
                all.add(knob(hypothesis, next++, Slot.of(Slot.Kind.MASS, s.bodies() - 1)));
                all.add(knob(hypothesis, next++, Slot.of(Slot.Kind.STIFFNESS, s.links() - 1)));
                all.add(knob(hypothesis, next++, Slot.of(Slot.Kind.DAMPING, s.links() - 1)));
                if (((Addition.Hidden) addition).mode().stiffening().isPresent()) {
                    all.add(knob(hypothesis, next++, Slot.of(Slot.Kind.LAW, assembly.laws().size() - 1, 0)));
                }
            }
        }
        return new Extension(assembly, all);
    }

    private static Assembly hide(Assembly assembly, Addition.Hidden hidden) {
        Structure s = assembly.structure();
        int n = s.bodies();
        Structure larger = new Structure(append(s.from(), hidden.body()), append(s.to(), n),
                append(s.stiffness(), hidden.mode().stiffness()), append(s.damping(), hidden.mode().damping()),
                append(s.mass(), hidden.mode().mass()), s.held(), s.kinematics().riding(hidden.body()));
        List<LawAt> laws = new ArrayList<>(assembly.laws());
        hidden.mode().stiffening().ifPresent(law -> laws.add(new LawAt(s.links(), law)));
        return new Assembly(larger, laws, assembly.drives(), assembly.outputs());
    }

    private static int add(List<Knob> all, Hypothesis hypothesis, int next, Slot.Kind kind, int at, int fault, int count) {
        for (int c = 0; c < count; c++) {
            all.add(knob(hypothesis, next + c, new Slot(kind, at, fault, c)));
        }
        return next + count;
    }

    /** Lets the last knobs, which are those of the first that is alike, move another's numbers too. */
    private static void tie(List<Knob> all, Slot.Kind kind, int at, int fault, List<Double> factors) {
        int first = all.size() - factors.size();
        for (int c = 0; c < factors.size(); c++) {
            all.set(first + c, all.get(first + c).tied(new Slot(kind, at, fault, c), factors.get(c)));
        }
    }

    private static Knob knob(Hypothesis hypothesis, int i, Slot slot) {
        Hypothesis.Number number = hypothesis.numbers().get(i);
        String name = hypothesis.where() + " " + number.key();
        double reference = hypothesis.starts().get(0).values()[i];
        return number.unit() == 0 ? Knob.factor(name, slot, reference, number.low(), number.high(), Double.POSITIVE_INFINITY)
                : Knob.sum(name, slot, 0, number.unit(), number.low(), number.high(), Double.POSITIVE_INFINITY);
    }

    private static int[] append(int[] array, int value) {
        int[] out = Arrays.copyOf(array, array.length + 1);
        out[array.length] = value;
        return out;
    }

    private static double[] append(double[] array, double value) {
        double[] out = Arrays.copyOf(array, array.length + 1);
        out[array.length] = value;
        return out;
    }
}
