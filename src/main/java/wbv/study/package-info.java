/**
 * What a command asks and gets: requests, runs that drive the estimators over a recording with flat memory, and results as
 * records with one JSON form each. No HTML: {@code wbv.report} shows what is found here.
 *
 * <p>A study is run with a request and an {@link wbv.result.OutputFolder}, into which it writes its files for machines;
 * {@code summary()} says what matters most in a few lines.
 */
package wbv.study;
