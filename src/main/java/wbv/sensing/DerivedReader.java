package wbv.sensing;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.Quantity;
import wbv.recording.RowReader;

/**
 * A recording on a uniform clock with channels derived from its own behind them: sensors turned into the axes of the body, free
 * acceleration, points of a rigid segment, joint angles. Memory does not grow with the length, and nothing is allocated for a
 * row.
 */
public final class DerivedReader implements RowReader {

    /** What a row gives to what is derived, and gets from it. */
    private interface Step {
        /** @param row Modified. */
        void apply(double[] row);
    }

    private final RowReader rows;
    private final List<Channel> channels;
    private final List<Step> steps = new ArrayList<>();
    private final Map<String, PlaceAttitude> attitudes = new LinkedHashMap<>();
    private final List<LateLever> levers = new ArrayList<>();
    private final double[][] waiting;
    private final double[] source;
    private long taken;
    private long real;
    private long given;
    private boolean ended;

    /**
     * Derives channels.
     *
     * @param rows  on a uniform clock, from the beginning
     * @param rate  of that clock [Hz]
     * @param worn  how sensors are worn, by place; none to leave them as they are
     * @throws DataFault if a channel is lacking, or would be there twice
     */
    public DerivedReader(RowReader rows, double rate, Derivations wanted, Map<String, StillPose.Worn> worn) {
        this.rows = rows;
        channels = new ArrayList<>(rows.channels());
        source = new double[1 + channels.size()];
        worn.forEach(this::align);
        for (String place : wanted.free()) {
            free(place, rate, wanted.settling());
        }
        wanted.joints().forEach(joint -> join(joint, rate, wanted.settling()));
        wanted.levers().forEach(lever -> levers.add(new LateLever(lever, rate)));
        int delay = levers.isEmpty() ? 0 : levers.get(0).arm.delay();
        waiting = new double[delay + 1][1 + channels.size()];
    }

    /**
     * How every sensor with specific force and angular rate is worn, from a pose held still.
     *
     * @param rows read to the end of the pose
     * @param rate of theirs [Hz]
     */
    public static Map<String, StillPose.Worn> worn(RowReader rows, double rate, Derivations.Still still) throws IOException {
        Map<String, StillPose> poses = new LinkedHashMap<>();
        List<AxisColumns> columns = new ArrayList<>();
        List<Channel> channels = rows.channels();
        for (String place : channels.stream().map(Channel::location).distinct().toList()) {
            if (AxisColumns.in(channels, place, Quantity.SPECIFIC_FORCE)
                    && AxisColumns.in(channels, place, Quantity.ANGULAR_RATE)) {
                poses.put(place, new StillPose(place, rate));
                columns.add(AxisColumns.of(channels, place, Quantity.SPECIFIC_FORCE, ""));
                columns.add(AxisColumns.of(channels, place, Quantity.ANGULAR_RATE, ""));
            }
        }
        if (poses.isEmpty()) {
            throw new DataFault("a still pose needs a place with accg and gyr along x, y and z; the recording has "
                    + channels.stream().map(channel -> channel.location() + '.' + channel.quantity().symbol()).distinct()
                            .toList());
        }
        double[] row = new double[1 + channels.size()];
        double[] specific = new double[3];
        double[] turning = new double[3];
        while (rows.read(row) && row[0] <= still.to()) {
            int i = 0;
            for (StillPose pose : poses.values()) {
                columns.get(i++).take(row, specific);
                columns.get(i++).take(row, turning);
                if (row[0] >= still.from()) {
                    pose.accept(specific, turning);
                }
            }
        }
        Map<String, StillPose.Worn> worn = new LinkedHashMap<>();
        poses.forEach((place, pose) -> worn.put(place, pose.worn()));
        return worn;
    }

    private void align(String place, StillPose.Worn worn) {
        double[] v = new double[3];
        for (Quantity quantity : List.of(Quantity.SPECIFIC_FORCE, Quantity.ACCELERATION, Quantity.ANGULAR_RATE,
                Quantity.MAGNETIC_FIELD)) {
            if (AxisColumns.in(channels, place, quantity)) {
                AxisColumns columns = AxisColumns.of(channels, place, quantity, "");
                boolean biased = quantity == Quantity.ANGULAR_RATE;
                steps.add(row -> {
                    columns.take(row, v);
                    for (int i = 0; i < 3 && biased; i++) {
                        v[i] -= worn.bias()[i];
                    }
                    worn.alignment().outward(v, v);
                    columns.put(row, v);
                });
            }
        }
        if (AxisColumns.in(channels, place, Quantity.QUATERNION)) {
            AxisColumns columns = AxisColumns.of(channels, place, Quantity.QUATERNION, "");
            Orientation back = worn.alignment().inverse();
            Orientation body = new Orientation();
            double[] q = new double[4];
            steps.add(row -> {
                columns.take(row, q);
                if (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] > 0) {
                    body.set(q[0], q[1], q[2], q[3]);
                    body.after(back);
                    q[0] = body.w();
                    q[1] = body.x();
                    q[2] = body.y();
                    q[3] = body.z();
                    columns.put(row, q);
                }
            });
        }
    }

    private PlaceAttitude attitude(String place, double rate, double settling, String why) {
        return attitudes.computeIfAbsent(place, each -> {
            PlaceAttitude made = new PlaceAttitude(channels, place, rate, settling, why);
            steps.add(made::accept);
            return made;
        });
    }

    private void free(String place, double rate, double settling) {
        String why = "the free acceleration of " + place;
        AxisColumns read = AxisColumns.of(channels, place, Quantity.SPECIFIC_FORCE, why);
        PlaceAttitude attitude = attitude(place, rate, settling, why);
        AxisColumns written = add(place, Quantity.ACCELERATION);
        double[] v = new double[3];
        steps.add(row -> {
            read.take(row, v);
            Gravity.removeInWorld(attitude.orientation(), v, v);
            attitude.orientation().inward(v, v);
            if (!attitude.known()) {
                Arrays.fill(v, Double.NaN);
            }
            written.put(row, v);
        });
    }

    private void join(Derivations.Joint joint, double rate, double settling) {
        String why = "the joint " + joint.name();
        PlaceAttitude lower = attitude(joint.lower(), rate, settling, why);
        PlaceAttitude upper = attitude(joint.upper(), rate, settling, why);
        AxisColumns written = add(joint.name(), Quantity.ANGLE);
        double[] angles = new double[3];
        double[] axes = new double[3];
        steps.add(row -> {
            JointAngles.between(lower.orientation(), upper.orientation(), angles);
            boolean known = lower.known() && upper.known();
            axes[0] = known ? angles[1] : Double.NaN;   // lateral about x, flexion about y, axial about z
            axes[1] = known ? angles[0] : Double.NaN;
            axes[2] = known ? angles[2] : Double.NaN;
            written.put(row, axes);
        });
    }

    private AxisColumns add(String place, Quantity quantity) {
        for (char axis : quantity.axes().toCharArray()) {
            Channel channel = new Channel(place, quantity, axis);
            if (channels.contains(channel)) {
                throw new DataFault("the recording has " + channel + " already; choose another name, or leave its column out");
            }
            channels.add(channel);
        }
        return AxisColumns.of(channels, place, quantity, "");
    }

    /** A lever whose result belongs to an earlier row. */
    private final class LateLever {
        private final LeverArm arm;
        private final AxisColumns acceleration;
        private final AxisColumns turning;
        private final AxisColumns written;
        private final double[] a = new double[3];
        private final double[] w = new double[3];

        LateLever(Derivations.Lever lever, double rate) {
            String why = "the point " + lever.name();
            Quantity quantity = AxisColumns.in(channels, lever.place(), Quantity.ACCELERATION) ? Quantity.ACCELERATION
                    : Quantity.SPECIFIC_FORCE;
            arm = new LeverArm(rate, lever.arm().stream().mapToDouble(Double::doubleValue).toArray());
            acceleration = AxisColumns.of(channels, lever.place(), quantity, why);
            turning = AxisColumns.of(channels, lever.place(), Quantity.ANGULAR_RATE, why);
            written = add(lever.name(), quantity);
        }

        /**
         * @param now the newest row. Not modified.
         * @param then the row that the result belongs to. Modified.
         */
        void apply(double[] now, double[] then) {
            acceleration.take(now, a);
            turning.take(now, w);
            arm.accept(a, w, a);
            written.put(then, a);
        }
    }

    @Override
    public List<Channel> channels() {
        return List.copyOf(channels);
    }

    @Override
    public Metadata metadata() {
        return rows.metadata();
    }

    @Override
    public boolean read(double[] row) throws IOException {
        int delay = waiting.length - 1;
        while (taken <= given + delay && (!ended || given < real)) {
            push();
        }
        if (given == real) {
            return false;
        }
        System.arraycopy(waiting[(int) (given % waiting.length)], 0, row, 0, row.length);
        given++;
        return true;
    }

    /** Takes the next row, or after the last one an empty one, which brings out what is late. */
    private void push() throws IOException {
        double[] now = waiting[(int) (taken % waiting.length)];
        ended = ended || !rows.read(source);
        Arrays.fill(now, Double.NaN);
        if (!ended) {
            System.arraycopy(source, 0, now, 0, source.length);
            for (int i = 0; i < steps.size(); i++) {
                steps.get(i).apply(now);
            }
            real++;
        }
        // What a lever gives belongs to the oldest row that waits.
        double[] then = waiting[(int) ((taken + 1) % waiting.length)];
        for (int i = 0; i < levers.size(); i++) {
            levers.get(i).apply(now, then);
        }
        taken++;
    }

    @Override
    public long line() {
        return rows.line();
    }

    @Override
    public double fractionRead() {
        return rows.fractionRead();
    }

    @Override
    public void close() throws IOException {
        rows.close();
    }
}
