package wbv.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TableTextTest {

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '~', value = {
        "haul road|haul road", "=1+1|\"'=1+1\"", "@SUM(A1)|\"'@SUM(A1)\"", "-2+3+cmd|\"'-2+3+cmd\"", "~ =1~|\"' =1\"",
        "-12.5|-12.5", "+1e-3|+1e-3", "5-6|5-6", "empty, loaded|\"empty, loaded\"", "say \"ho\"|\"say \"\"ho\"\"\"",
        "=A1&\"x\"|\"'=A1&\"\"x\"\"\""})
    void aCellIsNoFormulaAndANumberStaysANumber(String text, String cell) {
        assertEquals(cell, TableText.cell(text));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '~', value = {
        "task: haul road, loaded|task: haul road, loaded", "task: x,=HYPERLINK(1)|task: x,'=HYPERLINK(1)",
        "source: a;@b; -c|source: a;'@b;' -c", "lever: -0.1, +0.2,3|lever: -0.1, +0.2,3", "~one\ntwo~|one two"})
    void aCommentHasNoFormulaBehindAComma(String text, String comment) {
        assertEquals(comment, TableText.comment(text));
        assertEquals(comment, TableText.comment(TableText.comment(text)));
    }
}
