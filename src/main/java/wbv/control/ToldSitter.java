package wbv.control;

/** A sitter of whom somebody tells: once, which is a fixed design, or whenever he changes. */
public final class ToldSitter implements SitterSource {

    private double rigid;
    private double moving;
    private double frequency;
    private double damping;

    /** One who is known exactly. */
    public ToldSitter(ApparentSitter sitter) {
        tell(sitter, 1);
    }

    /**
     * From now on this one.
     *
     * @param frequencies factor on his natural frequency from now on, &gt; 0
     */
    public void tell(ApparentSitter sitter, double frequencies) {
        rigid = sitter.rigid();
        moving = sitter.moving();
        frequency = frequencies * sitter.frequency();
        damping = sitter.damping();
    }

    @Override
    public void hear(SeatReadings readings) {
        // he is told
    }

    @Override
    public double rigid() {
        return rigid;
    }

    @Override
    public double moving() {
        return moving;
    }

    @Override
    public double frequency() {
        return frequency;
    }

    @Override
    public double damping() {
        return damping;
    }
}
