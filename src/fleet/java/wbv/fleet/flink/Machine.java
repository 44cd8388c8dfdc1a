package wbv.fleet.flink;

import java.io.IOException;
import java.util.Arrays;
import org.apache.flink.runtime.entrypoint.StandaloneSessionClusterEntrypoint;
import org.apache.flink.runtime.taskexecutor.TaskManagerRunner;
import org.apache.flink.runtime.zookeeper.FlinkZooKeeperQuorumPeer;

/** A process of a cluster of our own. It ends with the one that started it, however that ended: its standard input ends then. */
public final class Machine {

    private Machine() {}

    /** Arguments: keeper, jobmanager or taskmanager, then their own. */
    public static void main(String[] words) throws Exception {
        endWithParent();
        String[] rest = Arrays.copyOfRange(words, 1, words.length);
        if (words[0].equals("keeper")) {
            FlinkZooKeeperQuorumPeer.main(rest);
        } else if (words[0].equals("jobmanager")) {
            StandaloneSessionClusterEntrypoint.main(rest);
        } else {
            TaskManagerRunner.main(rest);
        }
    }

    /** From now on this process ends when its standard input does. */
    static void endWithParent() {
        Thread watch = new Thread(Machine::endWithInput, "ends with its parent");
        watch.setDaemon(true);
        watch.start();
    }

    private static void endWithInput() {
        try {
            while (System.in.read() >= 0) {
                // nobody writes
            }
        } catch (IOException gone) {
            // as well
        }
        Runtime.getRuntime().halt(1);
    }
}
