package wbv.live;

import java.io.IOException;
import java.net.BindException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.SocketException;
import wbv.recording.DataFault;

/** Lines of UDP datagrams; a datagram holds one or more, whole. Those that the system drops are not seen here: their times are. */
public final class DatagramSource implements LineSource {

    /** What the system may hold back for us, where it grants it: seconds of many seats. */
    private static final int HELD = 4 << 20;

    private final DatagramSocket socket;
    private final String name;

    /**
     * Opens a port.
     *
     * @param at where to listen; port 0 takes a free one
     * @throws DataFault if it is taken or not ours
     */
    public DatagramSource(InetSocketAddress at) throws IOException {
        try {
            socket = new DatagramSocket(at);
        } catch (BindException taken) {
            throw DataFault.in("UDP " + at.getHostString() + ":" + at.getPort(), "cannot be listened on: " + taken.getMessage(), taken);
        }
        socket.setReceiveBufferSize(HELD);
        name = "UDP " + at.getHostString() + ":" + socket.getLocalPort();
    }

    @Override
    public String name() {
        return name;
    }

    /** The port that is listened on. */
    public int port() {
        return socket.getLocalPort();
    }

    @Override
    public void run(Receiver receiver) throws IOException {
        byte[] buffer = new byte[1 << 16];
        DatagramPacket packet = new DatagramPacket(buffer, buffer.length);
        while (!socket.isClosed()) {
            packet.setLength(buffer.length);
            try {
                socket.receive(packet);
            } catch (SocketException closed) {
                if (socket.isClosed()) {
                    return;
                }
                throw closed;
            }
            String sender = packet.getAddress().getHostAddress() + ":" + packet.getPort();
            int from = 0;
            for (int i = 0; i <= packet.getLength(); i++) {
                if (i == packet.getLength() || buffer[i] == '\n') {
                    if (i > from) {
                        receiver.line(sender, "", buffer, from, buffer[i - 1] == '\r' ? i - 1 : i);
                    }
                    from = i + 1;
                }
            }
            receiver.idle();
        }
    }

    @Override
    public void close() {
        socket.close();
    }
}
