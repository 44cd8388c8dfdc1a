/** The command line: one class a command. Exit codes: 0 done, 1 the data or the model is at fault, 2 wrong usage, 3 our fault. */
package wbv.cli;
