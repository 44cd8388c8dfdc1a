package wbv.rig;

import org.apache.commons.math3.random.RandomGenerator;

/** Packets lost in bursts: a chain of two states, heard and lost (Gilbert 1960). */
final class PacketLoss {

    private final double begin;
    private final double end;
    private final RandomGenerator random;
    private boolean lost;

    /**
     * @param share of packets lost, 0 to less than 1
     * @param burst mean number lost in a row, &gt;= 1
     */
    PacketLoss(double share, double burst, RandomGenerator random) {
        this.end = 1 / burst;
        this.begin = share / (burst * (1 - share));
        this.random = random;
    }

    /** Whether the next packet is lost. */
    boolean next() {
        double draw = random.nextDouble();
        lost = lost ? draw >= end : draw < begin;
        return lost;
    }
}
