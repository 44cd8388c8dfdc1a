/** The report of {@code wbv frf}: frequency responses with their bands, coherences and models. */
package wbv.report.response;
