/** The report of {@code wbv diagnose}, so that a person can believe a diagnosis, or not, by looking. */
package wbv.report.diagnosis;
