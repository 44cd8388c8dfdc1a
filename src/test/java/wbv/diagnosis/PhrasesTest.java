package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class PhrasesTest {

    @Test
    void whatIsNotAllToATenthOfAPercentIsNotSaidToBeAll() {
        assertEquals("100 %", Phrases.percent(1));
        assertEquals("100 %", Phrases.percent(0.9997));
        assertEquals("99.6 %", Phrases.percent(0.9958));
        assertEquals("88 %", Phrases.percent(0.884));
    }
}
