package wbv.fleet.flink;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.Set;
import java.util.concurrent.ExecutionException;
import org.apache.flink.api.common.typeinfo.TypeInformation;
import org.apache.flink.api.common.typeinfo.Types;
import org.apache.flink.api.connector.source.Source;
import org.apache.flink.api.java.tuple.Tuple2;
import org.apache.flink.api.java.tuple.Tuple3;
import org.apache.flink.connector.base.DeliveryGuarantee;
import org.apache.flink.connector.kafka.sink.KafkaRecordSerializationSchema;
import org.apache.flink.connector.kafka.sink.KafkaSink;
import org.apache.flink.connector.kafka.source.KafkaSource;
import org.apache.flink.connector.kafka.source.KafkaSourceBuilder;
import org.apache.flink.connector.kafka.source.enumerator.initializer.OffsetsInitializer;
import org.apache.flink.connector.kafka.source.reader.deserializer.KafkaRecordDeserializationSchema;
import org.apache.flink.util.Collector;
import org.apache.kafka.clients.admin.Admin;
import org.apache.kafka.clients.admin.NewTopic;
import org.apache.kafka.clients.consumer.ConsumerRecord;
import org.apache.kafka.clients.producer.ProducerConfig;
import org.apache.kafka.clients.producer.ProducerRecord;
import wbv.fleet.FleetSource;
import wbv.fleet.ResultRows;

/** Packets from topics of Kafka, and rows to topics, in transactions: who reads what is committed sees each row once. */
final class Topics {

    static final String RESULTS = "results";
    static final String ALARMS = "alarms";
    static final String MACHINES = "machines";
    static final String WORST = "worst";
    static final String UNREAD = "unread";
    static final String MODELS = "models";
    private static final List<String> ALL = List.of(RESULTS, ALARMS, MACHINES, WORST, UNREAD);
    /** Longer than any outage that is survived, and no longer than brokers allow unless they are told otherwise [ms]. */
    private static final String LONGEST_TRANSACTION = String.valueOf(15 * 60_000);

    private Topics() {}

    /** Makes those topics that are not there. That of the models has one partition: models have an order. */
    static void prepare(FleetSource.Topic topic) throws ExecutionException, InterruptedException {
        try (Admin admin = Admin.create(Map.of("bootstrap.servers", topic.brokers()))) {
            Set<String> there = admin.listTopics().names().get();
            List<NewTopic> missing = new ArrayList<>();
            for (String each : ALL) {
                if (!there.contains(name(topic, each))) {
                    missing.add(new NewTopic(name(topic, each), Optional.empty(), Optional.empty()));
                }
            }
            if (!there.contains(name(topic, MODELS))) {
                missing.add(new NewTopic(name(topic, MODELS), Optional.of(1), Optional.empty()));
            }
            admin.createTopics(missing).all().get();
        }
    }

    static String name(FleetSource.Topic topic, String what) {
        return topic.results() + "." + what;
    }

    static Source<Tuple2<Long, byte[]>, ?, ?> packets(FleetSource.Topic topic) {
        return source(topic, topic.topic(), new Packets());
    }

    static Source<Tuple3<Long, Double, String>, ?, ?> models(FleetSource.Topic topic) {
        return source(topic, name(topic, MODELS), new Models());
    }

    private static <T> Source<T, ?, ?> source(FleetSource.Topic topic, String name, KafkaRecordDeserializationSchema<T> form) {
        KafkaSourceBuilder<T> builder = KafkaSource.<T>builder().setBootstrapServers(topic.brokers()).setTopics(name)
                .setGroupId("wbv-fleet-" + topic.results()).setStartingOffsets(OffsetsInitializer.earliest()).setDeserializer(form)
                .setProperty("isolation.level", "read_committed").setProperty("commit.offsets.on.checkpoint", "true");
        if (topic.ends()) {
            return new EndingTopic<>(builder.setBounded(OffsetsInitializer.latest()).build());
        }
        return builder.build();
    }

    static KafkaSink<String> rows(FleetSource.Topic topic, String what) {
        Properties settings = new Properties();
        settings.setProperty(ProducerConfig.TRANSACTION_TIMEOUT_CONFIG, LONGEST_TRANSACTION);
        return KafkaSink.<String>builder().setBootstrapServers(topic.brokers()).setKafkaProducerConfig(settings)
                .setDeliveryGuarantee(DeliveryGuarantee.EXACTLY_ONCE).setTransactionalIdPrefix("wbv-fleet-" + name(topic, what))
                .setRecordSerializer(
                        what.equals(MACHINES) || what.equals(WORST) ? new Tables(name(topic, what)) : new Told(name(topic, what)))
                .build();
    }

    /** A packet a record. */
    static final class Packets implements KafkaRecordDeserializationSchema<Tuple2<Long, byte[]>> {

        private static final long serialVersionUID = 1;

        @Override
        public void deserialize(ConsumerRecord<byte[], byte[]> record, Collector<Tuple2<Long, byte[]>> out) {
            byte[] bytes = record.value();
            out.collect(Tuple2.of(Rows.place(record.offset(), record.partition()), bytes == null ? new byte[0] : bytes));
        }

        @Override
        public TypeInformation<Tuple2<Long, byte[]>> getProducedType() {
            return Types.TUPLE(Types.LONG, Types.PRIMITIVE_ARRAY(Types.BYTE));
        }
    }

    /** A model a record; its key is the sensors' time from which it holds [s], without one always. */
    static final class Models implements KafkaRecordDeserializationSchema<Tuple3<Long, Double, String>> {

        private static final long serialVersionUID = 1;

        @Override
        public void deserialize(ConsumerRecord<byte[], byte[]> record, Collector<Tuple3<Long, Double, String>> out) {
            String text = record.value() == null ? "" : new String(record.value(), StandardCharsets.UTF_8);
            out.collect(Tuple3.of(record.offset(), from(record.key()), text));
        }

        private static double from(byte[] key) {
            try {
                return key == null ? Double.NEGATIVE_INFINITY : Double.parseDouble(new String(key, StandardCharsets.UTF_8));
            } catch (NumberFormatException none) {
                return Double.NaN; // is put aside
            }
        }

        @Override
        public TypeInformation<Tuple3<Long, Double, String>> getProducedType() {
            return Types.TUPLE(Types.LONG, Types.DOUBLE, Types.STRING);
        }
    }

    /** Rows by their seat. */
    static final class Told implements KafkaRecordSerializationSchema<String> {

        private static final long serialVersionUID = 1;

        private final String topic;

        Told(String topic) {
            this.topic = topic;
        }

        @Override
        public ProducerRecord<byte[], byte[]> serialize(String row, KafkaSinkContext context, Long time) {
            String bare = Rows.bare(row);
            return new ProducerRecord<>(topic, bare.substring(0, ResultRows.firstField(bare)).getBytes(StandardCharsets.UTF_8),
                    bare.getBytes(StandardCharsets.UTF_8));
        }
    }

    /** Rows of tables, by period, so that what is told again comes behind what was told. */
    static final class Tables implements KafkaRecordSerializationSchema<String> {

        private static final long serialVersionUID = 1;

        private final String topic;

        Tables(String topic) {
            this.topic = topic;
        }

        @Override
        public ProducerRecord<byte[], byte[]> serialize(String row, KafkaSinkContext context, Long time) {
            Rows.Revised told = Rows.Revised.of(row);
            return new ProducerRecord<>(topic, String.valueOf(told.number()).getBytes(StandardCharsets.UTF_8),
                    told.row().getBytes(StandardCharsets.UTF_8));
        }
    }
}
