package wbv.control.trial;

/**
 * Earth-moving machines as ISO 7096 sorts them: bands between two Butterworth edges, along z at the operator's floor.
 *
 * <p>The standard was not at hand. Edges and levels are those of the 2000 edition as a public implementation prints them
 * ({@code hvtestspectrum} 1.1 of the HVLab HRV Toolbox, C. Lewis, 2009); the r.m.s. from 0.89 to 11.22 Hz that they give, 1.71, 2.05,
 * 1.73 and 0.96 m/s² for EM1 to EM4, are those remembered of it. Machines and limits of SEAT are remembered only, hence assumed.
 */
public enum EarthMover implements Floor {
    EM1("rigid and articulated dumpers", 1.1, 2.82, 1.5, 4, 2.5, 4),
    EM2("scrapers", 0.9, 2.72, 1.5, 4, 3.0, 4),
    EM3("wheel loaders", 1.0, 1.93, 1.5, 4, 3.0, 4),
    EM4("graders", 1.1, 0.60, 1.5, 4, 3.0, 4),
    EM5("wheel dozers, soil compactors, backhoe loaders", 0.7, 1.11, 1.5, 4, 3.5, 1),
    EM6("crawler loaders, crawler dozers", 0.7, 0.79, 6.5, 2, 9.0, 2),
    EM7("compact dumpers", 0.6, 9.25, 3.0, 8, 3.5, 8),
    EM8("compact loaders", 0.8, 1.45, 3.0, 4, 3.0, 2),
    EM9("skid-steer loaders", 0.9, 2.10, 3.5, 4, 4.0, 2);

    private final String machines;
    private final double limit;
    private final double level;
    private final double low;
    private final int lowOrder;
    private final double high;
    private final int highOrder;

    EarthMover(String machines, double limit, double level, double low, int lowOrder, double high, int highOrder) {
        this.machines = machines;
        this.limit = limit;
        this.level = level;
        this.low = low;
        this.lowOrder = lowOrder;
        this.high = high;
        this.highOrder = highOrder;
    }

    @Override
    public String word() {
        return name();
    }

    @Override
    public String description() {
        return machines + " (ISO 7096:2000 as a public implementation prints it)";
    }

    /** The machines of the class. */
    public String machines() {
        return machines;
    }

    /** The SEAT value [1] that a seat for the class must stay below; assumed. */
    public double limit() {
        return limit;
    }

    @Override
    public double density(double frequency) {
        double below = Math.pow(frequency / low, 2 * lowOrder);
        return level * below / (1 + below) / (1 + Math.pow(frequency / high, 2 * highOrder));
    }
}
