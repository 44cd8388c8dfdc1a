/**
 * The search for what is missing: it proposes and weighs, and gives no verdict. {@link wbv.diagnosis.search.Locator} asks where,
 * {@link wbv.diagnosis.search.Screening} how much each mechanism promises, {@link wbv.diagnosis.search.Refinement} what it keeps of that by
 * free run, and {@link wbv.diagnosis.search.PairSearch} whether two do it together.
 */
package wbv.diagnosis.search;
