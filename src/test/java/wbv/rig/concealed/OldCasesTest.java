package wbv.rig.concealed;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.recording.Channel;

/**
 * A seed means the same recording, model and key whatever is added to the proof: the digests were taken before benches, planar people and
 * levels came.
 */
class OldCasesTest {

    @ParameterizedTest
    @CsvSource({"friction.coulomb, 3, bf5d2de2577b151ace3c0d65702eb3f3c199271f40615d26da0a87e2be2a3f99",
        "sensor.delay, 4, e266cd3d2b3ae3aea4f5fdf8f13d91173858544f7d1c567b9ce5e95e4019d4b6"})
    void anOldCaseKeepsItsBytes(String word, long seed, String digest) throws NoSuchAlgorithmException {
        ConcealedCase made = Concealer.make(new ConcealedSpec("1", List.of(word), 1, Setting.FIELD, false, seed));
        MessageDigest sha = MessageDigest.getInstance("SHA-256");
        sha.update((made.model() + made.key() + made.force().orElse("")).getBytes(StandardCharsets.UTF_8));
        for (Channel channel : made.recording().channels()) {
            sha.update(channel.toString().getBytes(StandardCharsets.UTF_8));
            for (double value : made.recording().values(channel)) {
                sha.update(ByteBuffer.allocate(Double.BYTES).putDouble(value).array());
            }
        }
        assertEquals(digest, HexFormat.of().formatHex(sha.digest()));
    }
}
