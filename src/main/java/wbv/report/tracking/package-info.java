/** The reports of {@code wbv track}: estimators over time, where filters come to rest, and places without their sensor. */
package wbv.report.tracking;
