package wbv;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * The Dockerfile, which the tests cannot build: what it copies is there and gets past .dockerignore, its last stage has no tools to build
 * with, and nobody is root.
 */
class DockerfileTest {

    @Test
    void copiesWhatIsThereAndRunsAsNobody() throws IOException {
        List<String> lines = Files.readAllLines(Path.of("Dockerfile"));
        List<String> kept = Files.readAllLines(Path.of(".dockerignore")).stream().filter(line -> line.startsWith("!"))
                .map(line -> line.substring(1)).toList();
        int copied = 0;
        for (String line : lines) {
            if (line.startsWith("COPY ") && !line.contains("--from=")) {
                String source = line.split(" ")[1];
                assertTrue(Files.exists(Path.of(source)), source);
                assertTrue(kept.contains(source), source + " is kept away by .dockerignore");
                copied++;
            }
        }
        assertEquals(kept.size(), copied, "everything that is let through is copied");
        List<String> last = lines.subList(lines.lastIndexOf("FROM eclipse-temurin:17-jre"), lines.size());
        assertTrue(last.contains("USER 1000:1000") && last.stream().noneMatch(line -> line.contains("mvn")));
        String entry = lines.get(lines.size() - 1);
        assertTrue(entry.startsWith("ENTRYPOINT [\"java\"") && entry.endsWith("\"/opt/wbv/wbv.jar\"]"), entry);
        for (String result : List.of("target/lib", "target/wbv.jar")) {
            assertTrue(last.stream().anyMatch(line -> line.startsWith("COPY --from=build /wbv/" + result + " /opt/wbv/")), result);
        }
    }
}
