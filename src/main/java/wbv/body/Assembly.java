package wbv.body;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import wbv.body.law.Law;
import wbv.body.number.Numbers;

/**
 * Everything a simulation needs beside its input, in numbers: the parameters are those of the structure
 * ({@link Structure#parameters}), then of each law, each drive and each fault, in order.
 * Thesis: Eq. 2-43.
 */
public record Assembly(Structure structure, List<LawAt> laws, List<DriveAt> drives, List<Output> outputs) {

    public Assembly {
        laws = List.copyOf(laws);
        drives = List.copyOf(drives);
        outputs = List.copyOf(outputs);
    }

    /**
     * A drive and where it acts.
     *
     * @param place index of a body for one that {@link Drive#actsOnBody}, of a link for the others
     */
    public record DriveAt(int place, Drive drive) {}

    /** What an output reads. */
    public enum Reading { ACCELERATION, VELOCITY, POSITION, LINK_FORCE }

    /**
     * A sensor.
     *
     * @param place  index of the body (-1 the base), or of the link for a force
     * @param faults in order of effect
     * @param reads  the motions whose sum it reads: its body's alone, or others' beside it, such as an angle by a lever arm
     * @param mount  where it sits on a body that turns; empty where that is not known
     */
    public record Output(int place, Reading reading, List<SensorFault> faults, Row reads, Optional<Plane.Mount> mount) {
        public Output {
            faults = List.copyOf(faults);
        }

        /** What reads a combination of motions, all of them small. */
        public Output(int place, Reading reading, List<SensorFault> faults, Row reads) {
            this(place, reading, faults, reads, Optional.empty());
        }

        /** What reads the motion of its place alone. */
        public Output(int place, Reading reading, List<SensorFault> faults) {
            this(place, reading, faults, Row.of(reading == Reading.LINK_FORCE ? -1 : place));
        }

        /** The same sensor with other faults. */
        public Output with(List<SensorFault> other) {
            return new Output(place, reading, other, reads, mount);
        }

        /** Whether it reads a body's own acceleration and nothing else. */
        public boolean readsAcceleration(int body) {
            return reading == Reading.ACCELERATION && place == body && reads.at().length == 1 && reads.by()[0] == 1;
        }
    }

    /** All parameters, each in its own unit, in the order of the class's text, one for each. A new array. */
    public double[] values() {
        return records().stream().map(Numbers::values)
                .reduce(structure.values(), Assembly::joined);
    }

    /**
     * The same assembly with other parameters.
     *
     * @param values as long as {@link #values}, each in its own unit. Not modified.
     */
    public Assembly with(double[] values) {
        Structure shifted = structure.with(values);
        Cursor cursor = new Cursor(values, structure.parameters());
        List<LawAt> newLaws = laws.stream().map(at -> new LawAt(at.link(), (Law) cursor.next((Record) at.law()))).toList();
        List<DriveAt> newDrives = drives.stream().map(at -> new DriveAt(at.place(), (Drive) cursor.next((Record) at.drive()))).toList();
        List<Output> newOutputs = outputs.stream().map(output -> output.with(
                output.faults().stream().map(fault -> (SensorFault) cursor.next((Record) fault)).toList())).toList();
        return new Assembly(shifted, newLaws, newDrives, newOutputs);
    }

    /** Index of the first parameter of a law. */
    public int lawIndex(int law) {
        return structure.parameters() + laws.subList(0, law).stream().mapToInt(at -> count(at.law())).sum();
    }

    /** Index of the first parameter of a drive. */
    public int driveIndex(int drive) {
        return lawIndex(laws.size()) + drives.subList(0, drive).stream().mapToInt(at -> count(at.drive())).sum();
    }

    /** Index of the first parameter of a fault of an output. */
    public int faultIndex(int output, int fault) {
        int before = outputs.subList(0, output).stream().flatMap(each -> each.faults().stream()).mapToInt(Assembly::count).sum();
        return driveIndex(drives.size()) + before
                + (output == outputs.size() ? 0 : outputs.get(output).faults().subList(0, fault).stream().mapToInt(Assembly::count).sum());
    }

    private static int count(Object record) {
        return Numbers.keys(record.getClass()).size();
    }

    private List<Record> records() {
        List<Record> all = new ArrayList<>();
        laws.forEach(at -> all.add((Record) at.law()));
        drives.forEach(at -> all.add((Record) at.drive()));
        outputs.forEach(output -> output.faults().forEach(fault -> all.add((Record) fault)));
        return all;
    }

    private static double[] joined(double[] a, double[] b) {
        double[] out = java.util.Arrays.copyOf(a, a.length + b.length);
        System.arraycopy(b, 0, out, a.length, b.length);
        return out;
    }

    /** Hands out the numbers one record after the other. */
    private static final class Cursor {
        private final double[] values;
        private int at;

        Cursor(double[] values, int at) {
            this.values = values;
            this.at = at;
        }

        Record next(Record record) {
            int count = Numbers.values(record).length;
            Record out = Numbers.with(record, java.util.Arrays.copyOfRange(values, at, at + count));
            at += count;
            return out;
        }
    }
}
