package wbv.fleet.flink;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.apache.flink.api.common.functions.MapFunction;
import org.apache.flink.api.java.tuple.Tuple2;
import org.apache.flink.streaming.api.datastream.DataStream;

/** Lets packets pass one after the other, so that there is time for something to happen between. */
final class Slow implements MapFunction<Tuple2<Long, byte[]>, Tuple2<Long, byte[]>> {

    private static final long serialVersionUID = 1;

    /** Whether the next packet makes the job fail, once. Of the tests in this process. */
    static final AtomicBoolean FAIL = new AtomicBoolean();

    /** Packets that passed, of all jobs in this process. */
    static final AtomicInteger PASSED = new AtomicInteger();

    private final int pause;

    /** @param pause after each packet [ms] */
    Slow(int pause) {
        this.pause = pause;
    }

    static DataStream<Tuple2<Long, byte[]>> down(DataStream<Tuple2<Long, byte[]>> packets, int pause) {
        return packets.map(new Slow(pause)).setParallelism(packets.getParallelism()).returns(packets.getType()).name("slow").uid("slow");
    }

    @Override
    public Tuple2<Long, byte[]> map(Tuple2<Long, byte[]> packet) throws InterruptedException {
        if (FAIL.getAndSet(false)) {
            throw new IllegalStateException("a failure that the test asked for");
        }
        PASSED.incrementAndGet();
        Thread.sleep(pause);
        return packet;
    }
}
