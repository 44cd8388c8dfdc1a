package wbv.live;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.eclipse.paho.client.mqttv3.IMqttDeliveryToken;
import org.eclipse.paho.client.mqttv3.MqttCallbackExtended;
import org.eclipse.paho.client.mqttv3.MqttClient;
import org.eclipse.paho.client.mqttv3.MqttConnectOptions;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.eclipse.paho.client.mqttv3.MqttMessage;
import org.eclipse.paho.client.mqttv3.persist.MemoryPersistence;
import wbv.recording.DataFault;

/**
 * Lines of MQTT messages (3.1.1); a message holds one or more, whole. The level of the topic where the filter has its first
 * {@code +} says whose they are, unless the lines do. A message is acknowledged when it was taken, and the broker sends again what
 * was not; a connection that was lost is made again.
 */
public final class MqttSource implements Source {

    private static final int AT_LEAST_ONCE = 1;
    private static final int PATIENCE = 10; // s, for the connection and for each request

    private final String broker;
    private final String filter;
    private final int level;
    private final MqttClient client;
    private final MqttConnectOptions options = new MqttConnectOptions();
    private final CountDownLatch closed = new CountDownLatch(1);
    private volatile Throwable failure;

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
        this.level = Arrays.asList(filter.split("/", -1)).indexOf("+");
        try {
            client = new MqttClient(broker, name, new MemoryPersistence());
        } catch (IllegalArgumentException | MqttException wrong) {
            throw DataFault.in("MQTT " + broker, "is no address of a broker, such as tcp://localhost:1883", wrong);
        }
        client.setTimeToWait(PATIENCE * 1000L);
        options.setCleanSession(false);
        options.setAutomaticReconnect(true);
        options.setMaxReconnectDelay(5000);
        options.setConnectionTimeout(PATIENCE);
        options.setMqttVersion(MqttConnectOptions.MQTT_VERSION_3_1_1);
        if (!user.isEmpty()) {
            options.setUserName(user);
            options.setPassword(password.toCharArray());
        }
    }

    private static final int RETRY = 5;

    @Override
    public String name() {
        return "MQTT " + broker + " " + filter;
    }

    @Override
    public void run(Receiver receiver) throws IOException {
        client.setCallback(new Taking(receiver));
        try {
            client.connect(options);
            client.subscribe(filter, AT_LEAST_ONCE);
            while (!closed.await(RETRY, TimeUnit.SECONDS)) {
                // The client does not try again by itself where the connection was lost while it was being made.
                reconnect();
            }
        } catch (MqttException refused) {
            throw new IOException(reason(refused), refused);
        } catch (InterruptedException ended) {
            Thread.currentThread().interrupt();
        }
        if (failure instanceof RuntimeException broken) {
            throw broken;
        }
    }

    private void reconnect() {
        try {
            if (!client.isConnected()) {
                client.reconnect();
            }
        } catch (MqttException busy) {
            // it is trying, or tries again later
        }
    }

    private static String reason(MqttException refused) {
        Throwable cause = refused.getCause();
        return refused.getMessage() + (cause == null || cause.getMessage() == null ? "" : ": " + cause.getMessage());
    }

    /** Hands messages on. */
    private final class Taking implements MqttCallbackExtended {

        private final Receiver receiver;

        private Taking(Receiver receiver) {
            this.receiver = receiver;
        }

        @Override
        public void connectComplete(boolean again, String server) {
            if (again) { // a broker that was started again may have forgotten who listens
                new Thread(this::listen, "wbv-mqtt").start();
            }
        }

        private void listen() {
            try {
                client.subscribe(filter, AT_LEAST_ONCE);
            } catch (MqttException lost) {
                // the next connection tries again
            }
        }

        @Override
        public void connectionLost(Throwable cause) { }

        @Override
        public void messageArrived(String topic, MqttMessage message) {
            try {
                String[] levels = topic.split("/", -1);
                String seat = level >= 0 && level < levels.length ? levels[level] : "";
                byte[] text = message.getPayload();
                if (text.length > 1 << 22) {
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
            } catch (RuntimeException broken) {
                failure = broken;
                closed.countDown();
                throw broken;
            }
        }

        @Override
        public void deliveryComplete(IMqttDeliveryToken token) { }
    }

    /** The name of a client that takes these topics: the same each time, so that the broker knows it again. */
    public static String clientName(String filter) {
        return "wbv-live-" + Integer.toHexString(List.of(filter.getBytes(StandardCharsets.UTF_8).length, filter).hashCode());
    }

    @Override
    public void close() throws IOException {
        closed.countDown();
        try {
            if (client.isConnected()) {
                client.disconnectForcibly(0, 1000);
            }
            client.close(true);
        } catch (MqttException gone) {
            throw new IOException(reason(gone), gone);
        }
    }
}
