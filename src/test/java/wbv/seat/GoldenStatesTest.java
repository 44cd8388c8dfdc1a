package wbv.seat;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import wbv.filter.BodyEstimate;
import wbv.filter.Estimator;
import wbv.filter.EstimatorDesign;
import wbv.filter.EstimatorState;
import wbv.filter.Method;
import wbv.filter.drift.Adwin;
import wbv.filter.model.Spec;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * States of every released form load, and go on as they did when they were saved, but for what another machine's functions round.
 * {@link #main} writes those of the present form.
 */
class GoldenStatesTest {

    private static final Path FOLDER = Path.of("src/test/resources/wbv/snapshot");
    private static final int SAVED = 200;
    private static final int GOES_ON = 20;
    private static final double ROUNDING = 1e-7;
    /**
     * Of exposure that was begun at 840 Hz and is gone on with at 120 Hz, of which a quarter of a second more of 20 s is known at a moment.
     */
    private static final double WEIGHTED_OTHERWISE = 0.02;
    /** Of what was begun when the input between samples was read in another way, by modes: two are sought in a body of one. */
    private static final double[] READ_OTHERWISE = {Double.NaN, 0.005, 0.06};
    /**
     * Version of saved states from which on deviations go by what batches say, with those before they are found anew, and the input
     * between samples is what errs least over frequencies.
     */
    private static final int WITH_BATCHES = 4;
    /** Place of the frequency's deviation in what is told of an estimator. */
    private static final List<Integer> DEVIATION = List.of(2);
    /** Places of what is told of a seat's exposure. */
    private static final List<Integer> EXPOSURE = List.of(4, 5, 6);

    private static List<EstimatorDesign> designs() {
        List<EstimatorDesign> all = new ArrayList<>();
        for (Method method : Method.values()) {
            for (int degrees = 1; degrees <= 2; degrees++) {
                all.add(EstimatorDesign.of(method).withDegrees(degrees).withParticles(EstimatorDesign.LEAST_PARTICLES));
            }
        }
        return all;
    }

    private static String name(EstimatorDesign design) {
        return design.method().word() + "-" + design.degrees();
    }

    private static void feed(Estimator estimator, int from, int to) {
        for (Packet packet : Seats.packets("golden", SAVED + GOES_ON, 6, 5).subList(from, to)) {
            for (int i = 0; i < packet.samples(); i++) {
                estimator.step(packet.value(i, 2), packet.value(i, 5));
            }
        }
    }

    private static String said(BodyEstimate track) {
        return track.frequency() + " " + track.damping() + " " + track.frequencyDeviation() + " " + track.prediction() + " "
                + track.missing();
    }

    private static Seat seat() {
        return new Seat("golden", Seats.plan(Method.EKF_ADWIN, true));
    }

    /** @return numbers of the last result */
    private static String feed(Seat seat, int from, int to) {
        List<SeatResult> results = new ArrayList<>();
        Seats.packets("golden", SAVED + GOES_ON, 6, 5).subList(from, to).stream().filter(each -> each.counter() != SAVED - 2)
                .forEach(packet -> seat.accept(packet, results::add));
        SeatResult last = results.get(results.size() - 1);
        SeatResult.Mode mode = last.bodies().get(0).modes().get(0);
        SeatResult.Exposure exposure = last.exposure().orElseThrow();
        return last.time() + " " + last.sample() + " " + mode.frequency() + " " + mode.dampingDeviation() + " " + exposure.a8() + " "
                + exposure.vdv() + " " + exposure.minutesToLimit() + " " + last.state().orElseThrow().probability() + " "
                + last.losses().lost() + " " + last.losses().samples();
    }

    @TestFactory
    Stream<DynamicTest> statesOfEveryFormLoad() {
        return java.util.stream.IntStream.rangeClosed(1, StateWriter.VERSION).boxed().flatMap(version -> {
            Path folder = FOLDER.resolve("v" + version);
            Stream<DynamicTest> estimators = designs().stream().map(design -> DynamicTest.dynamicTest(
                    folder.resolve(name(design)).toString(), () -> {
                        Path file = folder.resolve(name(design) + ".state");
                        Estimator estimator = EstimatorState.read(file.toString(), Files.readAllBytes(file), Adwin::new);
                        assertEquals(design, estimator.design());
                        feed(estimator, SAVED, SAVED + GOES_ON);
                        near(same(version, design.degrees()), Files.readString(folder.resolve(name(design) + ".txt")),
                                said(estimator.track()),
                                version < WITH_BATCHES ? DEVIATION : List.of());
                    }));
            return Stream.concat(estimators, Stream.of(DynamicTest.dynamicTest(folder.resolve("seat").toString(), () -> {
                Path file = folder.resolve("seat.state");
                Seat seat = seat();
                StateReader.into(seat, file.toString(), Files.readAllBytes(file));
                near(same(version, 1), Files.readString(folder.resolve("seat.txt")), feed(seat, SAVED, SAVED + GOES_ON),
                        version == 1 ? List.of(3, 4, 5, 6) : version < WITH_BATCHES ? List.of(3) : List.of());
            })));
        });
    }

    private static double same(int version, int degrees) {
        return version < WITH_BATCHES ? READ_OTHERWISE[degrees] : ROUNDING;
    }

    /**
     * @param same tolerance of all others
     * @param otherwise places of what was found in another way before
     */
    private static void near(double same, String expected, String actual, List<Integer> otherwise) {
        String[] one = expected.trim().split(" ");
        String[] other = actual.split(" ");
        assertEquals(one.length, other.length);
        for (int i = 0; i < one.length; i++) {
            double value = Double.parseDouble(one[i]);
            double tolerance = !otherwise.contains(i) ? same : EXPOSURE.contains(i) ? WEIGHTED_OTHERWISE : Math.abs(value);
            assertEquals(value, Double.parseDouble(other[i]), tolerance * Math.max(1, Math.abs(value)), expected + " and " + actual);
        }
    }

    /** Writes the states of the present form, before it is released. */
    public static void main(String[] words) throws IOException {
        Path folder = Files.createDirectories(FOLDER.resolve("v" + StateWriter.VERSION));
        for (EstimatorDesign design : designs()) {
            Estimator estimator = design.estimator(Spec.at(Seats.RATE), Adwin::new);
            feed(estimator, 0, SAVED);
            Files.write(folder.resolve(name(design) + ".state"), EstimatorState.of(estimator));
            feed(estimator, SAVED, SAVED + GOES_ON);
            Files.writeString(folder.resolve(name(design) + ".txt"), said(estimator.track()) + "\n");
        }
        Seat seat = seat();
        feed(seat, 0, SAVED);
        Files.write(folder.resolve("seat.state"), StateWriter.of(seat));
        Files.writeString(folder.resolve("seat.txt"), feed(seat, SAVED, SAVED + GOES_ON) + "\n");
    }
}
