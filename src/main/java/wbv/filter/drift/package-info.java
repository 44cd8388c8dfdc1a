/**
 * Whether what was learned still holds: {@link wbv.filter.drift.Alarm} is the port through which any detector of changes watches a stream,
 * {@link wbv.filter.drift.Adwin} (Bifet and Gavaldà 2007) the usual one, and {@link wbv.filter.drift.ChangeTest} what an estimator asks of
 * its innovations.
 */
package wbv.filter.drift;
