/** Benchmarks (JMH); {@code docs/benchmarks.md} has the command and the figures. */
package wbv.bench;
