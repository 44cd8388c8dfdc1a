package wbv.bench;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The same arithmetic as a plain C loop, {@code src/test/c/estimators.c}, where there is a compiler for it. */
final class CompiledPeer {

    private static final Path SOURCE = Path.of("src/test/c/estimators.c");

    private final Path program;
    private final Path data;

    /** What the loop says. @param nanoseconds of processor time per sample @param frequency [Hz] @param damping ratio */
    record Said(double nanoseconds, double frequency, double damping) {}

    private CompiledPeer(Path program, Path data) {
        this.program = program;
        this.data = data;
    }

    /** Compiled with -O2 in a folder; empty if there is no cc. @param u input. Not modified. @param y output. Not modified. */
    static Optional<CompiledPeer> in(Path folder, double[] u, double[] y) throws IOException, InterruptedException {
        Path program = folder.resolve("estimators");
        try {
            Process compiler = new ProcessBuilder("cc", "-O2", "-o", program.toString(), SOURCE.toString(), "-lm").inheritIO()
                    .start();
            if (compiler.waitFor() != 0) {
                throw new IOException("cc does not compile " + SOURCE);
            }
        } catch (IOException none) {
            if (Files.exists(program) || none.getMessage().contains("does not compile")) {
                throw none;
            }
            return Optional.empty();
        }
        ByteBuffer bytes = ByteBuffer.allocate(2 * Double.BYTES * u.length).order(ByteOrder.nativeOrder());
        for (int i = 0; i < u.length; i++) {
            bytes.putDouble(u[i]).putDouble(y[i]);
        }
        Path data = Files.write(folder.resolve("samples"), bytes.array());
        return Optional.of(new CompiledPeer(program, data));
    }

    /** Runs it. @param method ekf, ukf or particle @param rounds over all samples @param particles of a particle filter */
    Said run(String method, int rounds, int particles) throws IOException, InterruptedException {
        List<String> words = new ArrayList<>(List.of(program.toString(), method, data.toString(), Integer.toString(rounds),
                Integer.toString(particles)));
        Process process = new ProcessBuilder(words).redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes());
        if (process.waitFor() != 0) {
            throw new IOException(words + ": " + said);
        }
        String[] numbers = said.trim().split(" ");
        return new Said(Double.parseDouble(numbers[0]), Double.parseDouble(numbers[1]), Double.parseDouble(numbers[2]));
    }
}
