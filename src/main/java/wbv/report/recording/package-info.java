/** What every report on a recording shows alike: what was read, where its sensors sit, where a response is not to be used. */
package wbv.report.recording;
