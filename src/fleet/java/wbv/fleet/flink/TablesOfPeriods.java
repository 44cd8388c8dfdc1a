package wbv.fleet.flink;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.apache.flink.api.common.functions.OpenContext;
import org.apache.flink.api.common.state.MapState;
import org.apache.flink.api.common.state.MapStateDescriptor;
import org.apache.flink.api.common.state.ValueState;
import org.apache.flink.api.common.state.ValueStateDescriptor;
import org.apache.flink.api.common.typeinfo.Types;
import org.apache.flink.api.java.tuple.Tuple3;
import org.apache.flink.streaming.api.functions.KeyedProcessFunction;
import org.apache.flink.util.Collector;
import wbv.fleet.FleetTable;

/**
 * {@link FleetTable} of one period a key: told when the sensors' time has passed its end, and again when a seat that was behind tells
 * of it. Later tables replace earlier ones; the last is that of one process.
 */
final class TablesOfPeriods extends KeyedProcessFunction<Long, Tuple3<Long, Long, String>, String> {

    private static final long serialVersionUID = 1;

    /** What comes late is waited for so long, before a table is told again [ms of the sensors' time]. */
    private static final long AGAIN = 60_000;

    private final String header;
    private final double period;
    private final double rate;
    private final long kept;
    private transient FleetTable table;
    private transient MapState<String, String> rows;
    private transient ValueState<Integer> told;

    /** @param kept how long behind its end a period is kept [ms]; who tells of it later is not in the tables */
    TablesOfPeriods(String header, double period, double rate, long kept) {
        this.header = header;
        this.period = period;
        this.rate = rate;
        this.kept = kept;
    }

    @Override
    public void open(OpenContext context) {
        table = new FleetTable(header, period, rate);
        rows = getRuntimeContext().getMapState(new MapStateDescriptor<>("rows", Types.STRING, Types.STRING));
        told = getRuntimeContext().getState(new ValueStateDescriptor<>("told", Types.INT));
    }

    private long end(long number) {
        return (long) Math.ceil((number + 1) * period * 1000);
    }

    @Override
    public void processElement(Tuple3<Long, Long, String> result, Context context, Collector<String> out) throws Exception {
        long end = end(result.f0);
        long now = context.timerService().currentWatermark();
        if (now > Long.MIN_VALUE && now - kept > end) {
            return;
        }
        FleetTable.Entry entry = table.entry(result.f2);
        rows.put(entry.seat(), result.f2);
        context.timerService().registerEventTimeTimer(now < end ? end : (now / AGAIN + 1) * AGAIN);
        if (kept < Long.MAX_VALUE) {
            context.timerService().registerEventTimeTimer(end + kept);
        }
    }

    @Override
    public void onTimer(long time, OnTimerContext context, Collector<String> out) throws Exception {
        long number = context.getCurrentKey();
        if (kept < Long.MAX_VALUE && time >= end(number) + kept) {
            rows.clear();
            told.clear();
            return;
        }
        List<FleetTable.Entry> entries = new ArrayList<>();
        for (String row : rows.values()) {
            entries.add(table.entry(row));
        }
        int revision = told.value() == null ? 0 : told.value() + 1;
        told.update(revision);
        StringBuilder text = new StringBuilder();
        table.machines(entries, text);
        write(number, revision, text, out::collect);
        text.setLength(0);
        table.worst(entries, text);
        write(number, revision, text, row -> context.output(Rows.WORST, row));
    }

    private static void write(long number, int revision, StringBuilder rows, Consumer<String> to) {
        int k = 0;
        for (String row : rows.toString().split("\n")) {
            to.accept(Rows.revised(number, revision, k++, row));
        }
    }
}
