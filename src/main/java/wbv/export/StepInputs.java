package wbv.export;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.Model;
import wbv.body.SensorFault;
import wbv.body.number.Modulator;
import wbv.body.number.Numbers;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;

/**
 * What a simulator that steps forward has to be given: the base's motion, and what laws, drives and sensors ask for beside it. Where
 * {@code wbv simulate} filters a channel to both sides in time, as for the angle that an angular rate makes, the result is an input of its
 * own.
 *
 * @param units unit by name, in order
 */
record StepInputs(Map<String, String> units) {

    static StepInputs of(Model model, String format) {
        Map<String, String> out = new LinkedHashMap<>();
        Assembly assembly = model.assembly();
        model.base().sensor().ifPresent(sensor -> {
            if (assembly.structure().held()) {
                out.put(new Channel(sensor.location(), Quantity.POSITION, sensor.axis()).toString(), "m");
                out.put(new Channel(sensor.location(), Quantity.VELOCITY, sensor.axis()).toString(), "m/s");
            } else {
                out.put(base(sensor).toString(), "m/s2");
            }
        });
        assembly.drives().forEach(at -> drive(at.drive(), format, out));
        assembly.laws().forEach(at -> modulator(at.law().modulator(), out));
        for (int o = 0; o < assembly.outputs().size(); o++) {
            for (SensorFault fault : assembly.outputs().get(o).faults()) {
                fault(fault, model.outputs().get(o), format, out);
            }
        }
        return new StepInputs(out);
    }

    /** The base's acceleration, whatever measures its motion. */
    static Channel base(Channel sensor) {
        return new Channel(sensor.location(), Quantity.ACCELERATION, sensor.axis());
    }

    List<String> names() {
        return new ArrayList<>(units.keySet());
    }

    private static void put(Channel channel, Map<String, String> out) {
        out.put(channel.toString(), ascii(channel.quantity().unit()));
    }

    private static String ascii(String unit) {
        return unit.replace("²", "2");
    }

    private static void drive(Drive drive, String format, Map<String, String> out) {
        if (drive instanceof Drive.Measured measured) {
            put(measured.channel(), out);
        } else if (drive instanceof Drive.Late || drive instanceof Drive.Coupled) {
            throw new DataFault("the model holds an error of its input's own channel (" + drive.mechanism()
                    + "), which reaches ahead or back over the whole recording: " + format
                    + " steps forward; --to python can, or put the channel right and take that force out");
        } else if (drive instanceof Drive.Swings swings) {
            throw new DataFault("an end of a link swings across on " + swings.base() + " without a sensor: " + format
                    + " is given motion across as it was measured; --to python can, or put a sensor there");
        } else if (drive instanceof Drive.Given given) {
            put(given.channel(), out);
        } else if (drive instanceof Drive.Across across) {
            put(across.across(), out);
        } else if (drive instanceof Drive.CrossAxis cross) {
            out.put(lean(cross.upper(), cross.lower()), "m");
        } else if (drive instanceof Drive.Rotation rotation) {
            out.put(angle(rotation.rate()), "rad");
            put(rotation.rate(), out);
        }
    }

    private static void modulator(Modulator modulator, Map<String, String> out) {
        if (modulator instanceof Modulator.PartOf part) {
            modulator(part.whole(), out);
        } else if (modulator instanceof Modulator.Level level) {
            put(level.channel(), out);
        } else if (named(modulator)) {
            out.put(modulator.toString(),
                    modulator instanceof Modulator.Measured measured ? ascii(measured.channel().quantity().unit()) : modulator.unit());
        }
    }

    /** Whether its value has to be given. */
    static boolean named(Modulator modulator) {
        return modulator instanceof Modulator.Measured || modulator instanceof Modulator.Angle || modulator instanceof Modulator.Lean;
    }

    private static void fault(SensorFault fault, Channel sensor, String format, Map<String, String> out) {
        if (fault instanceof SensorFault.Misalignment tilt) {
            put(tilt.across(), out);
            put(tilt.beside(), out);
        } else if (fault instanceof SensorFault.Turned turned) {
            put(turned.across(), out);
        } else if (fault instanceof SensorFault.Beside beside) {
            put(beside.channel(), out);
        } else if (fault instanceof SensorFault.LeverArm lever) {
            out.put(angularAcceleration(lever.rate()), "rad/s2");
        } else if (fault instanceof SensorFault.Late late && late.isEarly()) {
            throw new DataFault("the sensor " + sensor + " reads early (" + numbers(late) + "): " + format
                    + " steps forward and cannot look ahead; --to python can, or take that fault out");
        }
    }

    private static String numbers(SensorFault.Late late) {
        double[] values = Numbers.values((Record) late);
        List<String> keys = Numbers.keys(late.getClass());
        return IntStream.range(0, values.length).mapToObj(i -> keys.get(i) + " " + values[i]).collect(Collectors.joining(", "));
    }

    static String lean(Channel upper, Channel lower) {
        return "lean of " + upper + " from " + lower;
    }

    static String angle(Channel rate) {
        return "angle of " + rate;
    }

    static String angularAcceleration(Channel rate) {
        return "angular acceleration of " + rate;
    }
}
