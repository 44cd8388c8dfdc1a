/**
 * A completed model in the words of other simulators: a Python function, Modelica, MuJoCo, a functional mock-up unit.
 *
 * <p>Each law is described once, as a few lines of arithmetic ({@link wbv.export.LawForm}), and printed in each language
 * ({@link wbv.export.Language}); what solves the model stands in resources, as it is read by those who open the file.
 */
package wbv.export;
