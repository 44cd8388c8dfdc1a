/** A name for wbv's change detector: MOA's window lists classes of the package {@code moa} alone. Nothing here does anything of its own. */
package moa.classifiers.core.driftdetection.wbv;
