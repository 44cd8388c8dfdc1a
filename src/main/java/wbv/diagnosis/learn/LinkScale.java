package wbv.diagnosis.learn;

import wbv.diagnosis.fit.Evidence;

/**
 * In which units a link is drawn.
 *
 * @param turn      from metres, or radians, to the unit shown
 * @param deflection its unit
 * @param velocity its unit
 * @param effort what it carries
 * @param force     its unit
 * @param stiff from N/m, or N m/rad, to the unit shown
 * @param stiffness its unit
 * @param damping unit of a damping
 */
public record LinkScale(double turn, String deflection, String velocity, String effort, String force, double stiff, String stiffness,
        String damping) {

    static final LinkScale ALONG = new LinkScale(1e3, "mm", "mm/s", "Force", "N", 1e-3, "kN/m", "N·s/m");
    /** About an axis a link turns and carries a moment. */
    static final LinkScale ABOUT = new LinkScale(180 / Math.PI, "°", "°/s", "Moment", "N·m", 1, "N·m/rad", "N·m·s/rad");

    /** Millimetres and newtons for a link along an axis, degrees and newton metres for one about it. */
    public static LinkScale of(Evidence evidence, int link) {
        return evidence.model().about(evidence.model().links().get(link)) ? ABOUT : ALONG;
    }
}
