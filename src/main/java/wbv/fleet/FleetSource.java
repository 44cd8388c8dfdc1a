package wbv.fleet;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import wbv.recording.Recording;

/** Where the packets of a fleet come from. */
public sealed interface FleetSource {

    /**
     * Recordings that are replayed.
     *
     * @param recordings of one rate, each with all the channels of the seats
     * @param seats      number of them
     * @param size       samples of a packet
     * @param disturb    seed of a bad network, if there is one
     */
    record Recordings(List<Recording> recordings, int seats, int size, Optional<Long> disturb) implements FleetSource {

        public Recordings {
            recordings = List.copyOf(recordings);
        }
    }

    /** Files of packets, one after the other; every machine sees them under these names. */
    record Packets(List<Path> files) implements FleetSource {

        public Packets {
            files = List.copyOf(files);
        }
    }

    /**
     * A topic of Kafka, whose packets of one seat are in one partition. Results go to topics of the same brokers.
     *
     * @param brokers HOST:PORT, several with commas between
     * @param topic   of the packets
     * @param results what the names of the topics of results, alarms, tables and packets that cannot be read begin with
     * @param ends    whether the run ends where the topic ends when it begins
     */
    record Topic(String brokers, String topic, String results, boolean ends) implements FleetSource {}
}
