package wbv.bench;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import wbv.filter.AccompaniedEstimator;
import wbv.filter.BodyEstimate;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.SimulatedSitter;
import wbv.filter.drift.Adwin;
import wbv.filter.model.Adaptation;
import wbv.filter.model.Spec;

/**
 * What a half and a double of each number of {@link Adaptation} does to the estimate of simulated sitters, as the table of {@code
 * docs/adaptation.md}: {@code AdaptationTable SITTERS [GROUP…]}. Each number is varied in an estimator that uses it; sitters, shaking and
 * noise are the same for all, so that differences are taken sitter by sitter.
 */
public final class AdaptationTable {

    private static final double RATE = SimulatedSitter.RATE;
    private static final double RMS = 0.8;
    private static final double SECONDS = 95;
    /** Errors count from then on [s]. */
    private static final double FROM = 15;
    private static final double STEP = 50;
    /** A change is heard if it is heard within so many seconds. */
    private static final double SOON = 15;
    /** Of which the rest to one is halved and doubled. */
    private static final Set<String> NEAR_ONE = Set.of("particles.discount", "noise.mostCorrelation");
    /** Of which the logarithm is halved and doubled. */
    private static final Set<String> FACTORS = Set.of("wandering.ratio", "prior.apart");
    private static final Set<String> OWN_INNOVATIONS = Set.of("changes.larger", "changes.mostInSum", "changes.largestSum", "changes.step",
            "changes.stepEvidence", "changes.mostDeviation", "changes.mostAtOnce", "wandering.share", "wandering.most",
            "wandering.shortest");

    /** Standard errors beyond which a difference is shown: of 800 without any, two are. */
    private static final double ERRORS = 3;

    private final int sitters;
    private final Map<Integer, List<Ride>> rides = new HashMap<>();
    private final Map<List<Object>, List<Outcome>> usually = new HashMap<>();

    private AdaptationTable(int sitters) {
        this.sitters = sitters;
    }

    /** One sitter in one kind of ride. */
    private record Ride(SimulatedSitter sitter, DoubleUnaryOperator stiffness, boolean changes, double[] u, double[] other, double[] y,
            double noise, long seed) {}

    /** Mean square errors of ln f0 and ln ζ, and of f0's over its deviation; 1 where the change was heard soon; alarms otherwise. */
    private record Outcome(double frequency, double damping, double normalised, double heard, double falsely) {

        double[] values() {
            return new double[] {frequency, damping, normalised, heard, falsely};
        }
    }

    public static void main(String[] words) throws ReflectiveOperationException {
        AdaptationTable table = new AdaptationTable(Integer.parseInt(words[0]));
        List<String> groups = Arrays.asList(words).subList(1, words.length);
        System.out.println(
                "| number | value | by | error of f0 | error of ζ | error over deviation | changes heard | false alarms an hour |");
        System.out.println("|---|---|---|---|---|---|---|---|");
        for (RecordComponent group : Adaptation.class.getRecordComponents()) {
            if (groups.isEmpty() || groups.contains(group.getName())) {
                for (RecordComponent each : group.getType().getRecordComponents()) {
                    table.row(group, each);
                }
            }
        }
    }

    private void row(RecordComponent group, RecordComponent each) throws ReflectiveOperationException {
        String name = group.getName() + "." + each.getName();
        Method method = group.getName().equals("particles") ? Method.PARTICLE : group.getName().equals("fusion") ? Method.FUSED
                : OWN_INNOVATIONS.contains(name) ? Method.UNSCENTED : Method.EKF_ADWIN;
        boolean slow = method == Method.PARTICLE || method == Method.FUSED;
        int degrees = name.equals("prior.apart") || name.equals("prior.firstsShare") ? 2 : 1;
        int number = slow ? Math.max(2, sitters / 6) : sitters;
        boolean other = group.getName().equals("others");
        List<Ride> those = rides.computeIfAbsent(other ? -number : number, key -> rides(number, other));
        List<Outcome> usual = usually.computeIfAbsent(List.of(method, degrees, number, other),
                key -> {
                    List<Outcome> all = outcomes(those, method, degrees, Adaptation.USUAL);
                    level(key, all);
                    return all;
                });
        List<Optional<List<Outcome>>> varied = new ArrayList<>();
        for (double factor : new double[] {0.5, 2}) {
            varied.add(with(group, each, factor).map(adaptation -> outcomes(those, method, degrees, adaptation)));
        }
        Object value = each.getAccessor().invoke(group.getAccessor().invoke(Adaptation.USUAL));
        StringBuilder line = new StringBuilder("| " + name + " | " + value + " | " + method.word() + " |");
        for (int k = 0; k < 5; k++) {
            int column = k;
            line.append(' ').append(varied.stream()
                    .map(one -> one.map(outcome -> usual.equals(outcome) ? "=" : cell(usual, outcome, column)).orElse("–"))
                    .collect(Collectors.joining(" / "))).append(" |");
        }
        System.out.println(line);
    }

    /** Difference of two runs of the same sitters, where it is more than {@value #ERRORS} times its standard error. */
    private static String cell(List<Outcome> usual, List<Outcome> varied, int k) {
        double[] apart = IntStream.range(0, usual.size()).mapToDouble(i -> scale(varied.get(i), k) - scale(usual.get(i), k))
                .filter(Double::isFinite).toArray();
        double mean = Arrays.stream(apart).average().orElse(0);
        double square = Arrays.stream(apart).map(x -> (x - mean) * (x - mean)).sum();
        if (!(Math.abs(mean) > ERRORS * Math.sqrt(square / (apart.length * (apart.length - 1.0))))) {
            return "·";
        }
        return switch (k) {
            case 0, 1, 2 -> String.format(Locale.ROOT, "%+.1f %%", 100 * (Math.exp(mean / 2) - 1));
            case 3 -> String.format(Locale.ROOT, "%+.0f %%", 100 * mean);
            default -> String.format(Locale.ROOT, "%+.1f", mean);
        };
    }

    /** Errors on a logarithmic scale, so that a sitter who is hard to follow counts as any other. */
    private static double scale(Outcome outcome, int k) {
        double value = outcome.values()[k];
        return k < 3 ? Math.log(value) : value;
    }

    private static void level(List<Object> of, List<Outcome> usual) {
        double[] mean = IntStream.range(0, 5).mapToDouble(k -> usual.stream().mapToDouble(outcome -> scale(outcome, k))
                .filter(Double::isFinite).average().orElse(Double.NaN)).toArray();
        System.err.printf(Locale.ROOT,
                "%s: error of f0 %.2f %%, of zeta %.1f %%, over deviation %.2f, heard %.0f %%, falsely %.1f an hour%n", of,
                100 * Math.exp(mean[0] / 2), 100 * Math.exp(mean[1] / 2), Math.exp(mean[2] / 2), 100 * mean[3], mean[4]);
    }

    private static List<Ride> rides(int sitters, boolean other) {
        List<Ride> rides = new ArrayList<>();
        for (int seed = 0; seed < sitters; seed++) {
            Random random = new Random(77_000 + seed);
            SimulatedSitter sitter = new SimulatedSitter(2 * Math.pow(4, random.nextDouble()), 0.15 + 0.45 * random.nextDouble());
            double factor = random.nextBoolean() ? 1.25 : 0.8;
            for (int kind = 0; kind < 4; kind++) {
                rides.add(ride(sitter, kind, factor, other, random, 4L * seed + kind));
            }
        }
        return rides;
    }

    /** @param kind steady with noise of 20 dB; a step of the stiffness; motion beside the model; the same with losses and a step */
    private static Ride ride(SimulatedSitter sitter, int kind, double factor, boolean other, Random random, long seed) {
        boolean changes = kind % 2 == 1;
        DoubleUnaryOperator stiffness = t -> changes && t > STEP ? factor : 1;
        double noise = kind == 0 ? RMS / 10 : Spec.noise(RATE);
        SimulatedSitter.Motion motion = sitter.changing(stiffness, RMS, SECONDS, seed).measured(noise, seed);
        double[] u = motion.u();
        double[] y = motion.y();
        double[] aside = other ? new SimulatedSitter(4, 0.3).steady(RMS, u.length, seed + 500).u() : new double[u.length];
        double slow = 0;
        double before = 0;
        for (int i = 0; i < u.length; i++) {
            slow += (random.nextGaussian() - slow) / 20;
            before += 0.3 * (aside[i] - before);
            y[i] += 0.5 * before + (kind >= 2 ? RMS * slow : 0);
        }
        for (int gap = 0; kind == 3 && gap < 8; gap++) {
            int from = random.nextInt(u.length - 120);
            Arrays.fill(random.nextBoolean() ? u : y, from, from + 1 + random.nextInt(random.nextInt(8) == 0 ? 119 : 10), Double.NaN);
        }
        return new Ride(sitter, stiffness, changes, u, aside, y, noise, seed);
    }

    private static List<Outcome> outcomes(List<Ride> rides, Method method, int degrees, Adaptation adaptation) {
        return rides.parallelStream().map(ride -> outcome(ride, method, degrees, adaptation)).toList();
    }

    private static Outcome outcome(Ride ride, Method method, int degrees, Adaptation adaptation) {
        Spec spec = new Spec(RATE, 5, 0.4, ride.noise, ride.noise, Spec.DRIFT, adaptation);
        AccompaniedEstimator estimator = new AccompaniedEstimator(EstimatorDesign.of(method).withDegrees(degrees).withSeed(ride.seed)
                .estimator(spec, () -> new Adwin(Adwin.USUAL)), Arrays.stream(ride.other).allMatch(x -> x == 0) ? 0 : 1);
        double[] others = new double[1];
        double frequency = 0;
        double damping = 0;
        double normalised = 0;
        double heard = 0;
        double falsely = 0;
        int n = 0;
        for (int i = 0; i < ride.u.length; i++) {
            others[0] = ride.other[i];
            BodyEstimate track = estimator.step(ride.u[i], others, ride.y[i]);
            double t = i / RATE;
            boolean due = ride.changes && t > STEP && t < STEP + SOON;
            heard = due && track.changed() ? 1 : heard;
            falsely += !due && t >= FROM && track.changed() ? 1 : 0;
            if (t >= FROM) {
                SimulatedSitter now = ride.sitter.withStiffness(ride.stiffness.applyAsDouble(t));
                double df = Math.log(track.frequency() / now.frequency());
                double dz = Math.log(track.damping() / now.damping());
                double z = df * track.frequency() / track.frequencyDeviation();
                frequency += Math.min(1, df * df);
                damping += Math.min(1, dz * dz);
                normalised += ride.changes ? 0 : Math.min(100, z * z);
                n++;
            }
        }
        return new Outcome(frequency / n, damping / n, ride.changes ? Double.NaN : normalised / n, ride.changes ? heard : Double.NaN,
                falsely * 3600 / (SECONDS - FROM));
    }

    /** The usual numbers but for one, where that may be. */
    private static Optional<Adaptation> with(RecordComponent group, RecordComponent each, double factor)
            throws ReflectiveOperationException {
        try {
            String name = group.getName() + "." + each.getName();
            Object part = varied(group.getAccessor().invoke(Adaptation.USUAL), each.getName(), value -> NEAR_ONE.contains(name)
                    ? 1 - (1 - value) * factor : FACTORS.contains(name) ? Math.pow(value, factor) : value * factor);
            return Optional.of(Adaptation.USUAL.with((Adaptation.Part) part));
        } catch (InvocationTargetException refused) {
            if (refused.getCause() instanceof IllegalArgumentException) {
                return Optional.empty();
            }
            throw refused;
        }
    }

    /** A record with one of its numbers changed. */
    private static Object varied(Object part, String name, DoubleUnaryOperator by) throws ReflectiveOperationException {
        RecordComponent[] components = part.getClass().getRecordComponents();
        Object[] values = new Object[components.length];
        for (int i = 0; i < values.length; i++) {
            Number value = (Number) components[i].getAccessor().invoke(part);
            double other = components[i].getName().equals(name) ? by.applyAsDouble(value.doubleValue()) : value.doubleValue();
            values[i] = value instanceof Long ? (Object) Math.round(other) : (Object) other;
        }
        return part.getClass().getDeclaredConstructor(Arrays.stream(components).map(RecordComponent::getType).toArray(Class[]::new))
                .newInstance(values);
    }
}
