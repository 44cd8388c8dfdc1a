/**
 * How results are written: a folder that is written whole or not at all ({@link wbv.result.OutputFolder}), JSON whose numbers read
 * back equal ({@link wbv.result.ResultsJson}), and numbers as people read them ({@link wbv.result.Digits}).
 */
package wbv.result;
