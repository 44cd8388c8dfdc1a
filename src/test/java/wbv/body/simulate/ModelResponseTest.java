package wbv.body.simulate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.body.Model;
import wbv.body.PublishedModels;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.signal.ComplexSeries;
import wbv.signal.Segmentation;

class ModelResponseTest {

    private static final Channel BASE = Channel.parse("platform.acc.z");
    private static final Channel HEAD = Channel.parse("head.acc.z");

    /** |head/seat| at 2, 5 and 10 Hz, solved from the mass matrix elsewhere; at bins of 1/16 Hz. */
    @ParameterizedTest
    @CsvSource({"allen-1978-2dof, 2, 1.129444", "allen-1978-2dof, 5, 1.458062", "allen-1978-2dof, 10, 1.279637"})
    void transmissibilityIsExactAtTheBins(String name, double f, double modulus) throws IOException {
        ModelResponse response = new ModelResponse(PublishedModels.open(name), new Segmentation(64, 1024, 0.5));
        assertEquals(modulus, response.of(BASE, HEAD).magnitude((int) (16 * f)), 1e-6);
    }

    /** A single mass m0 + m on a spring: M = m0 + m (2ζωs+ω²)/(s²+2ζωs+ω²), for Wei and Griffin's 1998 model. */
    @Test
    void apparentMassIsTheClosedForm() throws IOException {
        Model model = PublishedModels.open("wei-griffin-1998-1dof");
        ComplexSeries mass = new ModelResponse(model, new Segmentation(64, 512, 0.5)).apparentMass();
        double m = model.bodies().get(0).mass();
        double k = model.links().get(0).stiffness();
        double c = model.links().get(0).damping();
        for (int bin = 1; bin < 220; bin++) {
            double w = 2 * Math.PI * bin / 8;
            double below = (k - m * w * w) * (k - m * w * w) + c * c * w * w;
            double re = (k * (k - m * w * w) + c * c * w * w) / below;
            double im = -c * w * m * w * w / below;
            assertEquals(model.base().mass() + m * re, mass.re()[bin], 1e-9);
            assertEquals(m * im, mass.im()[bin], 1e-9);
        }
        assertTrue(Double.isNaN(mass.re()[0]) && Double.isNaN(mass.re()[256]));
    }

    @Test
    void whatTheModelDoesNotHaveIsSaid() throws IOException {
        ModelResponse response = new ModelResponse(PublishedModels.open("wei-griffin-1998-1dof"), new Segmentation(60, 512, 0.5));
        Channel knee = Channel.parse("knee.acc.z");
        assertFalse(response.has(BASE, knee));
        assertTrue(assertThrows(DataFault.class, () -> response.of(BASE, knee)).getMessage().contains("no sensor knee.acc.z"));
        assertTrue(assertThrows(DataFault.class, () -> response.of(knee, HEAD)).getMessage().contains("not by knee.acc.z"));
    }
}
