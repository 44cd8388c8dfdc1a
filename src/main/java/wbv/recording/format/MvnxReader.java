package wbv.recording.format;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.StringTokenizer;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.Quantity;
import wbv.recording.RowReader;
import wbv.recording.SensorClock;

/**
 * The frames of an MVNX file. The segments' acceleration (gravity removed), angular velocity, velocity and position are in the
 * axes of the world, x forward at calibration, z up. Frames of a calibration pose ({@code npose}, {@code tpose}) are passed over.
 */
final class MvnxReader implements RowReader {

    private static final Map<String, Quantity> ELEMENTS = elements();

    private final Source source;
    private final XMLStreamReader xml;
    private final List<String> segments = new ArrayList<>();
    private final Metadata metadata;
    private final List<Channel> channels = new ArrayList<>();
    private final Map<String, Integer> slots = new LinkedHashMap<>();
    private final double[] first;
    private boolean held;
    private double rate;
    private long line;
    private String recorded = "";

    /** Reads up to the first frame, which tells what the frames hold. */
    MvnxReader(Source source, XMLStreamReader xml, Context context) throws XMLStreamException {
        this.source = source;
        this.xml = xml;
        if (!nextStart() || !xml.getLocalName().equals("mvnx")) {
            throw DataFault.in(source.name(), "is XML, but not MVNX; export the recording as CSV");
        }
        Map<String, String> values = new LinkedHashMap<>();
        double time = head(values);
        if (values.isEmpty()) {
            throw DataFault.in(source.name(), "has no frame with acceleration, angularVelocity, velocity, position or orientation"
                    + "; export MVNX with segment kinematics");
        }
        for (String element : ELEMENTS.keySet()) {
            if (values.containsKey(element)) {
                slots.put(element, 1 + channels.size());
                segments.forEach(label -> channels(label, ELEMENTS.get(element), context));
            }
        }
        first = new double[1 + channels.size()];
        first[0] = time;
        values.forEach((element, text) -> fill(first, element, text));
        held = true;
        Map<String, String> notes = recorded.isEmpty() ? Map.of() : Map.of("recorded", recorded);
        metadata = context.metadata(new Metadata(rate > 0 ? OptionalDouble.of(rate) : OptionalDouble.empty(), Map.of(),
                Optional.empty(), Optional.empty(), OptionalDouble.empty(), Optional.of("MVNX export"), notes))
                .withUnits(NamedColumns.known(channels));
    }

    private static Map<String, Quantity> elements() {
        Map<String, Quantity> elements = new LinkedHashMap<>();
        elements.put("acceleration", Quantity.ACCELERATION);
        elements.put("angularVelocity", Quantity.ANGULAR_RATE);
        elements.put("velocity", Quantity.VELOCITY);
        elements.put("position", Quantity.POSITION);
        elements.put("orientation", Quantity.QUATERNION);
        return elements;
    }

    private boolean nextStart() throws XMLStreamException {
        while (xml.hasNext()) {
            if (xml.next() == XMLStreamConstants.START_ELEMENT) {
                return true;
            }
        }
        return false;
    }

    private double head(Map<String, String> values) throws XMLStreamException {
        while (nextStart()) {
            switch (xml.getLocalName()) {
                case "subject" -> {
                    rate = number(attribute("frameRate"));
                    if (!Double.isNaN(rate) && !Clock.isRate(rate)) {
                        line = xml.getLocation().getLineNumber();
                        throw fault("frameRate must be " + Clock.SLOWEST + " to " + Clock.FASTEST + " Hz: " + rate);
                    }
                    recorded = attribute("recDate");
                }
                case "segment" -> segments.add(attribute("label"));
                case "frame" -> {
                    if (moving()) {
                        return frame(values);
                    }
                }
                default -> {}
            }
        }
        return 0;
    }

    private String attribute(String name) {
        String value = xml.getAttributeValue(null, name);
        return value == null ? "" : value.strip();
    }

    private static double number(String text) {
        try {
            return Double.parseDouble(text);
        } catch (NumberFormatException none) {
            return Double.NaN;
        }
    }

    private boolean moving() {
        String type = attribute("type");
        return type.isEmpty() || type.equals("normal");
    }

    /** Reads the frame that the parser stands on; gives its time: its index over the rate, or else what it says in ms. */
    private double frame(Map<String, String> values) throws XMLStreamException {
        line = xml.getLocation().getLineNumber();
        double index = number(attribute("index"));
        double time = rate > 0 && !Double.isNaN(index) ? index / rate : number(attribute("time")) / 1000;
        if (Double.isNaN(time)) {
            throw fault("the frame has neither index nor time");
        }
        while (true) {
            int event = xml.next();
            if (event == XMLStreamConstants.END_ELEMENT && xml.getLocalName().equals("frame")) {
                return time;
            }
            if (event == XMLStreamConstants.START_ELEMENT && ELEMENTS.containsKey(xml.getLocalName())) {
                values.put(xml.getLocalName(), xml.getElementText());
            }
        }
    }

    private void channels(String label, Quantity quantity, Context context) {
        String location = context.named(label).orElseGet(() -> Context.word(label.replaceAll("([a-z0-9])([A-Z])", "$1_$2")));
        for (char axis : quantity.axes().toCharArray()) {
            channels.add(new Channel(location, quantity, axis));
        }
    }

    private void fill(double[] row, String element, String text) {
        Integer slot = slots.get(element);
        if (slot == null) {
            return;
        }
        int wanted = segments.size() * ELEMENTS.get(element).axes().length();
        StringTokenizer numbers = new StringTokenizer(text);
        if (numbers.countTokens() != wanted) {
            throw fault(element + " has " + numbers.countTokens() + " numbers where " + segments.size() + " segments need "
                    + wanted);
        }
        for (int i = 0; i < wanted; i++) {
            String token = numbers.nextToken();
            double value = number(token);
            if (Double.isInfinite(value) || Double.isNaN(value) && !token.equalsIgnoreCase("nan")) {
                throw fault(element + " must hold finite numbers: '" + token + "'");
            }
            row[slot + i] = value;
        }
    }

    private DataFault fault(String message) {
        return DataFault.at(source.name(), line, message);
    }

    @Override
    public List<Channel> channels() {
        return List.copyOf(channels);
    }

    @Override
    public Metadata metadata() {
        return metadata;
    }

    @Override
    public boolean read(double[] row) throws IOException {
        if (held) {
            held = false;
            System.arraycopy(first, 0, row, 0, first.length);
            return true;
        }
        try {
            while (nextStart()) {
                if (xml.getLocalName().equals("frame") && moving()) {
                    Map<String, String> values = new LinkedHashMap<>();
                    double time = frame(values);
                    Arrays.fill(row, Double.NaN);
                    row[0] = time;
                    values.forEach((element, text) -> fill(row, element, text));
                    return true;
                }
            }
            return false;
        } catch (XMLStreamException wrong) {
            throw MvnxFormat.fault(source, wrong);
        }
    }

    @Override
    public Optional<SensorClock> sensorClock() {
        return rate > 0 ? Optional.of(new SensorClock(0, Double.POSITIVE_INFINITY)) : Optional.empty();
    }

    @Override
    public long line() {
        return line;
    }

    @Override
    public double fractionRead() {
        return source.fractionRead();
    }

    @Override
    public void close() throws IOException {
        source.close();
    }
}
