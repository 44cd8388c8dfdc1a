package wbv.fleet.flink;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.Optional;
import org.apache.flink.api.common.eventtime.WatermarkStrategy;
import org.apache.flink.api.common.serialization.SimpleStringEncoder;
import org.apache.flink.api.common.typeinfo.Types;
import org.apache.flink.api.connector.source.Source;
import org.apache.flink.api.java.tuple.Tuple2;
import org.apache.flink.api.java.tuple.Tuple3;
import org.apache.flink.client.ClientUtils;
import org.apache.flink.client.cli.ClientOptions;
import org.apache.flink.configuration.CheckpointingOptions;
import org.apache.flink.configuration.Configuration;
import org.apache.flink.configuration.DeploymentOptions;
import org.apache.flink.configuration.ExecutionOptions;
import org.apache.flink.configuration.ExternalizedCheckpointRetention;
import org.apache.flink.configuration.PipelineOptions;
import org.apache.flink.configuration.RestartStrategyOptions;
import org.apache.flink.configuration.StateRecoveryOptions;
import org.apache.flink.core.execution.JobClient;
import org.apache.flink.connector.file.sink.FileSink;
import org.apache.flink.streaming.api.datastream.DataStream;
import org.apache.flink.streaming.api.datastream.DataStreamSource;
import org.apache.flink.streaming.api.datastream.KeyedStream;
import org.apache.flink.streaming.api.datastream.SingleOutputStreamOperator;
import org.apache.flink.streaming.api.environment.StreamExecutionEnvironment;
import org.apache.flink.streaming.api.functions.sink.filesystem.bucketassigners.BasePathBucketAssigner;
import org.apache.flink.streaming.api.functions.sink.filesystem.rollingpolicies.OnCheckpointRollingPolicy;
import wbv.fleet.FleetOrder;
import wbv.fleet.FleetSource;
import wbv.fleet.ResultRows;

/** The job, and the process that hands it in and waits for its end. */
public final class FleetJob {

    static final String CHECKPOINTS = "checkpoints";
    private static final Duration HEARTBEAT = Duration.ofSeconds(10);
    /** A job whose client was not heard of for so long is given up: nobody would gather what it writes. */
    private static final Duration DEAF = Duration.ofSeconds(60);

    /** Seats are this far behind each other, or their tables are told again. */
    private static final Duration BEHIND = Duration.ofSeconds(10);
    /** Where no results come for so long, tables do not wait for them. */
    private static final Duration SILENT = Duration.ofSeconds(30);
    /** So long behind its end the table of a period is told again. */
    private static final Duration PERIODS_KEPT = Duration.ofHours(24);
    /** Seats are divided into so many parts, whatever the number of machines: it cannot be changed by whom goes on with a checkpoint. */
    private static final int MOST_PARALLEL = 128;

    /** Of seats that are replayed; a machine takes one after the other. */
    private static final int BLOCKS = 8;

    private FleetJob() {}

    /**
     * Hands the job in. Arguments: file of the order, folder for the parts, parallelism, time between checkpoints [ms], host, port,
     * then the jars that the machines need. It goes on with the newest checkpoint in the folder, if there is one.
     */
    public static void main(String[] words) {
        Machine.endWithParent();
        int code = 0;
        try {
            byte[] order = Files.readAllBytes(Path.of(words[0]));
            String[] jars = Arrays.copyOfRange(words, 6, words.length);
            Configuration settings = settings(Path.of(words[1]), Long.parseLong(words[3]));
            Checkpoints.newest(Path.of(words[1]).resolve(CHECKPOINTS)).ifPresent(
                    newest -> settings.set(StateRecoveryOptions.SAVEPOINT_PATH, newest.toUri().toString()));
            settings.set(DeploymentOptions.ATTACHED, true);
            settings.set(DeploymentOptions.SHUTDOWN_IF_ATTACHED, true);
            settings.set(ClientOptions.CLIENT_HEARTBEAT_TIMEOUT, DEAF);
            StreamExecutionEnvironment environment = StreamExecutionEnvironment.createRemoteEnvironment(words[4],
                    Integer.parseInt(words[5]), settings, jars);
            if (FleetOrder.of(order).source() instanceof FleetSource.Topic topic) {
                Topics.prepare(topic);
            }
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
        settings.set(PipelineOptions.MAX_PARALLELISM, MOST_PARALLEL);
        settings.set(ExecutionOptions.BUFFER_TIMEOUT, Duration.ofMillis(10));
        settings.set(CheckpointingOptions.CHECKPOINTING_INTERVAL, Duration.ofMillis(between));
        settings.set(CheckpointingOptions.CHECKPOINTS_DIRECTORY, parts.resolve(CHECKPOINTS).toUri().toString());
        settings.set(CheckpointingOptions.EXTERNALIZED_CHECKPOINT_RETENTION, ExternalizedCheckpointRetention.RETAIN_ON_CANCELLATION);
        // Others are used up while a machine that died still counts.
        settings.set(RestartStrategyOptions.RESTART_STRATEGY, "exponential-delay");
        settings.set(RestartStrategyOptions.RESTART_STRATEGY_EXPONENTIAL_DELAY_INITIAL_BACKOFF, Duration.ofSeconds(1));
        settings.set(RestartStrategyOptions.RESTART_STRATEGY_EXPONENTIAL_DELAY_MAX_BACKOFF, Duration.ofSeconds(10));
        return settings;
    }

    /**
     * The whole job.
     *
     * @param parts folder for the rows, where packets do not come from topics
     */
    static void build(StreamExecutionEnvironment environment, byte[] order, Path parts, int parallelism) {
        environment.setParallelism(parallelism);
        FleetOrder fleet = FleetOrder.of(order);
        if (fleet.source() instanceof FleetSource.Topic topic) {
            DataStream<Tuple3<Long, Double, String>> models = environment.fromSource(Topics.models(topic), WatermarkStrategy.noWatermarks(),
                    "models").setParallelism(1).uid("models");
            send(follow(from(environment, Topics.packets(topic), "packets").uid("packets"), Optional.of(models), fleet), topic);
        } else if (fleet.source() instanceof FleetSource.Packets given) {
            write(follow(from(environment, new PacketFileSource(given.files()), "files").setParallelism(1).uid("files"), Optional.empty(),
                    fleet), parts);
        } else {
            write(follow(from(environment, new ReplaySource(order, BLOCKS), "replay").uid("replay"), Optional.empty(), fleet), parts);
        }
    }

    private static DataStreamSource<Tuple2<Long, byte[]>> from(StreamExecutionEnvironment environment,
            Source<Tuple2<Long, byte[]>, ?, ?> source, String name) {
        return environment.fromSource(source, WatermarkStrategy.noWatermarks(), name, Types.TUPLE(Types.LONG,
                Types.PRIMITIVE_ARRAY(Types.BYTE)));
    }

    /** Rows of what is found out. */
    record Told(DataStream<String> results, DataStream<String> alarms, DataStream<String> machines, DataStream<String> worst,
            DataStream<String> unread) {}

    /**
     * What is done with packets.
     *
     * @param packets with their places
     * @param models  of states that come while the job runs: number, sensors' time from which it holds [s], text
     */
    static Told follow(DataStream<Tuple2<Long, byte[]>> packets, Optional<DataStream<Tuple3<Long, Double, String>>> models,
            FleetOrder fleet) {
        byte[] order = fleet.follow().bytes();
        double rate = fleet.follow().rate();
        String header = new ResultRows(fleet.follow().plan()).header();
        // Between more of them a seat's order is lost.
        var read = packets.process(new ReadPackets()).setParallelism(packets.getParallelism())
                .returns(Types.TUPLE(Types.LONG, Types.STRING, Types.PRIMITIVE_ARRAY(Types.BYTE))).name("read").uid("read");
        KeyedStream<Tuple3<Long, String, byte[]>, String> keyed = read.keyBy(each -> each.f1, Types.STRING);
        SingleOutputStreamOperator<String> followed = (models.isPresent()
                ? keyed.connect(models.get().broadcast(FollowSeatsByModels.MODELS)).process(new FollowSeatsByModels(order), Types.STRING)
                : keyed.process(new FollowSeats(order), Types.STRING)).name("follow").uid("follow");
        boolean ends = !(fleet.source() instanceof FleetSource.Topic topic) || topic.ends();
        // What is replayed or read from files is not of now: its tables are told once, at the end.
        WatermarkStrategy<Tuple3<Long, Long, String>> clock = fleet.source() instanceof FleetSource.Topic
                ? WatermarkStrategy.<Tuple3<Long, Long, String>>forBoundedOutOfOrderness(BEHIND).withIdleness(SILENT)
                : WatermarkStrategy.noWatermarks();
        SingleOutputStreamOperator<String> machines = followed.map(new TimeOfRow(header, fleet.period(), rate))
                .returns(Types.TUPLE(Types.LONG, Types.LONG, Types.STRING)).name("times").uid("times")
                .assignTimestampsAndWatermarks(clock.withTimestampAssigner((each, before) -> each.f1)).name("clock").uid("clock")
                .keyBy(each -> each.f0, Types.LONG)
                .process(new TablesOfPeriods(header, fleet.period(), rate, ends ? Long.MAX_VALUE : PERIODS_KEPT.toMillis()), Types.STRING)
                .name("tables").uid("tables");
        return new Told(followed, followed.getSideOutput(Rows.ALARMS), machines, machines.getSideOutput(Rows.WORST),
                read.getSideOutput(Rows.UNREAD).union(followed.getSideOutput(Rows.UNREAD)));
    }

    /** To files in a folder. */
    static void write(Told told, Path parts) {
        write(told.results, parts, Topics.RESULTS);
        write(told.alarms, parts, Topics.ALARMS);
        write(told.machines, parts, Topics.MACHINES);
        write(told.worst, parts, Topics.WORST);
        write(told.unread, parts, Topics.UNREAD);
    }

    private static void write(DataStream<String> rows, Path parts, String name) {
        rows.sinkTo(FileSink.forRowFormat(new org.apache.flink.core.fs.Path(parts.resolve(name).toUri()), new SimpleStringEncoder<String>())
                .withBucketAssigner(new BasePathBucketAssigner<>()).withRollingPolicy(OnCheckpointRollingPolicy.build()).build())
                .name(name).uid(name);
    }

    private static void send(Told told, FleetSource.Topic topic) {
        told.results.sinkTo(Topics.rows(topic, Topics.RESULTS)).name(Topics.RESULTS).uid(Topics.RESULTS);
        told.alarms.sinkTo(Topics.rows(topic, Topics.ALARMS)).name(Topics.ALARMS).uid(Topics.ALARMS);
        told.machines.sinkTo(Topics.rows(topic, Topics.MACHINES)).name(Topics.MACHINES).uid(Topics.MACHINES);
        told.worst.sinkTo(Topics.rows(topic, Topics.WORST)).name(Topics.WORST).uid(Topics.WORST);
        told.unread.sinkTo(Topics.rows(topic, Topics.UNREAD)).name(Topics.UNREAD).uid(Topics.UNREAD);
    }
}
