/** The report of {@code wbv exposure}: a day against the action and limit values, comfort, and the spine. */
package wbv.report.exposure;
