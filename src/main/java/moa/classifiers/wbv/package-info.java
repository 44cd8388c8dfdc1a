/** Names for wbv's learners: MOA's window lists classes of the package {@code moa} alone. Nothing here does anything of its own. */
package moa.classifiers.wbv;
