package wbv.diagnosis.fit;

import wbv.body.Assembly;

/**
 * Where a number stands in an assembly, whatever else the assembly holds.
 *
 * @param at        link, body, law, drive or output
 * @param fault     which fault of the output; 0 for all other kinds
 * @param component which number of the law, drive or fault; 0 for the structure's own
 */
public record Slot(Kind kind, int at, int fault, int component) {

    /** What the number belongs to. */
    public enum Kind { STIFFNESS, DAMPING, MASS, LAW, DRIVE, FAULT }

    /** Of the structure itself. */
    public static Slot of(Kind kind, int at) {
        return new Slot(kind, at, 0, 0);
    }

    /** Of a law or a drive. */
    public static Slot of(Kind kind, int at, int component) {
        return new Slot(kind, at, 0, component);
    }

    /** Index in {@link Assembly#values}. */
    int index(Assembly assembly) {
        int links = assembly.structure().links();
        return switch (kind) {
            case STIFFNESS -> at;
            case DAMPING -> links + at;
            case MASS -> 2 * links + at;
            case LAW -> assembly.lawIndex(at) + component;
            case DRIVE -> assembly.driveIndex(at) + component;
            case FAULT -> assembly.faultIndex(at, fault) + component;
        };
    }
}
