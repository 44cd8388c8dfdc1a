package wbv.stream;

import com.yahoo.labs.samoa.instances.Attribute;
import com.yahoo.labs.samoa.instances.DenseInstance;
import com.yahoo.labs.samoa.instances.Instance;
import com.yahoo.labs.samoa.instances.Instances;
import com.yahoo.labs.samoa.instances.InstancesHeader;
import java.io.IOException;
import java.io.Serializable;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.NoSuchElementException;
import moa.core.Example;
import moa.core.InstanceExample;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.RowReader;

/**
 * Rows as MOA instances. What is serialised is the place in the rows, not the open reader: a copy opens the rows itself and
 * goes on where the original stood.
 */
final class RowInstances implements Serializable {

    private static final long serialVersionUID = 1;

    /** Where rows come from, from the beginning each time. */
    interface Rows extends Serializable {
        RowReader open() throws IOException;

        /** Whether rows pass once: what is opened again is the same reader, and is not closed in between. */
        default boolean passes() {
            return false;
        }
    }

    private final Rows rows;
    private final Lost lost;
    private final InstancesHeader header;
    private final int[] columns;
    private final int width;
    private long taken;
    private transient RowReader reader;
    private transient double[] ahead;
    private transient boolean more;

    /**
     * @param name    relation name
     * @param inputs  channels that become attributes after t
     * @param output  channel that becomes the class
     * @param lost    what becomes of rows that lack one of these channels
     * @throws DataFault if the rows lack a channel
     */
    RowInstances(String name, Rows rows, List<Channel> inputs, Channel output, Lost lost) {
        this.rows = rows;
        this.lost = lost;
        List<Channel> wanted = new ArrayList<>(inputs);
        wanted.add(output);
        this.columns = new int[wanted.size()];
        List<Attribute> attributes = new ArrayList<>();
        attributes.add(new Attribute("t"));
        try {
            RowReader opened = rows.open();
            List<Channel> channels = opened.channels();
            if (!rows.passes()) {
                opened.close();
            }
            width = 1 + channels.size();
            for (int i = 0; i < columns.length; i++) {
                Channel channel = wanted.get(i);
                columns[i] = 1 + channels.indexOf(channel);
                if (columns[i] == 0) {
                    throw new DataFault("no channel " + channel + "; there are " + channels);
                }
                attributes.add(new Attribute(channel.toString()));
            }
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
        this.header = new InstancesHeader(new Instances(name, attributes, 0));
        this.header.setClassIndex(attributes.size() - 1);
    }

    InstancesHeader header() {
        return header;
    }

    /** Instances taken since the beginning. */
    long taken() {
        return taken;
    }

    boolean hasMore() {
        if (reader == null) {
            resume();
        }
        return more;
    }

    Example<Instance> next() {
        if (!hasMore()) {
            throw new NoSuchElementException("the stream has ended after " + taken + " instances");
        }
        DenseInstance instance = new DenseInstance(header.numAttributes());
        instance.setDataset(header);
        instance.setValue(0, ahead[0]);
        for (int i = 0; i < columns.length; i++) {
            instance.setValue(1 + i, ahead[columns[i]]);
        }
        taken++;
        readAhead();
        return new InstanceExample(instance);
    }

    /** @throws DataFault if rows pass once and some have passed */
    void restart() {
        if (rows.passes() && reader != null) {
            throw new DataFault("rows that pass once cannot be read from their beginning again");
        }
        close();
        taken = 0;
    }

    private void resume() {
        try {
            reader = rows.open();
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
        ahead = new double[width];
        for (long i = 0; i <= taken; i++) {
            readAhead();
        }
    }

    private void readAhead() {
        try {
            do {
                more = reader.read(ahead);
            } while (more && lost == Lost.SKIPPED && isLacking());
            if (!more) {
                reader.close();
            }
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }

    private boolean isLacking() {
        for (int column : columns) {
            if (Double.isNaN(ahead[column])) {
                return true;
            }
        }
        return false;
    }

    private void close() {
        if (reader != null) {
            try {
                reader.close();
            } catch (IOException failed) {
                throw new UncheckedIOException(failed);
            }
            reader = null;
        }
    }
}
