package wbv.control;

/**
 * Observes the seat's states and asks for the force that costs least, in the mean or at worst, of an actuator, or, clipped to what it
 * can do of it, of an adjustable damper. It designs itself anew, a doubling a sample, whenever its source tells of another sitter.
 *
 * <p>A lost reading is foreseen. While frame or deflection, or with a damper the floor, are silent for longer than
 * {@value #PATIENCE_MS} ms, it is a passive seat. An actuator that sings loses authority.
 */
public final class OptimalSeat implements SeatController {

    /** What obeys. */
    public enum Drive {
        /** A damper between its least and its most damping. */
        DAMPER,
        /** A force within its limits, beside a damper that is left alone. */
        ACTUATOR
    }

    /** What is made least. */
    public enum Aim {
        /** The mean cost: linear quadratic Gaussian. */
        MEAN,
        /** The cost of the worst that floor, friction and sensors can do: H∞. */
        WORST
    }

    /** Damping beside an actuator, and of any seat whose sensors are silent [N·s/m]; assumed. */
    public static final double RESERVE = 500;
    /** Damping beside an actuator that works [N·s/m]; assumed. */
    public static final double BESIDE = 200;
    static final int PATIENCE_MS = 50;

    private static final int PATIENCE = (int) (PATIENCE_MS * RATE / 1000);
    /** Share by which a sitter's number has to change for a new design. */
    private static final double CHANGED = 0.03;
    /** A force that no state of a sound seat asks for [N]. */
    private static final double ABSURD = 1e5;

    private final SeatHardware hardware;
    private final Drive drive;
    private final double base;
    private final SitterSource sitter;
    private final SeatModel model;
    private final SeatDesign design;
    private final OptimalGains gains = new OptimalGains();
    private final RelativeMotion relative;
    private final SingingGuard guard = new SingingGuard();
    private final double[] designed = new double[4];
    private boolean designing;
    private long withoutFrame;
    private long withoutDeflection;
    private long withoutFloor;

    /**
     * At rest.
     *
     * @param price of 20 mm of stroke in weighted acceleration [(m/s²)²], &gt; 0
     * @param sitter owned by the controller from now on
     */
    public OptimalSeat(SeatHardware hardware, Drive drive, Aim aim, FloorBand floor, double price, SitterSource sitter) {
        this.hardware = hardware;
        this.drive = drive;
        this.base = drive == Drive.DAMPER ? hardware.leastDamping() : BESIDE;
        this.sitter = sitter;
        this.relative = new RelativeMotion(hardware);
        this.model = new SeatModel(hardware, floor, price);
        this.design = switch (aim) {
            case MEAN -> new MeanDesign(model, base);
            case WORST -> new WorstDesign(model, base);
        };
        begin();
        while (designing) {
            advance();
        }
    }

    @Override
    public void step(SeatReadings readings, SeatCommand command) {
        sitter.hear(readings);
        relative.step(readings);
        keepUp();
        gains.correct(readings.deflection(), readings.floor(), readings.frame());
        listen(readings);
        double asked = gains.force();
        if (!(Math.abs(asked) < ABSURD)) {
            gains.rest();
            asked = 0;
        }
        if (blind()) {
            command.set(hardware.clipDamping(RESERVE), 0);
            gains.foresee(-(RESERVE - base) * relative.rate());
        } else if (drive == Drive.ACTUATOR) {
            command.set(BESIDE, hardware.clipForce(guard.authority() * asked));
            guard.hear(command.force());
            gains.foresee(command.force());
        } else {
            double damping = hardware.clipDamping(base - relative.damping(asked));
            command.set(damping, 0);
            gains.foresee(-(damping - base) * relative.rate());
        }
    }

    private void listen(SeatReadings readings) {
        withoutFrame = Double.isFinite(readings.frame()) ? 0 : withoutFrame + 1;
        withoutDeflection = Double.isFinite(readings.deflection()) ? 0 : withoutDeflection + 1;
        withoutFloor = Double.isFinite(readings.floor()) ? 0 : withoutFloor + 1;
    }

    /** A damper's force goes by the suspension's rate, which both accelerations tell at once. */
    private boolean blind() {
        return withoutFrame > PATIENCE || withoutDeflection > PATIENCE || drive == Drive.DAMPER && withoutFloor > PATIENCE;
    }

    private void keepUp() {
        if (designing) {
            advance();
        } else if (another()) {
            begin();
        }
    }

    private boolean another() {
        return changed(0, sitter.rigid()) || changed(1, sitter.moving()) || changed(2, sitter.frequency())
                || changed(3, sitter.damping());
    }

    private boolean changed(int i, double now) {
        return Math.abs(now - designed[i]) > CHANGED * designed[i];
    }

    private void begin() {
        designed[0] = sitter.rigid();
        designed[1] = sitter.moving();
        designed[2] = sitter.frequency();
        designed[3] = sitter.damping();
        design.begin(sitter);
        designing = true;
    }

    /** A design that does not come about leaves the last one. */
    private void advance() {
        if (design.advance()) {
            if (design.ready()) {
                gains.take(model, design);
            }
            designing = false;
        }
    }
}
