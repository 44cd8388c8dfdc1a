package wbv.fleet.flink;

import org.apache.flink.api.common.functions.OpenContext;
import org.apache.flink.api.common.functions.RichMapFunction;
import org.apache.flink.api.java.tuple.Tuple3;
import wbv.fleet.FleetTable;

/** Results with the number of their period and their sensors' time [ms]. */
final class TimeOfRow extends RichMapFunction<String, Tuple3<Long, Long, String>> {

    private static final long serialVersionUID = 1;

    private final String header;
    private final double period;
    private final double rate;
    private transient FleetTable table;

    TimeOfRow(String header, double period, double rate) {
        this.header = header;
        this.period = period;
        this.rate = rate;
    }

    @Override
    public void open(OpenContext context) {
        table = new FleetTable(header, period, rate);
    }

    @Override
    public Tuple3<Long, Long, String> map(String row) {
        String bare = Rows.bare(row);
        FleetTable.Entry entry = table.entry(bare);
        return Tuple3.of(entry.period(), (long) (1000 * entry.time()), bare);
    }
}
