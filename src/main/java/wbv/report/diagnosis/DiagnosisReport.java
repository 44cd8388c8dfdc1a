package wbv.report.diagnosis;

import java.io.IOException;
import java.util.Map;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.picture.Pictures;
import wbv.report.page.HtmlWriter;
import wbv.result.OutputFolder;
import wbv.result.ResultsJson;
import wbv.study.DiagnosisJson;

/** A diagnosis for people, {@code report.html}, and for machines, {@code diagnosis.json}. */
public final class DiagnosisReport {

    private DiagnosisReport() {}

    /**
     * Writes both. The same arguments give the same bytes.
     *
     * @param provenance what, and from what, this was made, in the order in which it is shown
     */
    public static void write(Diagnosis diagnosis, Pictures pictures, Map<String, String> provenance,
            OutputFolder out) throws IOException {
        ResultsJson.write(DiagnosisJson.of(diagnosis, pictures, provenance), out.file("diagnosis.json"));
        HtmlWriter.write(new DiagnosisPage(diagnosis, pictures, provenance).page(), out.file("report.html"));
    }
}
