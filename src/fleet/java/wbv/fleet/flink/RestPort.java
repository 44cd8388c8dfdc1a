package wbv.fleet.flink;

import java.io.IOException;
import java.net.HttpURLConnection;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import wbv.recording.DataFault;

/** Where a cluster takes orders. */
record RestPort(String host, int port) {

    private static final int PATIENCE = 5_000; // ms
    private static final Pattern FREE = Pattern.compile("\"slots-available\"\\s*:\\s*(\\d+)");
    private static final Pattern ADDRESS = Pattern.compile("(.+):(\\d{1,5})");

    /** @throws DataFault if it is not HOST:PORT */
    static RestPort of(String address) {
        Matcher parts = ADDRESS.matcher(address);
        if (!parts.matches() || Integer.parseInt(parts.group(2)) > 65_535) {
            throw DataFault.in(address, "is no HOST:PORT of a cluster, as localhost:8081");
        }
        return new RestPort(parts.group(1), Integer.parseInt(parts.group(2)));
    }

    /** How many tasks it could take now; empty if none answers there. */
    OptionalInt free() {
        try {
            HttpURLConnection ask = (HttpURLConnection) URI.create("http://" + host + ":" + port + "/overview").toURL().openConnection();
            ask.setConnectTimeout(PATIENCE);
            ask.setReadTimeout(PATIENCE);
            try (var in = ask.getInputStream()) {
                Matcher found = FREE.matcher(new String(in.readNBytes(1 << 16), StandardCharsets.UTF_8));
                return found.find() ? OptionalInt.of(Integer.parseInt(found.group(1))) : OptionalInt.empty();
            }
        } catch (IOException | IllegalArgumentException none) {
            return OptionalInt.empty();
        }
    }

    @Override
    public String toString() {
        return host + ":" + port;
    }
}
