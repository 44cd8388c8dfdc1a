/** The reports of {@code wbv net}: training, readings and comparisons of networks. */
package wbv.report.network;
