package wbv.stream;

import com.github.javacliparser.IntOption;
import com.github.javacliparser.MultiChoiceOption;
import com.github.javacliparser.StringOption;
import com.yahoo.labs.samoa.instances.Instance;
import com.yahoo.labs.samoa.instances.InstancesHeader;
import java.util.Arrays;
import java.util.List;
import moa.core.Example;
import moa.core.ObjectRepository;
import moa.options.AbstractOptionHandler;
import moa.streams.InstanceStream;
import moa.tasks.TaskMonitor;
import wbv.recording.Channel;
import wbv.recording.RowReader;
import wbv.rig.RigSpec;

/**
 * A simulated experiment as a MOA stream. The experiment is a line of words as {@link RigSpec#parse} reads it; between
 * quotes, because a MOA option with spaces needs them: {@code -e 'sitter=one-dof zeta=0.35 f0=5 seconds=60'}.
 */
public class RigStream extends AbstractOptionHandler implements InstanceStream {

    private static final long serialVersionUID = 1;

    public final StringOption experimentOption = new StringOption("experiment", 'e',
            "The experiment in words, such as 'subject=2 regime=4 seconds=120'.", "sitter=one-dof");
    public final IntOption seedOption = new IntOption("seed", 'r',
            "Seed of everything random; goes before a seed in the experiment unless it is 0.", 0, 0, Integer.MAX_VALUE);
    public final StringOption inputOption = new StringOption("input", 'i',
            "Input channels, separated by commas.", "platform.acc.z");
    public final StringOption outputOption = new StringOption("output", 'o',
            "Output channel: the class attribute.", "head.acc.z");
    /** What becomes of samples that were lost. */
    public final MultiChoiceOption lostOption = Lost.option();

    private RowInstances instances;
    private long length;

    @Override
    public String getPurposeString() {
        return "A simulated sitter on a motion platform, as inertial sensors report it.";
    }

    @Override
    protected void prepareForUseImpl(TaskMonitor monitor, ObjectRepository repository) {
        RigSpec spec = RigSpec.parse(experimentOption.getValue());
        if (seedOption.getValue() != 0) {
            spec = spec.withSeed(seedOption.getValue());
        }
        length = spec.rows();
        List<Channel> inputs = Arrays.stream(inputOption.getValue().split(",")).map(Channel::parse).toList();
        instances = new RowInstances(getCLICreationString(InstanceStream.class), new Experiment(spec.toString()), inputs,
                Channel.parse(outputOption.getValue()), Lost.of(lostOption));
    }

    /** The words of an experiment, which serialise where one that is being played does not. */
    private record Experiment(String words) implements RowInstances.Rows {
        @Override
        public RowReader open() {
            return RigSpec.parse(words).run();
        }
    }

    @Override
    public InstancesHeader getHeader() {
        return instances.header();
    }

    @Override
    public boolean hasMoreInstances() {
        return instances.hasMore();
    }

    @Override
    public Example<Instance> nextInstance() {
        return instances.next();
    }

    @Override
    public long estimatedRemainingInstances() {
        return length - instances.taken();
    }

    @Override
    public boolean isRestartable() {
        return true;
    }

    @Override
    public void restart() {
        instances.restart();
    }

    @Override
    public void getDescription(StringBuilder out, int indent) {
        out.append(getPurposeString());
    }
}
