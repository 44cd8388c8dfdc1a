package wbv.live;

/** Holds a replay back to a multiple of real time, by the times of its rows. */
final class Pacer implements LineSource.Receiver {

    private final LiveStream live;
    private final double speed;
    private double begun = Double.NaN;
    private long started;

    /** @param speed times real time, &gt; 0 */
    Pacer(LiveStream live, double speed) {
        this.live = live;
        this.speed = speed;
    }

    @Override
    public void line(String sender, String seat, byte[] text, int from, int to) {
        live.line(sender, seat, text, from, to);
        double time = live.time();
        if (Double.isNaN(time)) {
            return;
        }
        if (Double.isNaN(begun)) {
            begun = time;
            started = System.nanoTime();
        }
        double ahead = (time - begun) / speed - (System.nanoTime() - started) / 1e9;
        if (ahead > 0.002) {
            live.idle();
            try {
                Thread.sleep((long) Math.min(60_000, 1000 * ahead));
            } catch (InterruptedException ended) {
                Thread.currentThread().interrupt();
            }
        }
    }

    @Override
    public void tooLong(String sender, byte[] start, int length) {
        live.tooLong(sender, start, length);
    }

    @Override
    public void idle() {
        live.idle();
    }
}
