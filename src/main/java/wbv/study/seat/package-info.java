/** What {@code wbv seat} asks of simulated seats, and gets: a comparison of controllers, as sentences, as a table, for machines. */
package wbv.study.seat;
