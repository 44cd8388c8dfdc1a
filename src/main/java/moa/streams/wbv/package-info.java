/** Names for wbv's streams: MOA's window lists classes of the package {@code moa} alone. Nothing here does anything of its own. */
package moa.streams.wbv;
