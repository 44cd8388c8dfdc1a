package wbv.recording.signals;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.stream.Collectors;
import wbv.recording.Channel;
import wbv.recording.DataFault;

/** Writes a WAV file of 32-bit floating point in SI units; names and the exact rate stand in its comment. */
final class WavWriter {

    /** How far the whole number of samples a second that a WAV states may be from the rate. */
    private static final double OFF = 1e-3;

    private WavWriter() {}

    static void write(SampledColumns columns, OutputStream out) throws IOException {
        double rate = columns.rate();
        long whole = Math.round(rate);
        if (Math.abs(whole - rate) > OFF * rate) {
            throw DataFault.in(columns.file(), "a WAV states a whole number of samples a second, and this recording has " + rate
                    + "; write .uff, .mat or .csv");
        }
        int channels = columns.channels().size();
        long data = 4L * channels * columns.length();
        if (data > Integer.MAX_VALUE - (1 << 20) || channels > 0xFFFF / 4) {
            throw DataFault.in(columns.file(), "would be larger than the 2 GiB of a WAV; write .uff, .mat or .csv");
        }
        String names = columns.channels().stream().map(Channel::toString).collect(Collectors.joining(","));
        byte[] comment = even(WavFile.CHANNELS + names + "; " + WavFile.RATE + rate + " Hz");
        ByteBuffer head = ByteBuffer.allocate(12 + 8 + 18 + 8 + 4 + 8 + 4 + 8 + comment.length + 8).order(ByteOrder.LITTLE_ENDIAN);
        head.put(tag("RIFF")).putInt((int) (head.capacity() - 8 + data)).put(tag("WAVE"));
        head.put(tag("fmt ")).putInt(18).putShort((short) 3).putShort((short) channels).putInt((int) whole)
                .putInt((int) (whole * 4 * channels))
                .putShort((short) (4 * channels)).putShort((short) 32).putShort((short) 0);
        head.put(tag("fact")).putInt(4).putInt(columns.length());
        head.put(tag("LIST")).putInt(4 + 8 + comment.length).put(tag("INFO")).put(tag("ICMT")).putInt(comment.length).put(comment);
        head.put(tag("data")).putInt((int) data);
        out.write(head.array());
        ByteBuffer frame = ByteBuffer.allocate(4 * channels).order(ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < columns.length(); i++) {
            for (int j = 0; j < channels; j++) {
                frame.putFloat(4 * j, (float) columns.value(j, i));
            }
            out.write(frame.array());
        }
    }

    /** A text with the null byte at its end that RIFF asks for, and one more where its length would be odd. */
    private static byte[] even(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        return Arrays.copyOf(bytes, (bytes.length + 2) / 2 * 2);
    }

    private static byte[] tag(String text) {
        return text.getBytes(StandardCharsets.ISO_8859_1);
    }
}
