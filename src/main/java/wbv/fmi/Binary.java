package wbv.fmi;

import com.sun.jna.Callback;
import com.sun.jna.Function;
import com.sun.jna.Library;
import com.sun.jna.Native;
import com.sun.jna.NativeLibrary;
import com.sun.jna.Platform;
import com.sun.jna.Pointer;
import java.io.Closeable;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import wbv.recording.DataFault;

/**
 * The native part of a unit: its functions by name, their status made a {@link DataFault} with what the unit said last. A unit that crashes
 * takes the program with it; nothing but the functions of the standard is called, with memory that outlives the call.
 */
final class Binary implements Closeable {

    /** Status from which on a call has failed: discard, error, fatal, pending. */
    private static final int FAILED = 2;
    private static final int WARNING = 1;
    private static final int REMEMBERED = 3;
    private static final int SHOWN = 400;
    private static final String PLACEHOLDER = "(?<!%)%[-+ #0-9.*hljztL]*[diouxXeEfFgGaAcspn]";

    private final String name;
    private final NativeLibrary library;
    private final Map<String, Function> functions = new HashMap<>();
    private final Deque<String> said = new ArrayDeque<>();

    /**
     * @param name of the unit, for messages
     * @throws DataFault if the binary cannot be loaded
     */
    Binary(Path file, String name) {
        this.name = name;
        try {
            library = NativeLibrary.getInstance(file.toAbsolutePath().toString(), Map.of(Library.OPTION_STRING_ENCODING, "UTF-8"));
        } catch (UnsatisfiedLinkError failed) {
            throw DataFault.in(name, "its binary " + file.getFileName() + " cannot be loaded: " + firstLine(failed), failed);
        }
    }

    /** Where a unit of a version keeps the binary for this computer, best first, below {@code binaries}. */
    static List<String> places(int version, String identifier) {
        String system = Platform.isWindows() ? "windows" : Platform.isMac() ? "darwin" : "linux";
        String ending = Platform.isWindows() ? ".dll" : Platform.isMac() ? ".dylib" : ".so";
        String processor = Platform.isARM() ? "aarch64" : Platform.is64Bit() ? "x86_64" : "x86";
        String tuple = processor + "-" + system + "/" + identifier + ending;
        String old = (Platform.isWindows() ? "win" : system) + (Platform.is64Bit() ? "64" : "32") + "/" + identifier + ending;
        // FMI 2.0 names no processor; what it means is x86, but of darwin both.
        return version == 3 ? List.of(tuple) : Platform.isARM() && !Platform.isMac() ? List.of(tuple) : List.of(old, tuple);
    }

    private static String firstLine(Throwable failed) {
        return String.valueOf(failed.getMessage()).lines().findFirst().orElse("");
    }

    /**
     * Calls a function that gives a status.
     *
     * @param doing what is being done, for the message
     * @throws DataFault if it fails, with what the unit said
     */
    void call(String doing, String function, Object... arguments) {
        int status = function(function).invokeInt(arguments);
        if (status >= FAILED) {
            throw failure(doing + (status == FAILED ? " was refused" : " failed"));
        }
    }

    /** Calls a function that a unit may decline. */
    boolean gives(String function, Object... arguments) {
        return function(function).invokeInt(arguments) < FAILED;
    }

    /** Calls a function that makes something; null is a failure. */
    Pointer make(String doing, String function, Object... arguments) {
        Pointer made = function(function).invokePointer(arguments);
        if (made == null) {
            throw failure(doing + " failed");
        }
        return made;
    }

    /** Calls a function that cannot fail. */
    void tell(String function, Object... arguments) {
        function(function).invoke(arguments);
    }

    /** The fault of something that failed, with what the unit said of it. */
    DataFault failure(String what) {
        String words = String.join("; ", said);
        return DataFault.in(name, what
                + (words.isEmpty() ? "; the unit does not say why" : "; it says: " + words.substring(0, Math.min(SHOWN, words.length()))));
    }

    private Function function(String function) {
        return functions.computeIfAbsent(function, missing -> {
            try {
                return library.getFunction(missing);
            } catch (UnsatisfiedLinkError none) {
                throw DataFault.in(name, "its binary has no function " + missing + ", which its modelDescription.xml promises", none);
            }
        });
    }

    /** Remembers a message of the unit, the last few of those that are no plain news. */
    void hear(int status, String message) {
        if (status >= WARNING && message != null && !message.isBlank()) {
            said.remove(message.strip());
            said.addLast(message.strip());
            if (said.size() > REMEMBERED) {
                said.removeFirst();
            }
        }
    }

    /** A length as the C library takes it. */
    static Object size(long count) {
        return Native.SIZE_T_SIZE == Long.BYTES ? (Object) count : (Object) (int) count;
    }

    /** A function of the C library that this program is linked to. */
    static Pointer ofC(String function) {
        return Platform.isWindows() ? NativeLibrary.getInstance("msvcrt").getFunction(function)
                : NativeLibrary.getProcess().getFunction(function);
    }

    /** How FMI 2.0 logs: of what belongs to the placeholders of the message the first is taken, as if it were declared. */
    interface Logger2 extends Callback {
        void invoke(Pointer environment, String instance, int status, String category, String message, Pointer first);
    }

    /**
     * A message of FMI 2.0 with a text for its first placeholder, where that is one of a text, and none for the others. ARM on macOS hands
     * such arguments over where no function finds them that does not expect any; there placeholders stay empty.
     */
    static String filled(String message, Pointer first) {
        if (message == null) {
            return "";
        }
        int at = message.replace("%%", "  ").indexOf('%');
        boolean text = at >= 0 && message.startsWith("%s", at) && first != null && !Platform.isARM();
        String whole = text
                ? message.substring(0, at) + first.getString(0, "UTF-8") + message.substring(at + 2).replaceAll(PLACEHOLDER, "…")
                : message.replaceAll(PLACEHOLDER, "…");
        return whole.replace("%%", "%");
    }

    /** How FMI 3.0 logs. */
    interface Logger3 extends Callback {
        void invoke(Pointer environment, int status, String category, String message);
    }

    @Override
    public void close() {
        library.close();
    }
}
