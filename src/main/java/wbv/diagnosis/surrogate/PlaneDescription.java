package wbv.diagnosis.surrogate;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.Model;
import wbv.body.ModelFile;

/**
 * Bodies in a plane as their user would write them.
 *
 * @param base    name
 * @param axes    of it, that along z first
 * @param sensors by the part's name
 * @param factor  on masses, stiffness and damping, &gt; 0
 */
record PlaneDescription(PlaneNet net, String base, List<String> axes, Map<String, List<String>> sensors, double factor) {

    private static final ObjectMapper JSON = new ObjectMapper();

    PlaneDescription {
        if (!(factor > 0)) {
            throw new IllegalArgumentException("a factor on masses must be > 0: " + factor);
        }
    }

    /** The model that a reader of it gets. */
    Model model() {
        Map<String, Object> root = new LinkedHashMap<>(Map.of("name", "surrogate"));
        root.put("plane", "xz");
        root.put("axis", "z");
        root.put("base", Map.of("name", base, "at_m", List.of(0, 0), "sensors", axes));
        root.put("bodies", net.parts().stream().map(this::body).toList());
        root.put("links", net.joints().stream().flatMap(this::links).toList());
        try {
            return ModelFile.parse(JSON.writeValueAsString(root), "surrogate");
        } catch (JsonProcessingException never) {
            throw new IllegalStateException(never);
        }
    }

    private Map<String, Object> body(PlaneNet.Part part) {
        Map<String, Object> body = new LinkedHashMap<>(
                Map.of("name", part.name(), "at_m", List.of(part.x(), part.z()), "mass_kg", factor * part.mass()));
        if (part.measured()) {
            List<Double> at = List.of(part.sensors().x(), part.sensors().z());
            body.put("inertia_kgm2", factor * part.inertia());
            body.put("sensors", sensors.get(part.name()).stream().map(sensor -> Map.of("sensor", sensor, "at_m", at)).toList());
        }
        return body;
    }

    private Stream<Map<String, Object>> links(PlaneNet.Joint joint) {
        return IntStream.range(0, joint.motions()).mapToObj(motion -> link(joint, motion));
    }

    private Map<String, Object> link(PlaneNet.Joint joint, int motion) {
        List<PlaneNet.Part> parts = net.parts();
        Map<String, Object> link = new LinkedHashMap<>(
                Map.of("from", joint.lower() < 0 ? base : parts.get(joint.lower()).name(), "to", parts.get(joint.upper()).name()));
        boolean turning = motion == 2;
        if (turning) {
            link.put("about", "y");
        } else {
            Model.Point point = net.point(joint);
            link.put("along", motion == 0 ? "x" : "z");
            link.put("at_m", List.of(point.x(), point.z()));
        }
        link.put(turning ? "stiffness_Nm_per_rad" : "stiffness_N_per_m", factor * joint.stiffness(motion));
        link.put(turning ? "damping_Nms_per_rad" : "damping_Ns_per_m", factor * joint.damping(motion));
        return link;
    }
}
