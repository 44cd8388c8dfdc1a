package wbv.seat;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import wbv.recording.DataFault;

/** Packets among other bytes. */
class PacketFrameTest {

    private static Packet packet(Random random) {
        double[] values = random.doubles(2L * (1 + random.nextInt(20))).toArray();
        return new Packet("crane 7/left é" + random.nextInt(1000), random.nextInt(1000), random.nextDouble(), 60, 2, values);
    }

    @Test
    void aWholePacketIsFoundWhereItBeginsAndNowhereElse() {
        Random random = new Random(1);
        for (int k = 0; k < 200; k++) {
            Packet packet = packet(random);
            byte[] one = packet.bytes();
            int before = random.nextInt(30);
            byte[] all = new byte[before + one.length + random.nextInt(30)];
            random.nextBytes(all);
            System.arraycopy(one, 0, all, before, one.length);
            assertEquals(one.length, Packet.frame(all, before, all.length));
            assertEquals(packet.seat(), Packet.seat(one));
            for (int at = 0; at < all.length; at++) {
                assertTrue(at == before || Packet.frame(all, at, all.length) <= 0, "another at " + at);
            }
            int cut = random.nextInt(one.length);
            int wanted = -Packet.frame(one, 0, cut);
            assertTrue(wanted > cut && wanted <= one.length, "needs more than the " + cut + " that are there, no more than all: " + wanted);
        }
    }

    /** However it is damaged, in front or behind: it is no whole packet, and whose it was is never made up. */
    @Tag("slow")
    @Test
    void aDamagedPacketIsNone() {
        Random random = new Random(2);
        for (int k = 0; k < 100_000; k++) {
            byte[] bytes = packet(random).bytes();
            bytes[random.nextInt(bytes.length)] ^= (byte) (1 + random.nextInt(255));
            assertTrue(Packet.frame(bytes, 0, bytes.length) <= 0);
            byte[] cut = Arrays.copyOf(bytes, random.nextInt(bytes.length));
            assertThrows(DataFault.class, () -> Packet.of(bytes));
            assertTrue(Packet.frame(cut, 0, cut.length) <= 0);
        }
    }
}
