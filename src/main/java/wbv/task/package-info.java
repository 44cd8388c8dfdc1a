/**
 * MOA tasks, and a runner of any MOA task that tells the truth about failures.
 */
package wbv.task;
