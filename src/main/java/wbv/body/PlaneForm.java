package wbv.body;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/**
 * A model of rigid bodies in the plane of x and z, as its user writes it: bodies and base with the points where they are, links at
 * points. It becomes a {@link Model} whose bodies are the motions {@code pelvis.x}, {@code pelvis.z} and {@code pelvis.pitch}.
 *
 * <p>To first order a point at (dx, dz) from a body's centre of mass moves by {@code x + dz θ} and {@code z - dx θ}, the angle θ about y
 * positive from z towards x; {@link Plane} does the rest. Links keep to the axes of the lower body. What gravity does at an angle counts as
 * part of the stiffness about the joint.
 */
final class PlaneForm {

    private static final String PITCH = ".pitch";

    private final String ground;
    private final Model.Point origin;
    private final Map<String, Model.Point> centres = new LinkedHashMap<>();
    private final Map<Plane.Motion, Channel> moved = new LinkedHashMap<>();
    private final Set<String> motions = new TreeSet<>();
    private final List<Model.Body> bodies = new ArrayList<>();
    private final List<Model.Link> links = new ArrayList<>();
    private final List<Model.Sensor> sensors = new ArrayList<>();

    private PlaneForm(JsonPlace at) {
        at.allow(Set.of("name", "source", "subject", "axis", "plane", "base", "bodies", "links", "inputs"));
        if (!at.text("plane").equals("xz")) {
            throw at.fault("'plane' must be \"xz\": x forward, z upward, angles about y");
        }
        JsonPlace base = at.child("base");
        base.allow(Set.of("name", "at_m", "sensors", "mass_kg", ModelFile.FILTER));
        ground = base.text("name");
        origin = point(base, "at_m");
        for (String name : base.texts("sensors")) {
            Channel sensor = base.guard(() -> Channel.parse(name));
            if (moved.put(motion(base, sensor), sensor) != null) {
                throw base.fault("'sensors' holds two of one motion: " + sensor);
            }
        }
    }

    /** Whether a model is written so. */
    static boolean is(JsonPlace at) {
        return at.has("plane");
    }

    static Model read(JsonPlace at) {
        PlaneForm form = new PlaneForm(at);
        at.list("bodies").forEach(form::body);
        at.list("links").forEach(form::link);
        JsonPlace base = at.child("base");
        List<Channel> axes = List.copyOf(form.moved.values());
        Model.Base ground = base.guard(() -> new Model.Base(form.ground, axes.stream().findFirst(), base.numberOr("mass_kg", 0),
                axes.isEmpty() ? axes : axes.subList(1, axes.size()), Optional.of(form.origin), ModelFile.filter(base)));
        return ModelFile.model(at, ground, form.bodies, form.links, form.sensors);
    }

    private void body(JsonPlace body) {
        body.allow(Set.of("name", "at_m", "mass_kg", "mass_within", "inertia_kgm2", "sensors"));
        String name = body.text("name");
        Model.Point centre = point(body, "at_m");
        centres.put(name, centre);
        Map<Plane.Motion, Channel> own = new LinkedHashMap<>();
        List<Model.Sensor> beside = new ArrayList<>();
        for (JsonPlace sensor : body.optionalList("sensors")) {
            sensor.allow(Set.of("sensor", "at_m"));
            Channel channel = sensor.channel("sensor").orElseThrow(() -> sensor.fault("'sensor' names no channel"));
            Plane.Motion motion = motion(sensor, channel);
            Map<String, Double> arms = sensor.has("at_m") ? arm(name, motion, from(point(sensor, "at_m"), centre), 1) : Map.of();
            if (arms.isEmpty() && !own.containsKey(motion)) {
                own.put(motion, channel);
            } else {
                Map<String, Double> reads = new LinkedHashMap<>(Map.of(name(name, motion), 1.0));
                reads.putAll(arms);
                Model.Point sits = sensor.has("at_m") ? point(sensor, "at_m") : centre;
                beside.add(sensor.guard(() -> new Model.Sensor(channel, reads, List.of(), Optional.of(sits))));
            }
        }
        boolean turns = body.has("inertia_kgm2");
        for (Plane.Motion motion : turns ? List.of(Plane.Motion.X, Plane.Motion.Z, Plane.Motion.PITCH)
                : List.of(Plane.Motion.X, Plane.Motion.Z)) {
            boolean angle = motion == Plane.Motion.PITCH;
            Optional<String> massOf = motion == Plane.Motion.Z ? Optional.of(name(name, Plane.Motion.X)) : Optional.empty();
            double mass = body.mass(angle ? "inertia_kgm2" : "mass_kg");
            Map<Channel, Double> carried = carried(motion, from(centre, origin));
            bodies.add(body.guard(() -> new Model.Body(name(name, motion), mass, Optional.ofNullable(own.get(motion)), List.of(),
                    Optional.empty(), List.of(), false, carried, massOf, angle, Optional.of(centre),
                    motion == Plane.Motion.X ? ModelFile.within(body) : OptionalDouble.empty())));
            motions.add(name(name, motion));
        }
        if (!turns && (own.containsKey(Plane.Motion.PITCH) || !beside.isEmpty())) {
            throw body
                    .fault("'" + name + "' has no inertia_kgm2 and so does not turn: its sensors read x and z at its centre, one of each");
        }
        sensors.addAll(beside);
    }

    /**
     * How a base that moves along its axes carries a point.
     *
     * @param from the point, from where the base is
     */
    private Map<Channel, Double> carried(Plane.Motion motion, Model.Point from) {
        Map<Channel, Double> out = new LinkedHashMap<>();
        moved.forEach((axis, channel) -> {
            double part = axis == motion ? 1 : axis == Plane.Motion.PITCH ? lever(motion, from) : 0;
            // A motion along no axis of the base is carried by none of them, and says so.
            if (part != 0 || axis == moved.keySet().iterator().next()) {
                out.put(channel, part);
            }
        });
        return out;
    }

    /** What a point moves by with an angle [m]. */
    private static double lever(Plane.Motion motion, Model.Point from) {
        return motion == Plane.Motion.X ? from.z() : motion == Plane.Motion.Z ? -from.x() : 0;
    }

    private Map<String, Double> arm(String body, Plane.Motion motion, Model.Point from, double sign) {
        double lever = sign * lever(motion, from);
        return lever == 0 ? Map.of() : Map.of(body + PITCH, lever);
    }

    private void link(JsonPlace link) {
        link.allow(Set.of("from", "to", "along", "about", "at_m", "stiffness_N_per_m", "damping_Ns_per_m", "stiffness_Nm_per_rad",
                "damping_Nms_per_rad", "sensor", "faults", "laws"));
        if (link.has("along") == link.has("about")) {
            throw link.fault("a link acts either \"along\": \"x\" or \"z\", or \"about\": \"y\"");
        }
        Plane.Motion motion = link.has("about") ? Plane.Motion.PITCH : along(link);
        String unit = motion == Plane.Motion.PITCH ? "_Nm_per_rad" : "_N_per_m";
        String rate = motion == Plane.Motion.PITCH ? "_Nms_per_rad" : "_Ns_per_m";
        boolean drawnDown = link.text("to").equals(ground);
        String from = link.text(drawnDown ? "to" : "from");
        String to = link.text(drawnDown ? "from" : "to");
        Map<String, Double> arms = new LinkedHashMap<>();
        if (motion != Plane.Motion.PITCH) {
            Model.Point point = point(link, "at_m");
            known(link, to).forEach(centre -> arms.putAll(arm(to, motion, from(point, centre), 1)));
            known(link, from).forEach(centre -> arms.putAll(arm(from, motion, from(point, centre), -1)));
        }
        arms.keySet().retainAll(motions);   // a body that does not turn has no lever
        String lower = from.equals(ground) ? ground : moving(link, from, motion);
        links.add(
                ModelFile.link(link, lower, moving(link, to, motion), link.number("stiffness" + unit), link.number("damping" + rate), arms,
                        motion == Plane.Motion.PITCH ? Optional.empty() : Optional.of(point(link, "at_m"))));
    }

    /** Where a body's centre is; none for the base. */
    private List<Model.Point> known(JsonPlace link, String body) {
        if (body.equals(ground)) {
            return List.of();
        }
        if (!centres.containsKey(body)) {
            throw link.fault("it joins '" + body + "', which is no body; there are " + centres.keySet() + " and the base '" + ground + "'");
        }
        return List.of(centres.get(body));
    }

    private String moving(JsonPlace link, String body, Plane.Motion motion) {
        known(link, body);
        String name = name(body, motion);
        if (!motions.contains(name)) {
            throw link.fault("'" + body + "' has no inertia_kgm2 and so does not turn");
        }
        return name;
    }

    private static Plane.Motion along(JsonPlace link) {
        return switch (link.text("along")) {
            case "x" -> Plane.Motion.X;
            case "z" -> Plane.Motion.Z;
            default -> throw link.fault("'along' must be \"x\" or \"z\": '" + link.text("along") + "'");
        };
    }

    private static Plane.Motion motion(JsonPlace at, Channel sensor) {
        boolean turning = sensor.quantity() == Quantity.ANGULAR_RATE || sensor.quantity() == Quantity.ANGLE;
        if (turning == (sensor.axis() != 'y')) {
            throw at.fault("in the plane of x and z a sensor reads along x or z, or an angle about y: " + sensor);
        }
        return Model.motionOf(sensor);
    }

    private static String name(String body, Plane.Motion motion) {
        return body + Model.suffix(motion);
    }

    private static Model.Point from(Model.Point point, Model.Point centre) {
        return new Model.Point(point.x() - centre.x(), point.z() - centre.z());
    }

    private static Model.Point point(JsonPlace at, String key) {
        return at.point(key).orElseThrow(() -> at.fault("'" + key + "' is missing: two numbers [x, z] in m"));
    }
}
