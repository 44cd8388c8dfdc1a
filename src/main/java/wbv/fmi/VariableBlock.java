package wbv.fmi;

import com.sun.jna.Memory;
import java.util.List;

/** References of some variables with room for their values, outside of Java's heap, so that no call copies or allocates. */
final class VariableBlock {

    final Memory references;
    final Memory values;
    final int size;

    VariableBlock(int[] references) {
        size = references.length;
        this.references = new Memory(Math.max(1, size) * (long) Integer.BYTES);
        this.references.write(0, references, 0, size);
        values = doubles(size);
    }

    static VariableBlock of(List<Variable> variables) {
        return new VariableBlock(variables.stream().mapToInt(Variable::reference).toArray());
    }

    /** Room for so many numbers, which are 0. */
    static Memory doubles(int size) {
        Memory room = new Memory(Math.max(1, size) * (long) Double.BYTES);
        room.clear();
        return room;
    }

    void write(double[] from) {
        values.write(0, from, 0, size);
    }

    void read(double[] into) {
        values.read(0, into, 0, size);
    }
}
