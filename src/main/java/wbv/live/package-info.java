/**
 * Streams without an end: sources of samples, their clock and faults watched as they come, every seat followed, what is known told
 * as lines of JSON and on a page that moves. Memory does not grow with time, nor with what a sender says.
 */
package wbv.live;
