package wbv.recording.inspect;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToDoubleFunction;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.Unit;

/** Looks at all channels of one location: rows of zeros, and whether their standing values make sense. */
final class LocationLook {

    private static final double GRAVITY = Unit.STANDARD_GRAVITY;
    /** Units of acceleration in which numbers are greater than in m/s². */
    private static final List<String> FINER = List.of("mm/s²", "cm/s²", "mg");
    /** No sensor of people or of what they sit on is shaken harder, root mean square [m/s²]. */
    private static final double MOST_SHAKEN = 100;

    private final String location;
    private final List<Channel> channels = new ArrayList<>();
    private final List<Integer> indices = new ArrayList<>();
    private int[] columns = {};
    private long zeros;
    private long zeroLine;
    private long rows;
    private boolean moved;
    private boolean zeroAfterMotion;

    LocationLook(String location) {
        this.location = location;
    }

    /**
     * Adds a channel.
     *
     * @param index its place among all channels
     */
    void add(Channel channel, int index) {
        channels.add(channel);
        indices.add(index);
        columns = indices.stream().mapToInt(Integer::intValue).toArray();
    }

    void accept(double[] row, long line) {
        rows++;
        for (int column : columns) {
            if (row[1 + column] != 0) {
                moved = true;
                return;
            }
        }
        zeroLine = zeros == 0 ? line : zeroLine;
        zeros++;
        zeroAfterMotion |= moved;
    }

    String location() {
        return location;
    }

    /** Rows of zeros that stand out from others; 0 where all are zero, since then each channel has to say so. */
    long zeroRows() {
        return zeros < rows ? zeros : 0;
    }

    /**
     * What is wrong with the location.
     *
     * @param median of a channel
     * @param rms of a channel about its mean
     */
    List<Finding> findings(ToDoubleFunction<Channel> median, ToDoubleFunction<Channel> rms) {
        List<Finding> findings = new ArrayList<>();
        if (zeros > 0 && channels.size() > 1 && zeros < rows) {
            findings.add(new Finding.ZeroRows(location, zeros, zeroLine, !zeroAfterMotion));
        }
        acceleration(findings, vector(Quantity.ACCELERATION, median), greatest(Quantity.ACCELERATION, rms));
        specificForce(findings, vector(Quantity.SPECIFIC_FORCE, median), greatest(Quantity.SPECIFIC_FORCE, rms));
        angularRate(findings, vector(Quantity.ANGULAR_RATE, median), greatest(Quantity.ANGULAR_RATE, rms));
        return findings;
    }

    private void acceleration(List<Finding> findings, double[] standing, double rms) {
        double size = size(standing);
        if (showsGravityFinely(size) && rms < 5000 || rms > 300) {
            findings.add(unit(Quantity.ACCELERATION, Math.max(size, rms), finer(size, rms)));
        } else if (near(size, GRAVITY, 0.15)) {
            findings.add(new Finding.GravityLeftIn(location, size));
        } else if (near(size, 1, 0.05) && rms < 1) {
            findings.add(unit(Quantity.ACCELERATION, size, "g read as m/s²"));
        } else if (size > 2) {
            findings.add(bias(Quantity.ACCELERATION, standing));
        }
    }

    private void specificForce(List<Finding> findings, double[] standing, double rms) {
        boolean whole = !Double.isNaN(standing[0] + standing[1] + standing[2]);
        double size = size(standing);
        if (showsGravityFinely(size)) {
            findings.add(unit(Quantity.SPECIFIC_FORCE, size, finer(size, rms)));
        } else if (whole && near(size, 1, 0.15) && rms < 2) {
            findings.add(unit(Quantity.SPECIFIC_FORCE, size, "g read as m/s²"));
        } else if (whole && size < 2) {
            findings.add(new Finding.GravityMissing(location, size));
        } else if (size > 1.25 * GRAVITY || whole && size < 0.75 * GRAVITY) {
            findings.add(bias(Quantity.SPECIFIC_FORCE, standing));
        }
    }

    private static boolean showsGravityFinely(double size) {
        return FINER.stream().anyMatch(unit -> near(si(unit, size), GRAVITY, 0.15));
    }

    private static double si(String unit, double value) {
        return Unit.of(unit).orElseThrow().toSi(value);
    }

    /**
     * The finer units in which it would be: those that make gravity of what stands, if any do, nearest first; else all of which the motion
     * may be.
     */
    private static String finer(double size, double rms) {
        List<String> moving = FINER.stream().filter(unit -> !(si(unit, rms) > MOST_SHAKEN)).toList();
        List<String> standing = moving.stream().filter(unit -> near(si(unit, size), GRAVITY, 0.15))
                .sorted(Comparator.comparingDouble(unit -> Math.abs(si(unit, size) / GRAVITY - 1))).toList();
        List<String> may = standing.isEmpty() ? moving : standing;
        String last = may.isEmpty() ? "counts of a sensor" : may.get(may.size() - 1);
        return (may.size() < 2 ? "" : String.join(", ", may.subList(0, may.size() - 1)) + " or ") + last + " read as m/s²";
    }

    private void angularRate(List<Finding> findings, double[] standing, double rms) {
        if (rms > 12) {
            findings.add(unit(Quantity.ANGULAR_RATE, rms, "deg/s read as rad/s"));
        } else if (size(standing) > 1) {
            findings.add(bias(Quantity.ANGULAR_RATE, standing));
        }
    }

    private Finding unit(Quantity quantity, double value, String likely) {
        return new Finding.ImplausibleUnit(location, quantity, value, quantity.unit(), likely);
    }

    private Finding bias(Quantity quantity, double[] standing) {
        return new Finding.GrossBias(location, quantity, standing[0], standing[1], standing[2], size(standing));
    }

    private double[] vector(Quantity quantity, ToDoubleFunction<Channel> of) {
        double[] vector = {Double.NaN, Double.NaN, Double.NaN};
        for (Channel channel : channels) {
            if (channel.quantity() == quantity) {
                vector["xyz".indexOf(channel.axis())] = of.applyAsDouble(channel);
            }
        }
        return vector;
    }

    private double greatest(Quantity quantity, ToDoubleFunction<Channel> of) {
        double greatest = 0;
        for (double value : vector(quantity, of)) {
            greatest = value > greatest ? value : greatest;
        }
        return greatest;
    }

    /** Length of a vector, axes that are not there left out; 0 where none is. */
    private static double size(double[] vector) {
        double sum = 0;
        for (double value : vector) {
            sum += Double.isNaN(value) ? 0 : value * value;
        }
        return Math.sqrt(sum);
    }

    private static boolean near(double size, double target, double share) {
        return Math.abs(size / target - 1) <= share;
    }
}
