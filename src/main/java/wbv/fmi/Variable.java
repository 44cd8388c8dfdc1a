package wbv.fmi;

import java.util.OptionalDouble;

/**
 * A scalar variable of a unit.
 *
 * @param name      as declared
 * @param reference by which it is asked for; unsigned
 * @param role      its causality
 * @param tunable   whether its variability is tunable
 * @param real      whether it is a number of 64 bits; others are not touched
 * @param start     value that it starts with, in its own unit, where one is declared
 * @param unit      of its values
 */
public record Variable(String name, int reference, Role role, boolean tunable, boolean real, OptionalDouble start, VariableUnit unit) {

    /** What a variable is for, as far as it matters here. */
    public enum Role { INPUT, OUTPUT, PARAMETER, OTHER }
}
