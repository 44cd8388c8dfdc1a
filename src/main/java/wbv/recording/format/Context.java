package wbv.recording.format;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Metadata;

/** What is known about a file beside its content. */
record Context(Path path, ReadOptions options, Sidecar sidecar) {

    /** The metadata of a file that says this of itself: the user's word goes before the sidecar's, that before the file's. */
    Metadata metadata(Metadata file) {
        Metadata known = sidecar.metadata().orElse(file);
        return options.rate().isPresent() ? known.withRate(options.rate()) : known;
    }

    /** The nominal rate [Hz] by the same order. */
    OptionalDouble rate(OptionalDouble file) {
        return metadata(Metadata.NONE.withRate(file)).rate();
    }

    /**
     * The location of the one sensor of a file: by the user's word, the sidecar's, or else the sensor's name made a word.
     *
     * @param sensor serial or tag of the sensor
     */
    String location(String sensor) {
        String name = path.getFileName().toString();
        int dot = name.indexOf('.');
        String bare = dot > 0 ? name.substring(0, dot) : name;
        return named(sensor, name, bare).orElseGet(() -> word(sensor));
    }

    /** The location that the user, or else the sidecar, gives one of these names, tried in order. */
    Optional<String> named(String... names) {
        for (String name : names) {
            if (options.locations().containsKey(name)) {
                return Optional.of(checked(name, options.locations().get(name)));
            }
        }
        return sidecar.location(names).map(location -> checked(names[0], location));
    }

    private String checked(String name, String location) {
        if (!Channel.isLocation(location)) {
            throw DataFault.in(path.toString(), "the location given to " + name + " must be a word of a-z, 0-9 and _: '"
                    + location + "'");
        }
        return location;
    }

    /** A name made a location: small letters, digits and underscores. */
    static String word(String text) {
        String word = text.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "_").replaceAll("^_+|_+$", "");
        String name = word.isEmpty() || !Character.isLetter(word.charAt(0)) ? "sensor_" + word : word;
        return name.substring(0, Math.min(name.length(), Channel.LONGEST));
    }
}
