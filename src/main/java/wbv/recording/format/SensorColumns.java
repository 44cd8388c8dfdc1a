package wbv.recording.format;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.Unit;

/**
 * The columns of an Xsens or Movella export of one sensor, by the names that MT Manager and the DOT application give them.
 * Raw slot 0 is the counter, the channels follow, then the nine entries of a rotation matrix where the export has one.
 *
 * <p>{@code Acc_*} contains gravity, {@code FreeAcc_*} does not; angles are in degrees. Velocity and orientation increments
 * are left out.
 *
 * @param channels what a row holds
 * @param units    of each channel
 * @param slots    raw slot of each column
 * @param matrix   raw slot of the rotation matrix' first entry, column by column; 0 if there is none
 */
record SensorColumns(List<Channel> channels, List<Unit> units, int[] slots, int matrix) {

    private static final Pattern VECTOR = Pattern.compile("(FreeAcc|Acc|Gyr|Mag|Euler)_([XYZ])");
    private static final Pattern QUATERNION = Pattern.compile("Quat_(?:q([0-3])|([wxyzWXYZ]))");
    private static final Pattern MATRIX = Pattern.compile("Mat\\[([1-3])\\]\\[([1-3])\\]");
    private static final List<String> ANGLES = List.of("Roll", "Pitch", "Yaw");

    /**
     * @param counter   the column of the counter or clock
     * @param gyroscope unit of the angular rates
     */
    static SensorColumns of(List<String> names, String counter, String location, String gyroscope) {
        Map<Channel, Integer> columns = new LinkedHashMap<>();
        List<Unit> units = new ArrayList<>();
        int[] slots = new int[names.size()];
        Arrays.fill(slots, DelimitedTable.SKIP);
        boolean quaternion = names.stream().anyMatch(name -> QUATERNION.matcher(name).matches());
        for (int i = 0; i < slots.length; i++) {
            String name = names.get(i);
            Matcher vector = VECTOR.matcher(name);
            Matcher part = QUATERNION.matcher(name);
            if (name.equals(counter)) {
                slots[i] = 0;
            } else if (vector.matches()) {
                Quantity quantity = quantity(vector.group(1));
                columns.put(new Channel(location, quantity, Character.toLowerCase(vector.group(2).charAt(0))), i);
                units.add(unit(quantity, gyroscope));
            } else if (part.matches()) {
                char axis = part.group(1) != null ? "wxyz".charAt(part.group(1).charAt(0) - '0')
                        : Character.toLowerCase(part.group(2).charAt(0));
                columns.put(new Channel(location, Quantity.QUATERNION, axis), i);
                units.add(unit(Quantity.QUATERNION, gyroscope));
            } else if (ANGLES.contains(name)) {
                columns.put(new Channel(location, Quantity.ANGLE, "xyz".charAt(ANGLES.indexOf(name))), i);
                units.add(unit(Quantity.ANGLE, gyroscope));
            }
            slots[i] = columns.containsValue(i) ? columns.size() : slots[i];
        }
        int matrix = quaternion || !names.contains("Mat[1][1]") ? 0 : columns.size() + 1;
        List<Channel> channels = new ArrayList<>(columns.keySet());
        if (matrix > 0) {
            matrixSlots(names, slots, matrix);
            for (char axis : Quantity.QUATERNION.axes().toCharArray()) {
                channels.add(new Channel(location, Quantity.QUATERNION, axis));
            }
        }
        return new SensorColumns(channels, units, slots, matrix);
    }

    private static void matrixSlots(List<String> names, int[] slots, int first) {
        for (int i = 0; i < slots.length; i++) {
            Matcher entry = MATRIX.matcher(names.get(i));
            if (entry.matches()) {
                slots[i] = first + 3 * (entry.group(2).charAt(0) - '1') + entry.group(1).charAt(0) - '1';
            }
        }
    }

    private static Quantity quantity(String word) {
        return switch (word) {
            case "FreeAcc" -> Quantity.ACCELERATION;
            case "Acc" -> Quantity.SPECIFIC_FORCE;
            case "Gyr" -> Quantity.ANGULAR_RATE;
            case "Mag" -> Quantity.MAGNETIC_FIELD;
            default -> Quantity.ANGLE;
        };
    }

    private static Unit unit(Quantity quantity, String gyroscope) {
        String symbol = quantity == Quantity.ANGULAR_RATE ? gyroscope : quantity == Quantity.ANGLE ? "deg" : quantity.unit();
        return Unit.of(symbol).orElseThrow();
    }

    /** What the file says, and in which axes free acceleration is. */
    Map<String, String> notes(Map<String, String> file) {
        Map<String, String> notes = new LinkedHashMap<>(file);
        if (channels.stream().anyMatch(channel -> channel.quantity() == Quantity.ACCELERATION)) {
            notes.put("acc", "free acceleration, in the axes of the earth, not of the sensor");
        }
        return notes;
    }

    /** Length of a raw row. */
    int width() {
        return 1 + units.size() + (matrix > 0 ? 9 : 0);
    }
}
