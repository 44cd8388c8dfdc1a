package wbv.control.trial;

/**
 * What a ride came to.
 *
 * @param seat       SEAT by r.m.s.: weighted acceleration of the seat pan over that of the floor, Wk both [1]
 * @param head the same of the head
 * @param strokeRms  root mean square of the deflection about its mean [m]
 * @param strokeMost greatest deflection [m]
 * @param stopHits   how often an end stop was reached
 * @param power mean mechanical power into the seat by the actuator, where it drives [W]
 * @param forceRms   of the actuator [N]
 * @param floorWeighted weighted r.m.s. of the floor [m/s²]
 * @param mass       all that the controller believed the seat to carry at the end [kg]; NaN if it believes nothing
 * @param frequency  the natural frequency that it believed in at the end [Hz]
 * @param damping the damping ratio
 */
public record TrialResult(double seat, double head, double strokeRms, double strokeMost, int stopHits, double power, double forceRms,
        double floorWeighted, double mass, double frequency, double damping) {

    /** Whether the seat stayed a seat: finite, and no deflection far beyond its stops. */
    public boolean stable() {
        return Double.isFinite(seat) && Double.isFinite(head) && strokeMost < 0.1 && seat < 5;
    }
}
