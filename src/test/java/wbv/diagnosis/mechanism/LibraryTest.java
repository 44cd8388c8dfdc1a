package wbv.diagnosis.mechanism;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import wbv.body.Drive;
import wbv.body.SensorFault;
import wbv.body.law.Law;
import wbv.body.law.Learned;
import wbv.body.number.Modulator;
import wbv.recording.Channel;

class LibraryTest {

    private static final List<Mechanism> ALL = Library.standard().mechanisms();

    /** The compiler knows every mechanism; the list is written by hand. */
    @Test
    void noMechanismIsForgotten() {
        Set<Class<?>> sealed = new HashSet<>(List.of(Mechanism.class.getPermittedSubclasses()));
        sealed.remove(Mechanism.Custom.class);
        assertEquals(sealed, ALL.stream().map(Object::getClass).collect(Collectors.toSet()));
    }

    /**
     * Every law, drive and fault of a body belongs to a mechanism, but for how a body starts, and for forces that were measured or given.
     */
    @Test
    void everyPhysicsHasItsMechanism() {
        Set<String> words = ALL.stream().map(Mechanism::word).collect(Collectors.toSet());
        words.addAll(Set.of("start", "input.measured", "given", "beside"));
        for (Class<?> family : List.of(Law.class, Drive.class, SensorFault.class)) {
            kinds(family).forEach(physics -> assertTrue(words.contains(word(physics)), physics + " is a " + word(physics)));
        }
    }

    private static Stream<Class<?>> kinds(Class<?> family) {
        return Arrays.stream(family.getPermittedSubclasses())
                .flatMap(type -> type.isRecord() || type == Learned.class ? Stream.of(type) : kinds(type));
    }

    /** The word of a law, drive or fault with some numbers. */
    private static String word(Class<?> physics) {
        if (physics == Learned.class) {
            return Learned.MECHANISM;
        }
        RecordComponent[] components = physics.getRecordComponents();
        Object[] some = new Object[components.length];
        for (int i = 0; i < some.length; i++) {
            Class<?> type = components[i].getType();
            some[i] = type == double.class ? (Object) (0.003 * (i + 1)) : type == Channel.class
                    ? Channel.parse(i == 0 ? "seat.acc.x" : "seat.acc.y")
                    : type == Modulator.class ? new Modulator.Level(Channel.parse("coil.volt.s"), 0, 3) : type.getEnumConstants()[0];
        }
        try {
            Object made = physics.getDeclaredConstructor(Arrays.stream(components).map(RecordComponent::getType).toArray(Class[]::new))
                    .newInstance(some);
            return made instanceof Law law ? law.mechanism()
                    : made instanceof Drive drive ? drive.mechanism() : ((SensorFault) made).mechanism();
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    @Test
    void everySentenceHasOnePlace() {
        for (Mechanism mechanism : ALL) {
            String sentence = mechanism.entry().sentence();
            assertTrue(String.format(sentence, "HERE").contains("HERE"), mechanism.word());
            assertEquals(sentence.length() - 2, sentence.replace("%s", "").length(), mechanism.word());
        }
    }

    @Test
    void aWordStandsOnce() {
        IllegalArgumentException twice = assertThrows(IllegalArgumentException.class, () -> Library.standard().with(new Softening()));
        assertTrue(twice.getMessage().contains("stiffness.softening"), twice.getMessage());
    }

    /** Two families are told apart by the same recording, whichever is named first. */
    @Test
    void familiesAgreeOnWhatSettlesThem() {
        for (Family one : Family.values()) {
            for (Family other : Family.values()) {
                assertEquals(Family.between(one, other), Family.between(other, one), one + " " + other);
            }
        }
    }
}
