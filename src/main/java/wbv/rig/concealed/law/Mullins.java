package wbv.rig.concealed.law;

/**
 * A rubber that remembers how far it was stretched and is softer below (Mullins 1969), and heals: -loss k r (1 - |r|/p), p the largest |r|
 * so far, forgotten over a memory of seconds.
 */
public final class Mullins implements LinkPhysics {

    private final double loss;
    private final double fading;
    private double peak;

    /**
     * At rest.
     *
     * @param loss stiffness lost at rest [N/m]
     * @param memory [s]
     * @param least p at the start [m]
     * @param h step of the run [s]
     */
    public Mullins(double loss, double memory, double least, double h) {
        this.loss = loss;
        this.fading = Math.exp(-h / memory);
        this.peak = least;
    }

    @Override
    public double force(double t, double r, double v, double[] y, int at) {
        return -loss * r * Math.max(0, 1 - Math.abs(r) / peak);
    }

    @Override
    public void commit(double t, double r, double v) {
        peak = Math.max(peak * fading, Math.abs(r));
    }
}
