package wbv.live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import wbv.recording.DataFault;

/** MQTT from a broker that speaks as much of 3.1.1 as a subscriber needs (OASIS standard, sections 3.1 to 3.14). */
@Timeout(60)
class MqttSourceTest {

    /** Gives a list of messages to the one who subscribes, as far as he has not acknowledged them, and then hangs up. */
    private static final class Broker implements AutoCloseable {

        private final ServerSocket server = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
        private final List<String[]> messages;
        private final Set<Integer> acknowledged = ConcurrentHashMap.newKeySet();
        private final int hangsUpAfter;
        private volatile int connections;

        /** @param messages topic and payload of each @param hangsUpAfter so many on the first connection */
        Broker(List<String[]> messages, int hangsUpAfter) throws IOException {
            this.messages = messages;
            this.hangsUpAfter = hangsUpAfter;
            Thread thread = new Thread(this::serve, "broker");
            thread.setDaemon(true);
            thread.start();
        }

        String url() {
            return "tcp://127.0.0.1:" + server.getLocalPort();
        }

        private void serve() {
            while (!server.isClosed()) {
                try (Socket socket = server.accept()) {
                    connections++;
                    talk(new DataInputStream(socket.getInputStream()), new DataOutputStream(socket.getOutputStream()));
                } catch (IOException gone) {
                    // the client went; the next one comes
                }
            }
        }

        private void talk(DataInputStream in, DataOutputStream out) throws IOException {
            while (true) {
                int type = in.readUnsignedByte();
                int length = 0;
                for (int shift = 0, part = 0x80; (part & 0x80) != 0; shift += 7) {
                    part = in.readUnsignedByte();
                    length |= (part & 0x7f) << shift;
                }
                byte[] body = in.readNBytes(length);
                switch (type >> 4) {
                    case 1 -> out.write(new byte[] {0x20, 2, 0, 0});
                    case 8 -> {
                        out.write(new byte[] {(byte) 0x90, 3, body[0], body[1], 1});
                        publish(out);
                    }
                    case 4 -> {
                        acknowledged.add((body[0] & 0xff) << 8 | body[1] & 0xff);
                        if (connections == 1 && acknowledged.size() >= hangsUpAfter) {
                            throw new IOException("hangs up");
                        }
                    }
                    case 12 -> out.write(new byte[] {(byte) 0xd0, 0});
                    case 14 -> {
                        return;
                    }
                    default -> {}
                }
                out.flush();
            }
        }

        private void publish(DataOutputStream out) throws IOException {
            for (int i = 0; i < messages.size(); i++) {
                if (acknowledged.contains(i + 1)) {
                    continue;
                }
                byte[] topic = messages.get(i)[0].getBytes(StandardCharsets.UTF_8);
                byte[] payload = messages.get(i)[1].getBytes(StandardCharsets.UTF_8);
                int length = 2 + topic.length + 2 + payload.length;
                out.write(0x32);
                for (int left = length;; left >>= 7) {
                    out.write(left > 0x7f ? left & 0x7f | 0x80 : left);
                    if (left <= 0x7f) {
                        break;
                    }
                }
                out.writeShort(topic.length);
                out.write(topic);
                out.writeShort(i + 1);
                out.write(payload);
            }
            out.flush();
        }

        @Override
        public void close() throws IOException {
            server.close();
        }
    }

    /** The topic says the seat; what the broker sends again after a lost connection counts once. */
    @Test
    void messagesAreRowsAndEachCountsOnce() throws Exception {
        List<String[]> messages = new ArrayList<>();
        for (int i = 0; i < 600; i += 6) {
            for (String seat : List.of("truck 7", "loader")) {
                StringBuilder text = new StringBuilder("t,platform.acc.z,head.acc.z,seat.acc.z\n");
                for (int k = i; k < i + 6; k++) {
                    double u = Math.sin(0.45 * k) + 0.7 * Math.sin(0.21 * k);
                    text.append(String.format(Locale.ROOT, "%.6f,%.6f,%.6f,%.6f%n", k / 60.0, u, 1.2 * u + 0.1 * Math.sin(0.9 * k), u));
                }
                messages.add(new String[] {"plant/" + seat + "/samples", text.toString()});
            }
        }
        List<String> told = new ArrayList<>();
        LiveStream live = new LiveStream(LiveSettings.usual(), told::add, Aside.NONE, System::nanoTime);
        try (Broker broker = new Broker(messages, 90)) {
            MqttSource source = new MqttSource(broker.url(), "plant/+/samples", "test", "", "");
            LiveRun run = new LiveRun(live, List.of(source), Double.POSITIVE_INFINITY);
            Thread runs = Told.running(run);
            for (int i = 0; i < 3000 && broker.acknowledged.size() < messages.size(); i++) {
                Thread.sleep(10);
            }
            assertEquals(messages.size(), broker.acknowledged.size());
            assertTrue(broker.connections > 1, "the connection was made again");
            run.stop();
            runs.join();
        }
        live.finish();
        assertEquals(Set.of("truck 7", "loader"), Set.copyOf(live.all().stream().map(LiveSeat::name).toList()));
        for (LiveSeat seat : live.all()) {
            assertEquals(600, seat.latest().orElseThrow().sample(), seat.name());
            assertEquals(0, seat.missing());
        }
        assertEquals(0, live.unreadable());
    }

    @Test
    void whoIsNoBrokerIsRefusedInOneLine() throws IOException {
        assertThrows(DataFault.class, () -> new MqttSource("nonsense", "a/+", "test", "", ""));
        int free;
        try (ServerSocket once = new ServerSocket(0)) {
            free = once.getLocalPort();
        }
        LiveStream live = new LiveStream(LiveSettings.usual(), line -> {}, Aside.NONE, System::nanoTime);
        LiveRun run = new LiveRun(live, List.of(new MqttSource("tcp://127.0.0.1:" + free, "a/+", "test", "", "")),
                Double.POSITIVE_INFINITY);
        DataFault fault = assertThrows(DataFault.class, run::run);
        assertTrue(fault.getMessage().lines().count() == 1 && fault.getMessage().contains("127.0.0.1"), fault.getMessage());
    }
}
