/**
 * Poles of what is measured as bounds of what is not.
 *
 * <p>{@code PoleWindows} identifies windows of a recording, {@link wbv.pole.Density} gathers their poles into clusters
 * (DBSCAN and OPTICS of ELKI; Weka's EM beside them), and {@link wbv.pole.ConstraintPolygon} outlines where an attribute of a
 * measured place's pole was seen together with one of a place whose sensor will be taken away. Once it is, the value measured now
 * cuts the polygon, and the chord bounds what is not measured: {@link wbv.pole.RemovalRun}, sample by sample, and {@link
 * wbv.pole.OnlineRemoval}, which learns the polygons from the same stream.
 */
package wbv.pole;
