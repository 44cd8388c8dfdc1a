package wbv.fleet.flink;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import org.apache.flink.api.common.eventtime.WatermarkStrategy;
import org.apache.flink.api.common.serialization.SimpleStringEncoder;
import org.apache.flink.api.common.typeinfo.Types;
import org.apache.flink.api.java.tuple.Tuple2;
import org.apache.flink.client.ClientUtils;
import org.apache.flink.client.cli.ClientOptions;
import org.apache.flink.configuration.CheckpointingOptions;
import org.apache.flink.configuration.Configuration;
import org.apache.flink.configuration.DeploymentOptions;
import org.apache.flink.configuration.ExecutionOptions;
import org.apache.flink.configuration.PipelineOptions;
import org.apache.flink.configuration.RestartStrategyOptions;
import org.apache.flink.core.execution.JobClient;
import org.apache.flink.connector.file.sink.FileSink;
import org.apache.flink.streaming.api.datastream.DataStream;
import org.apache.flink.streaming.api.datastream.SingleOutputStreamOperator;
import org.apache.flink.streaming.api.environment.StreamExecutionEnvironment;
import org.apache.flink.streaming.api.functions.sink.filesystem.bucketassigners.BasePathBucketAssigner;
import org.apache.flink.streaming.api.functions.sink.filesystem.rollingpolicies.OnCheckpointRollingPolicy;
import wbv.fleet.FleetOrder;

/** The job, and the process that hands it in and waits for its end. */
public final class FleetJob {

    private static final Duration HEARTBEAT = Duration.ofSeconds(10);
    /** A job whose client was not heard of for so long is given up: nobody would gather what it writes. */
    private static final Duration DEAF = Duration.ofSeconds(60);

    private FleetJob() { }

    /**
     * Hands the job in. Arguments: file of the order, folder for the parts, parallelism, time between checkpoints [ms], host, port,
     * then the jars that the machines need.
     */
    public static void main(String[] words) {
        Machine.endWithParent();
        int code = 0;
        try {
            byte[] order = Files.readAllBytes(Path.of(words[0]));
            String[] jars = Arrays.copyOfRange(words, 6, words.length);
            Configuration settings = settings(Path.of(words[1]), Long.parseLong(words[3]));
            settings.set(DeploymentOptions.ATTACHED, true);
            settings.set(DeploymentOptions.SHUTDOWN_IF_ATTACHED, true);
            settings.set(ClientOptions.CLIENT_HEARTBEAT_TIMEOUT, DEAF);
            StreamExecutionEnvironment environment =
                    StreamExecutionEnvironment.createRemoteEnvironment(words[4], Integer.parseInt(words[5]), settings, jars);
            build(environment, order, Path.of(words[1]), Integer.parseInt(words[2]));
            JobClient job = environment.executeAsync("wbv fleet");
            ClientUtils.reportHeartbeatPeriodically(job, HEARTBEAT.toMillis(), DEAF.toMillis());
            job.getJobExecutionResult().get();
        } catch (Exception failed) {
            failed.printStackTrace();
            code = 1;
        }
        System.exit(code); // Flink's threads live on
    }

    /** What the job asks of any cluster. */
    static Configuration settings(Path parts, long between) {
        Configuration settings = new Configuration();
        settings.set(PipelineOptions.GENERIC_TYPES, false);
        settings.set(PipelineOptions.AUTO_GENERATE_UIDS, false); // a checkpoint finds its operators by the names that we gave them
        settings.set(PipelineOptions.OBJECT_REUSE, true);
        settings.set(ExecutionOptions.BUFFER_TIMEOUT, Duration.ofMillis(10));
        settings.set(CheckpointingOptions.CHECKPOINTING_INTERVAL, Duration.ofMillis(between));
        settings.set(CheckpointingOptions.CHECKPOINTS_DIRECTORY, parts.resolve("checkpoints").toUri().toString());
        // Others are used up while a machine that died still counts.
        settings.set(RestartStrategyOptions.RESTART_STRATEGY, "exponential-delay");
        settings.set(RestartStrategyOptions.RESTART_STRATEGY_EXPONENTIAL_DELAY_INITIAL_BACKOFF, Duration.ofSeconds(1));
        settings.set(RestartStrategyOptions.RESTART_STRATEGY_EXPONENTIAL_DELAY_MAX_BACKOFF, Duration.ofSeconds(10));
        return settings;
    }

    static void build(StreamExecutionEnvironment environment, byte[] order, Path parts, int parallelism) throws IOException {
        environment.setParallelism(parallelism);
        build(environment.fromSource(new ReplaySource(order, parallelism), WatermarkStrategy.noWatermarks(), "replay",
                Types.TUPLE(Types.LONG, Types.PRIMITIVE_ARRAY(Types.BYTE))).uid("replay"), order, parts);
    }

    /** @param packets with their places */
    static void build(DataStream<Tuple2<Long, byte[]>> packets, byte[] order, Path parts) {
        FleetOrder fleet = FleetOrder.of(order);
        var read = packets.process(new ReadPackets())
                .returns(Types.TUPLE(Types.LONG, Types.STRING, Types.PRIMITIVE_ARRAY(Types.BYTE))).name("read").uid("read");
        SingleOutputStreamOperator<String> followed = read.keyBy(each -> each.f1, Types.STRING)
                .process(new FollowSeats(fleet.follow().bytes(), Rows.place(fleet.replay().rounds(), 0))).returns(Types.STRING)
                .name("follow").uid("follow");
        write(followed, parts, "results");
        write(followed.getSideOutput(Rows.ALARMS), parts, "alarms");
        write(read.getSideOutput(Rows.UNREAD).union(followed.getSideOutput(Rows.UNREAD)), parts, "unread");
    }

    private static void write(DataStream<String> rows, Path parts, String name) {
        rows.sinkTo(FileSink.forRowFormat(new org.apache.flink.core.fs.Path(parts.resolve(name).toUri()), new SimpleStringEncoder<String>())
                .withBucketAssigner(new BasePathBucketAssigner<>()).withRollingPolicy(OnCheckpointRollingPolicy.build()).build())
                .name(name).uid(name);
    }
}
