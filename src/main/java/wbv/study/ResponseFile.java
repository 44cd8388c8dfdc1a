package wbv.study;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import wbv.recording.AtomicFile;
import wbv.recording.TableText;
import wbv.signal.ComplexSeries;

/** Frequency responses as CSV: one line for each output, input and frequency. What is not known is an empty cell. */
final class ResponseFile {

    private static final String HEADER = "output,input,unit,frequency_Hz,h1,h1_low,h1_high,phase_deg,phase_margin_deg,h2,h2_phase_deg,"
            + "hv,hv_phase_deg,multiple_coherence,partial_coherence,ordinary_coherence,usable,unusable_because,other_cause,"
            + "input_density,output_density,model,model_phase_deg";

    private ResponseFile() {}

    /** @param provenance stands in comment lines before the header */
    static void write(List<ResponseCurve> curves, MeasuredResponse measured, Map<String, String> provenance, Path file) throws IOException {
        StringBuilder text = new StringBuilder();
        provenance.forEach((name, value) -> text.append("# ").append(TableText.comment(name + ": " + value)).append('\n'));
        text.append(HEADER).append('\n');
        for (ResponseCurve curve : curves) {
            ComplexSeries h1 = curve.h1();
            double[] margin = curve.margin();
            double[] angle = curve.phaseMargin();
            String[] reasons = Unbacked.reasons(curve.backing(), measured.inputs().size() > 1);
            String[] causes = measured.others().names(measured.outputs().indexOf(curve.output()), curve.backing());
            for (int k = 0; k < h1.length(); k++) {
                text.append(curve.output()).append(',').append(curve.input()).append(',').append(curve.unit());
                number(text, curve.frequency()[k]);
                number(text, h1.magnitude(k));
                number(text, Math.max(0, h1.magnitude(k) - margin[k]));
                number(text, h1.magnitude(k) + margin[k]);
                number(text, Math.toDegrees(h1.phase(k)));
                number(text, Math.toDegrees(angle[k]));
                polar(text, curve.bareH2().isPresent(), curve.bareH2().orElse(h1), k);
                polar(text, true, curve.hv(), k);
                number(text, curve.all().multipleCoherence(0)[k]);
                number(text, curve.all().partialCoherence(0, curve.index())[k]);
                number(text, curve.all().ordinaryCoherence(0, curve.index())[k]);
                text.append(reasons[k].isEmpty() ? ",1," : ",0,").append(reasons[k]).append(',').append(causes[k]);
                number(text, curve.all().inputDensity(curve.index())[k]);
                number(text, curve.all().outputDensity(0)[k]);
                polar(text, curve.model().isPresent(), curve.model().orElse(h1), k);
                text.append('\n');
            }
        }
        AtomicFile.write(file, text.toString().getBytes(StandardCharsets.UTF_8));
    }

    private static void polar(StringBuilder text, boolean known, ComplexSeries h, int k) {
        number(text, known ? h.magnitude(k) : Double.NaN);
        number(text, known ? Math.toDegrees(h.phase(k)) : Double.NaN);
    }

    private static void number(StringBuilder text, double value) {
        text.append(',');
        if (Double.isFinite(value)) {
            text.append(value);
        }
    }
}
