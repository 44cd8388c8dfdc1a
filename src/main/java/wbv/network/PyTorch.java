package wbv.network;

import ai.djl.engine.Engine;
import ai.djl.engine.EngineException;
import java.io.IOException;
import java.io.InputStream;
import java.util.Locale;
import java.util.Properties;
import wbv.recording.DataFault;

/** DJL's engine, told to download nothing, to report to nobody, and to use one thread, so that a seed gives the same network. */
final class PyTorch {

    private static final String NATIVES = "native/lib/pytorch.properties";

    private PyTorch() {}

    /**
     * The engine; unpacks its library into DJL's cache (430 MB) when first used.
     *
     * @throws DataFault if the library for this platform is missing
     */
    static Engine engine() {
        System.setProperty("ai.djl.offline", "true");
        System.setProperty("OPT_OUT_TRACKING", "true");
        System.setProperty("ai.djl.pytorch.num_threads", "1");
        System.setProperty("ai.djl.pytorch.num_interop_threads", "1");
        String wanted = platform();
        String found = shipped();
        if (!found.equals(wanted)) {
            throw new DataFault("networks need PyTorch's library for " + wanted + ", and wbv was built "
                    + (found.isEmpty() ? "without one" : "with that for " + found)
                    + "; build it on linux-x86_64, osx-aarch64 or win-x86_64. Everything else works without");
        }
        try {
            return Engine.getEngine("PyTorch");
        } catch (EngineException | UnsatisfiedLinkError broken) {
            throw new DataFault("networks need PyTorch's library, which does not load here: " + root(broken)
                    + ". Everything else works without", broken);
        }
    }

    /** This machine in the words of DJL's artifacts. */
    private static String platform() {
        String system = System.getProperty("os.name").toLowerCase(Locale.ROOT);
        String processor = System.getProperty("os.arch");
        return (system.startsWith("mac") ? "osx" : system.startsWith("win") ? "win" : system) + "-"
                + (processor.equals("amd64") ? "x86_64" : processor);
    }

    private static String shipped() {
        try (InputStream in = PyTorch.class.getClassLoader().getResourceAsStream(NATIVES)) {
            if (in == null) {
                return "";
            }
            Properties properties = new Properties();
            properties.load(in);
            return properties.getProperty("classifier", "");
        } catch (IOException unreadable) {
            return "";
        }
    }

    private static String root(Throwable fault) {
        Throwable cause = fault;
        while (cause.getCause() != null) {
            cause = cause.getCause();
        }
        return String.valueOf(cause.getMessage()).lines().findFirst().orElse(cause.getClass().getSimpleName());
    }
}
