package wbv.recording.signals;

import io.airlift.compress.Compressor;
import io.airlift.compress.Decompressor;
import io.airlift.compress.lz4.Lz4Decompressor;
import io.airlift.compress.snappy.SnappyDecompressor;
import io.airlift.compress.zstd.ZstdCompressor;
import io.airlift.compress.zstd.ZstdDecompressor;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.zip.GZIPInputStream;
import org.apache.parquet.bytes.BytesInput;
import org.apache.parquet.compression.CompressionCodecFactory;
import org.apache.parquet.hadoop.metadata.CompressionCodecName;
import wbv.recording.DataFault;

/** How the pages of a Parquet file are compressed, in plain Java, where Parquet's own way is by Hadoop. Zstandard is written. */
final class PageCodecs implements CompressionCodecFactory {

    static final CompressionCodecName WRITTEN = CompressionCodecName.ZSTD;

    /** Bytes of a page; programs write one or a few MiB, and a header may state anything. */
    private static final int LARGEST = 1 << 28;

    private final String file;

    /** @param file for messages */
    PageCodecs(String file) {
        this.file = file;
    }

    /** @throws DataFault where it is one that is not read */
    static void require(String file, CompressionCodecName codec) {
        switch (codec) {
            case UNCOMPRESSED, SNAPPY, GZIP, ZSTD, LZ4_RAW -> {
                // read
            }
            default ->
                throw DataFault.in(file, "is compressed by " + codec + "; write it anew with snappy, zstd, gzip, LZ4_RAW or uncompressed");
        }
    }

    @Override
    public BytesInputDecompressor getDecompressor(CompressionCodecName codec) {
        require(file, codec);
        return switch (codec) {
            case SNAPPY -> new Unpacker(unpacked(new SnappyDecompressor()));
            case ZSTD -> new Unpacker(unpacked(new ZstdDecompressor()));
            case LZ4_RAW -> new Unpacker(unpacked(new Lz4Decompressor()));
            case GZIP -> new Unpacker(PageCodecs::unzipped);
            default -> new Unpacker((packed, size) -> packed);
        };
    }

    /** A page's bytes of a size that is stated. */
    private interface Unpacking {
        byte[] unpack(byte[] packed, int size) throws IOException;
    }

    private static Unpacking unpacked(Decompressor codec) {
        return (packed, size) -> {
            byte[] page = new byte[size];
            int length = codec.decompress(packed, 0, packed.length, page, 0, size);
            return length == size ? page : new byte[0];
        };
    }

    private static byte[] unzipped(byte[] packed, int size) throws IOException {
        try (GZIPInputStream zipped = new GZIPInputStream(BytesInput.from(packed).toInputStream())) {
            return zipped.readNBytes(size);
        }
    }

    private final class Unpacker implements BytesInputDecompressor {

        private final Unpacking unpacking;

        private Unpacker(Unpacking unpacking) {
            this.unpacking = unpacking;
        }

        @Override
        public BytesInput decompress(BytesInput bytes, int size) throws IOException {
            if (size < 0 || size > LARGEST) {
                throw DataFault.in(file, "states a page of " + size + " bytes; it is damaged, or its pages are larger than "
                        + (LARGEST >> 20) + " MiB");
            }
            byte[] page = unpacking.unpack(bytes.toByteArray(), size);
            if (page.length != size) {
                throw DataFault.in(file, "holds a page of another size than it states; it is damaged");
            }
            return BytesInput.from(page);
        }

        @Override
        public void decompress(ByteBuffer packed, int packedSize, ByteBuffer page, int size) {
            throw new UnsupportedOperationException("pages lie in arrays");
        }

        @Override
        public void release() {
            // nothing is held
        }
    }

    @Override
    public BytesInputCompressor getCompressor(CompressionCodecName codec) {
        if (codec != WRITTEN) {
            throw new UnsupportedOperationException(codec + " is not written");
        }
        Compressor zstd = new ZstdCompressor();
        return new BytesInputCompressor() {
            @Override
            public BytesInput compress(BytesInput bytes) throws IOException {
                byte[] page = bytes.toByteArray();
                byte[] packed = new byte[zstd.maxCompressedLength(page.length)];
                return BytesInput.from(packed, 0, zstd.compress(page, 0, page.length, packed, 0, packed.length));
            }

            @Override
            public CompressionCodecName getCodecName() {
                return codec;
            }

            @Override
            public void release() {
                // nothing is held
            }
        };
    }

    @Override
    public void release() {
        // nothing is held
    }
}
