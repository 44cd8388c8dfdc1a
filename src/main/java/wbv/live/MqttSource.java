package wbv.live;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import org.eclipse.paho.client.mqttv3.IMqttDeliveryToken;
import org.eclipse.paho.client.mqttv3.MqttCallback;
import org.eclipse.paho.client.mqttv3.MqttClient;
import org.eclipse.paho.client.mqttv3.MqttConnectOptions;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.eclipse.paho.client.mqttv3.MqttMessage;
import org.eclipse.paho.client.mqttv3.persist.MemoryPersistence;
import wbv.recording.DataFault;

/**
 * Lines of MQTT messages (3.1.1); a message holds one or more, whole. The level of the topic where the filter has its first
 * {@code +} says whose they are, unless the lines do. A message is acknowledged when it was taken, and the broker sends again what
 * was not. A connection that was lost is made again, by a new client: Paho's own repetition hangs for good where an acknowledgement
 * was on its way out as the connection went (its sender waits for a request to connect and finds the acknowledgement before it).
 */
public final class MqttSource implements LineSource {

    private static final int AT_LEAST_ONCE = 1;
    private static final int PATIENCE = 10; // s, for the connection and for each request: over any network's round trip
    private static final long PAUSE = 1; // s, before a broker that was gone is asked again
    private static final int LONGEST = 1 << 22; // bytes of a message that is read

    private final String broker;
    private final String filter;
    private final String name;
    private final int level;
    private final MqttConnectOptions options = new MqttConnectOptions();
    private final Semaphore news = new Semaphore(0);
    private volatile boolean closed;

    /**
     * Who was given where to; no connection yet.
     *
     * @param broker   {@code tcp://host:1883} or {@code ssl://host:8883}
     * @param filter   of topics, {@code wbv/+/samples}
     * @param name     of this client; the broker keeps unacknowledged messages by it
     * @param user     empty for none
     * @param password of that user
     * @throws DataFault if the address is none
     */
    public MqttSource(String broker, String filter, String name, String user, String password) {
        this.broker = broker;
        this.filter = filter;
        this.name = name;
        this.level = Arrays.asList(filter.split("/", -1)).indexOf("+");
        try {
            client().close();
        } catch (IllegalArgumentException | MqttException wrong) {
            throw DataFault.in("MQTT " + broker, "is no address of a broker, such as tcp://localhost:1883", wrong);
        }
        options.setCleanSession(false);
        options.setConnectionTimeout(PATIENCE);
        options.setMqttVersion(MqttConnectOptions.MQTT_VERSION_3_1_1);
        if (!user.isEmpty()) {
            options.setUserName(user);
            options.setPassword(password.toCharArray());
        }
    }

    private MqttClient client() throws MqttException {
        return new MqttClient(broker, name, new MemoryPersistence());
    }

    /** The name of a client that takes these topics: the same each time, so that the broker knows it again. */
    public static String clientName(String filter) {
        return "wbv-live-" + Integer.toHexString(List.of(filter.getBytes(StandardCharsets.UTF_8).length, filter).hashCode());
    }

    @Override
    public String name() {
        return "MQTT " + broker + " " + filter;
    }

    @Override
    public void run(Receiver receiver) throws IOException {
        try {
            Connection connection = new Connection(receiver);
            connection.open();
            while (!closed) {
                news.acquire();
                while (!closed && connection.lost) {
                    connection.drop();
                    connection = new Connection(receiver);
                    openAgain(connection);
                }
            }
            connection.drop();
            if (connection.failure instanceof RuntimeException broken) {
                throw broken;
            }
        } catch (MqttException refused) {
            throw new IOException(reason(refused), refused);
        } catch (InterruptedException ended) {
            Thread.currentThread().interrupt();
        }
    }

    private void openAgain(Connection connection) throws InterruptedException {
        try {
            connection.open();
        } catch (MqttException away) {
            connection.lost = true;
            news.tryAcquire(PAUSE, TimeUnit.SECONDS);
        }
    }

    private static String reason(MqttException refused) {
        Throwable cause = refused.getCause();
        return refused.getMessage() + (cause == null || cause.getMessage() == null ? "" : ": " + cause.getMessage());
    }

    @Override
    public void close() {
        closed = true;
        news.release();
    }

    /** One connection, from its request until it is lost; hands on what it brings. */
    private final class Connection implements MqttCallback {

        private final Receiver receiver;
        private final MqttClient client;
        private volatile boolean lost;
        private volatile Throwable failure;

        private Connection(Receiver receiver) throws MqttException {
            this.receiver = receiver;
            client = client();
            client.setTimeToWait(TimeUnit.SECONDS.toMillis(PATIENCE));
            client.setCallback(this);
        }

        /** Listens, too, each time: a broker that was started again may have forgotten who did. */
        private void open() throws MqttException {
            try {
                client.connect(options);
                client.subscribe(filter, AT_LEAST_ONCE);
            } catch (MqttException away) {
                drop();
                throw away;
            }
        }

        private void drop() {
            try {
                if (client.isConnected()) {
                    client.disconnectForcibly(0, TimeUnit.SECONDS.toMillis(PAUSE));
                }
                client.close(true);
            } catch (MqttException gone) {
                // and that is what was wanted
            }
        }

        @Override
        public void connectionLost(Throwable cause) {
            lost = true;
            news.release();
        }

        @Override
        public void messageArrived(String topic, MqttMessage message) {
            try {
                String[] levels = topic.split("/", -1);
                take(topic, level >= 0 && level < levels.length ? levels[level] : "", message.getPayload());
            } catch (RuntimeException broken) {
                failure = broken;
                close();
                throw broken;
            }
        }

        private void take(String topic, String seat, byte[] text) {
            if (text.length > LONGEST) {
                receiver.tooLong(topic, text, text.length);
                return;
            }
            int from = 0;
            for (int i = 0; i <= text.length; i++) {
                if (i == text.length || text[i] == '\n') {
                    if (i > from) {
                        receiver.line(topic, seat, text, from, text[i - 1] == '\r' ? i - 1 : i);
                    }
                    from = i + 1;
                }
            }
            receiver.idle();
        }

        @Override
        public void deliveryComplete(IMqttDeliveryToken token) {}
    }
}
