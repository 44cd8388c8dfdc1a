package wbv.live;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import wbv.recording.DataFault;
import wbv.recording.inspect.Severity;

/** Sources at work, each in a thread of its own, until the last has ended or someone stops them. */
public final class LiveRun {

    /** Between two looks at who has fallen silent [ms]. */
    private static final long BETWEEN = 500;

    private final LiveStream live;
    private final List<LineSource> sources;
    private final double pace;
    private final AtomicReference<RuntimeException> failure = new AtomicReference<>();
    private final CountDownLatch done = new CountDownLatch(1);
    private volatile boolean stopped;

    /**
     * Nothing runs yet.
     *
     * @param pace of a replay, as a multiple of real time [1]; infinite to take lines as fast as they come
     */
    public LiveRun(LiveStream live, List<LineSource> sources, double pace) {
        this.live = live;
        this.sources = List.copyOf(sources);
        this.pace = pace;
    }

    /**
     * Runs until all sources have ended.
     *
     * @throws DataFault if a source cannot be read on, after all others have ended
     */
    public void run() throws InterruptedException {
        try {
            List<Thread> threads = new ArrayList<>();
            for (LineSource source : sources) {
                Thread thread = new Thread(() -> work(source), "wbv-source");
                thread.setDaemon(true);
                thread.start();
                threads.add(thread);
            }
            for (Thread thread : threads) {
                while (thread.isAlive()) {
                    thread.join(BETWEEN);
                    live.tick();
                }
            }
            if (failure.get() != null && !stopped) {
                throw failure.get();
            }
        } finally {
            stop();
            done.countDown();
        }
    }

    private void work(LineSource source) {
        try {
            source.run(Double.isInfinite(pace) ? live : new Pacer(live, pace));
        } catch (IOException cannot) {
            if (!stopped) {
                live.tell(Severity.FAULT, "source", source.name() + " cannot be read on: " + cannot.getMessage(), "");
                failure.compareAndSet(null, DataFault.in(source.name(), "cannot be read on: " + cannot.getMessage(), cannot));
            }
        } catch (RuntimeException broken) {
            failure.compareAndSet(null, broken);
            stop();
        }
    }

    /** Ends all sources, from any thread. */
    public void stop() {
        stopped = failure.get() == null;
        for (LineSource source : sources) {
            try {
                source.close();
            } catch (IOException gone) {
                // it has ended all the same
            }
        }
    }

    /**
     * Waits until {@link #run} has ended.
     *
     * @param milliseconds at most
     */
    public void await(long milliseconds) throws InterruptedException {
        done.await(milliseconds, TimeUnit.MILLISECONDS);
    }
}
