package wbv.control.trial;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.DoubleConsumer;
import org.apache.commons.math3.random.RandomGenerator;
import wbv.control.OptimalSeat;
import wbv.control.SeatHardware;
import wbv.rig.Subject;
import wbv.rig.platform.Seeds;

/**
 * Controllers under faults: rides of 12 s on a class of earth mover, with a sitter, a fault and a controller that a seed draws, each
 * beside a passive seat under the same fault.
 *
 * @param cases by fault
 */
public record Endurance(Map<String, Case> cases) {

    private static final List<
            ControllerFamily> FAMILIES = List.of(ControllerFamily.CLIPPED, ControllerFamily.ACTIVE, ControllerFamily.WORST);
    /** Of their stroke: comfort before it. */
    private static final double PRICE = 0.4;
    private static final double SETTLE = 3;
    private static final double SECONDS = 12;

    /** What is drawn. */
    private enum Fault {
        LOSS("30 % of all readings lost"), FLOOR("floor sensor silent"), FRAME("frame sensor silent"),
        DEFLECTION("deflection sensor silent"), SPRING("spring force silent"), TRUNK("worn sensor silent"), DELAY("10 ms more delay"),
        LOW("told half the mass, frequency and damping"),
        HIGH("told 1.5 times the mass, frequency and damping"), CHANGE("sitter changes from 75 to 55 kg");

        private final String words;

        Fault(String words) {
            this.words = words;
        }
    }

    /**
     * Rides with one fault.
     *
     * @param rides how many
     * @param unstable how many ended in numbers that no seat has
     * @param worse how many had more than 1.25 times the weighted acceleration of a passive seat of {@link OptimalSeat#RESERVE}
     * @param worst greatest ratio to it
     */
    public record Case(int rides, int unstable, int worse, double worst) {

        private static final Case NONE = new Case(0, 0, 0, 0);

        private Case with(TrialResult result, TrialResult passive) {
            double ratio = result.seat() / passive.seat();
            boolean stable = result.stable();
            return new Case(rides + 1, unstable + (stable ? 0 : 1), worse + (ratio <= 1.25 ? 0 : 1), Math.max(worst, ratio));
        }
    }

    /**
     * Rides under faults drawn by seed.
     *
     * @param seeds number of rides, &gt;= 1
     * @param progress hears shares from 0 to 1
     */
    public static Endurance run(SeatHardware hardware, int seeds, long first, DoubleConsumer progress) {
        Map<EarthMover, Maker> makers = new EnumMap<>(EarthMover.class);
        List<Subject> sitters = Sitters.first(20);
        Map<String, Case> cases = new TreeMap<>();
        for (int i = 0; i < seeds; i++) {
            RandomGenerator random = new Seeds(first + i).source("endurance");
            EarthMover floor = EarthMover.values()[random.nextInt(EarthMover.values().length)];
            Maker maker = makers.computeIfAbsent(floor, each -> new Maker(hardware, each, 1));
            Subject sitter = sitters.get(random.nextInt(sitters.size()));
            Fault fault = Fault.values()[i % Fault.values().length];
            ControllerFamily family = FAMILIES.get(random.nextInt(FAMILIES.size()));
            SeatTrial trial = new SeatTrial(hardware,
                    new Ride(fault == Fault.CHANGE ? Sitters.ofMass(75) : sitter, floor, SETTLE, SECONDS, first + i)
                            .with(faults(fault)));
            TrialResult result = switch (fault) {
                case LOW -> trial.runMisled(maker, family, PRICE, 0.5);
                case HIGH -> trial.runMisled(maker, family, PRICE, 1.5);
                default -> trial.run(maker, family, Knowledge.SCHEDULED, PRICE);
            };
            TrialResult passive = trial.run(maker, ControllerFamily.PASSIVE, Knowledge.FIXED, OptimalSeat.RESERVE);
            cases.merge(fault.words + ", " + family.word(), Case.NONE.with(result, passive), (before, one) -> before.with(result, passive));
            progress.accept((i + 1.0) / seeds);
        }
        return new Endurance(cases);
    }

    private static Faults faults(Fault fault) {
        Optional<Faults.Silence> silence = switch (fault) {
            case FLOOR, FRAME, DEFLECTION, SPRING, TRUNK -> Optional.of(new Faults.Silence(Faults.Sensor.valueOf(fault.name()), 3));
            default -> Optional.empty();
        };
        Optional<Faults.Change> change = fault == Fault.CHANGE ? Optional.of(new Faults.Change(Sitters.ofMass(55), 3)) : Optional.empty();
        return new Faults(fault == Fault.LOSS ? 0.3 : 0, silence, fault == Fault.DELAY ? 0.010 : 0, change);
    }

    /** How long the scheduled controllers take for a sitter of 75 kg who becomes one of 55 kg. */
    public static List<Recovery> recover(SeatHardware hardware, long seed, DoubleConsumer progress) {
        List<Recovery> all = new ArrayList<>();
        for (EarthMover floor : EarthMover.values()) {
            Maker maker = new Maker(hardware, floor, seed);
            for (ControllerFamily family : FAMILIES) {
                all.add(Recovery.of(maker, family, PRICE, seed));
            }
            progress.accept((floor.ordinal() + 1.0) / EarthMover.values().length);
        }
        return all;
    }
}
