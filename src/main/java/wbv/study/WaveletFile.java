package wbv.study;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import wbv.recording.AtomicFile;
import wbv.recording.Channel;
import wbv.recording.TableText;
import wbv.signal.WaveletResponse;

/** Responses through time as CSV: one line for each output, moment and frequency. What is not known is an empty cell. */
final class WaveletFile {

    private WaveletFile() {}

    /** @param provenance stands in comment lines before the header */
    static void write(ResponseAnalysis analysis, Map<String, String> provenance, Path file) throws IOException {
        StringBuilder text = new StringBuilder();
        provenance.forEach((name, value) -> text.append("# ").append(TableText.comment(name + ": " + value)).append('\n'));
        text.append("output,t_s,frequency_Hz,modulus,phase_deg,coherence\n");
        for (Channel output : analysis.measured().outputs()) {
            analysis.through(output).ifPresent(through -> append(text, output, through));
        }
        AtomicFile.write(file, text.toString().getBytes(StandardCharsets.UTF_8));
    }

    private static void append(StringBuilder text, Channel output, WaveletResponse through) {
        for (int c = 0; c < through.times().length; c++) {
            for (int k = 0; k < through.frequencies().length; k++) {
                text.append(output);
                number(text, through.times()[c]);
                number(text, through.frequencies()[k]);
                number(text, through.modulus()[c][k]);
                number(text, Math.toDegrees(through.phase()[c][k]));
                number(text, through.coherence()[c][k]);
                text.append('\n');
            }
        }
    }

    private static void number(StringBuilder text, double value) {
        text.append(',');
        if (Double.isFinite(value)) {
            text.append((float) value);
        }
    }
}
