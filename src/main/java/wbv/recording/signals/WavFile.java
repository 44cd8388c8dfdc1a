package wbv.recording.signals;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.recording.Clock;
import wbv.recording.DataFault;

/**
 * A WAV file (RIFF or RF64), frame by frame. Whole numbers of 8, 16, 24 and 32 bits are shares of full scale, -1 to 1; floating-point
 * numbers of 32 and 64 bits are as they stand. It knows its rate, but neither units nor names, unless wbv wrote them in its comment
 * ({@code LIST INFO ICMT}): {@code channels: seat.acc.x,seat.acc.z; rate: 60.0 Hz}.
 *
 * <p>Java's own reader knows neither that comment nor RF64. Source: Microsoft and IBM, "Multimedia programming interface and data
 * specifications 1.0" (1991); EBU Tech 3306 for RF64.
 */
final class WavFile implements SignalFile {

    static final String CHANNELS = "channels: ";
    static final String RATE = "rate: ";

    private static final int PCM = 1;
    private static final int FLOAT = 3;
    private static final int EXTENSIBLE = 0xFFFE;
    private static final long UNKNOWN = 0xFFFFFFFFL;
    private static final int LONGEST_TEXT = 1 << 16;

    private final String file;
    private final DataInputStream in;
    private int coding;
    private int channels;
    private int bits;
    private double rate;
    private long size64 = -1;
    private String comment = "";
    private long frames;
    private long read;
    private List<Label> labels = List.of();
    private byte[] frame = new byte[0];

    private WavFile(String file, InputStream content) {
        this.file = file;
        this.in = new DataInputStream(new BufferedInputStream(content, 1 << 16));
    }

    static WavFile open(String file, InputStream content) throws IOException {
        WavFile wav = new WavFile(file, content);
        wav.head();
        return wav;
    }

    private void head() throws IOException {
        in.skipNBytes(12);
        while (true) {
            byte[] tag = in.readNBytes(8);
            if (tag.length < 8) {
                throw DataFault.in(file, "has no samples: the WAV file is cut off before its 'data'");
            }
            String name = new String(tag, 0, 4, StandardCharsets.ISO_8859_1);
            long size = Integer.toUnsignedLong(little(tag).getInt(4));
            if (name.equals("data")) {
                begin(size == UNKNOWN && size64 >= 0 ? size64 : size);
                return;
            }
            if (name.equals("fmt ") || name.equals("ds64") || name.equals("LIST") && size <= LONGEST_TEXT) {
                chunk(name, in.readNBytes((int) Math.min(size, LONGEST_TEXT)));
            } else {
                skip(size);
            }
            skip(size & 1);
        }
    }

    private void skip(long bytes) throws IOException {
        for (long left = bytes; left > 0;) {
            long skipped = in.skip(left);
            if (skipped <= 0 && in.read() < 0) {
                return; // told by the chunk that is missing then
            }
            left -= Math.max(skipped, 1);
        }
    }

    private void chunk(String name, byte[] bytes) {
        ByteBuffer body = little(bytes);
        if (name.equals("fmt ") && bytes.length >= 16) {
            coding = body.getShort(0) & 0xFFFF;
            coding = coding == EXTENSIBLE && bytes.length >= 26 ? body.getShort(24) & 0xFFFF : coding;
            channels = body.getShort(2) & 0xFFFF;
            rate = Integer.toUnsignedLong(body.getInt(4));
            int block = body.getShort(12) & 0xFFFF;
            bits = channels > 0 ? 8 * (block / channels) : 0; // of the container: 20 bits stand in 24
        } else if (name.equals("ds64") && bytes.length >= 16) {
            size64 = body.getLong(8);
        } else if (name.equals("LIST") && new String(bytes, StandardCharsets.UTF_8).startsWith("INFO")) {
            for (int at = 4; at + 8 <= bytes.length;) {
                int length = Math.max(0, Math.min(body.getInt(at + 4), bytes.length - at - 8));
                if (new String(bytes, at, 4, StandardCharsets.ISO_8859_1).equals("ICMT")) {
                    comment = new String(bytes, at + 8, length, StandardCharsets.UTF_8).replace("\0", "").strip();
                }
                at += 8 + length + (length & 1);
            }
        }
    }

    private void begin(long size) {
        boolean whole = coding == PCM && (bits == 8 || bits == 16 || bits == 24 || bits == 32);
        boolean floating = coding == FLOAT && (bits == 32 || bits == 64);
        if (!whole && !floating) {
            throw DataFault.in(file, "is coded as " + coding + " with " + bits
                    + " bits; WAV is read as whole numbers (PCM) of 8, 16, 24 or 32 bits, or floating point");
        }
        labels = labels();
        frame = new byte[channels * bits / 8];
        frames = size == UNKNOWN || size == 0 ? Long.MAX_VALUE : size / frame.length; // a recorder that was cut off never came back to say
        String stated = after(RATE).replaceFirst(" Hz$", "");
        rate = stated.matches("[0-9.]+(E-?[0-9]+)?") ? Double.parseDouble(stated) : rate;
        if (!Clock.isRate(rate)) {
            throw DataFault.in(file, "states " + rate + " samples a second; " + Clock.SLOWEST + " to " + Clock.FASTEST + " Hz are read");
        }
    }

    /** What follows a word in the comment, up to the next semicolon. */
    private String after(String word) {
        for (String part : comment.split(";")) {
            if (part.strip().startsWith(word)) {
                return part.strip().substring(word.length()).strip();
            }
        }
        return "";
    }

    @Override
    public List<Label> labels() {
        if (!labels.isEmpty()) {
            return labels;
        }
        String[] names = after(CHANNELS).split(",");
        List<Label> made = new ArrayList<>();
        for (int i = 0; i < channels; i++) {
            made.add(Label.of(names.length == channels && !names[i].isBlank() ? names[i].strip() : Integer.toString(i + 1)));
        }
        return made;
    }

    @Override
    public Optional<String> time() {
        return Optional.empty();
    }

    @Override
    public OptionalDouble rate() {
        return OptionalDouble.of(rate);
    }

    @Override
    public Map<String, String> notes() {
        Map<String, String> notes = new LinkedHashMap<>();
        notes.put("samples", bits + " bits, " + (coding == FLOAT ? "floating point" : "shares of full scale"));
        if (!comment.isEmpty() && after(CHANNELS).isEmpty()) {
            notes.put("comment", comment);
        }
        return notes;
    }

    @Override
    public boolean read(double[] row) throws IOException {
        if (read == frames) {
            return false;
        }
        int there = in.readNBytes(frame, 0, frame.length);
        if (there < frame.length) {
            if (frames == Long.MAX_VALUE) {
                return false;
            }
            throw DataFault.in(file, "is cut off: it states " + frames + " samples a channel and holds " + read);
        }
        read++;
        ByteBuffer bytes = little(frame);
        for (int i = 0; i < channels; i++) {
            row[i] = number(bytes, i * bits / 8);
        }
        return true;
    }

    private double number(ByteBuffer bytes, int at) {
        if (coding == FLOAT) {
            return bits == 32 ? bytes.getFloat(at) : bytes.getDouble(at);
        }
        return switch (bits) {
            case 8 -> ((bytes.get(at) & 0xFF) - 128) / 128.0; // the only one without a sign
            case 16 -> bytes.getShort(at) / 32_768.0;
            case 24 -> ((bytes.get(at) & 0xFF) | (bytes.get(at + 1) & 0xFF) << 8 | bytes.get(at + 2) << 16) / 8_388_608.0;
            default -> bytes.getInt(at) / 2_147_483_648.0;
        };
    }

    @Override
    public double fractionRead() {
        return frames == Long.MAX_VALUE ? Double.NaN : (double) read / frames;
    }

    @Override
    public void close() throws IOException {
        in.close();
    }

    private static ByteBuffer little(byte[] bytes) {
        return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }
}
