package wbv.recording.signals;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.OutputStream;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.apache.parquet.column.ColumnWriteStore;
import org.apache.parquet.column.ColumnWriter;
import org.apache.parquet.column.ParquetProperties;
import org.apache.parquet.hadoop.ColumnChunkPageWriteStore;
import org.apache.parquet.compression.CompressionCodecFactory.BytesInputCompressor;
import org.apache.parquet.hadoop.ParquetFileWriter;
import org.apache.parquet.hadoop.ParquetWriter;
import org.apache.parquet.io.OutputFile;
import org.apache.parquet.io.PositionOutputStream;
import org.apache.parquet.schema.MessageType;
import org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName;
import org.apache.parquet.schema.Types;
import wbv.recording.Channel;
import wbv.recording.Header;
import wbv.recording.Json;

/**
 * Writes Parquet: {@code t} [s] and the channels in SI as doubles, null where a sample is missing, compressed by Zstandard. Rate and units
 * stand in the footer, once as they are and once as what pandas makes {@code DataFrame.attrs} of.
 */
final class ParquetFile {

    /** Rows that whoever reads has in memory at once: some 60 MB of sixty channels. */
    private static final int GROUP = 1 << 17;

    private ParquetFile() {}

    static void write(SampledColumns columns, OutputStream out) throws IOException {
        MessageType schema = schema(columns.channels());
        try (ParquetFileWriter file = new ParquetFileWriter(new Output(out), schema, ParquetFileWriter.Mode.CREATE,
                ParquetWriter.DEFAULT_BLOCK_SIZE, 0)) {
            file.start();
            for (int from = 0; from < columns.length(); from += GROUP) {
                group(columns, from, Math.min(columns.length(), from + GROUP), schema, file);
            }
            file.end(footer(columns));
        }
    }

    private static MessageType schema(List<Channel> channels) {
        Types.GroupBuilder<MessageType> schema = Types.buildMessage().required(PrimitiveTypeName.DOUBLE).named(Header.TIME);
        channels.forEach(channel -> schema.optional(PrimitiveTypeName.DOUBLE).named(channel.toString()));
        return schema.named("recording");
    }

    private static void group(SampledColumns columns, int from, int to, MessageType schema, ParquetFileWriter file) throws IOException {
        ParquetProperties properties = ParquetProperties.builder().build();
        BytesInputCompressor codec = new PageCodecs(columns.file()).getCompressor(PageCodecs.WRITTEN);
        try (ColumnChunkPageWriteStore pages = ColumnChunkPageWriteStore.builder().withCompressorProvider(column -> codec)
                .withSchema(schema).withAllocator(properties.getAllocator())
                .withColumnIndexTruncateLength(properties.getColumnIndexTruncateLength()).withPageWriteChecksumEnabled(true).build();
                ColumnWriteStore store = properties.newColumnWriteStore(schema, pages, pages)) {
            List<ColumnWriter> writers = schema.getColumns().stream().map(store::getColumnWriter).toList();
            for (int i = from; i < to; i++) {
                writers.get(0).write(columns.time(i), 0, 0);
                for (int j = 1; j < writers.size(); j++) {
                    double value = columns.value(j - 1, i);
                    if (Double.isNaN(value)) {
                        writers.get(j).writeNull(0, 0);
                    } else {
                        writers.get(j).write(value, 0, 1);
                    }
                }
                store.endRecord();
            }
            store.flush();
            file.startBlock(to - from);
            pages.flushToFileWriter(file);
            file.endBlock();
        }
    }

    private static Map<String, String> footer(SampledColumns columns) {
        ObjectNode said = Json.MAPPER.createObjectNode();
        columns.stated().ifPresent(rate -> said.put(ParquetSignals.RATE, rate));
        ObjectNode units = said.putObject(ParquetSignals.UNITS).put(Header.TIME, "s");
        columns.channels().stream().filter(channel -> !channel.quantity().unit().isEmpty())
                .forEach(channel -> units.put(channel.toString(), channel.quantity().unit()));
        Map<String, String> footer = new LinkedHashMap<>();
        said.fields().forEachRemaining(field -> footer.put(field.getKey(), field.getValue().toString()));
        footer.put(ParquetSignals.PANDAS, said.toString());
        return footer;
    }

    /** A stream as Parquet wants its files; it stays open. */
    private record Output(OutputStream out) implements OutputFile {

        @Override
        public PositionOutputStream create(long blockSize) {
            return new Counted(out);
        }

        @Override
        public PositionOutputStream createOrOverwrite(long blockSize) {
            return create(blockSize);
        }

        @Override
        public boolean supportsBlockSize() {
            return false;
        }

        @Override
        public long defaultBlockSize() {
            return 0;
        }
    }

    private static final class Counted extends PositionOutputStream {

        private final OutputStream out;
        private long written;

        private Counted(OutputStream out) {
            this.out = out;
        }

        @Override
        public long getPos() {
            return written;
        }

        @Override
        public void write(int b) throws IOException {
            out.write(b);
            written++;
        }

        @Override
        public void write(byte[] bytes, int from, int length) throws IOException {
            out.write(bytes, from, length);
            written += length;
        }

        @Override
        public void flush() throws IOException {
            out.flush();
        }
    }
}
