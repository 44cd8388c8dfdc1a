package wbv.control.trial;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleConsumer;
import java.util.function.Function;
import wbv.control.SeatController;
import wbv.control.SeatHardware;
import wbv.rig.Subject;
import wbv.signal.CrossSpectrum;
import wbv.signal.Detrend;
import wbv.signal.FrequencyResponse;
import wbv.signal.Segmentation;

/**
 * Controllers beside each other on floors and sitters, at equal stroke: that which a continuous skyhook needs that is tuned to the least
 * SEAT of the middle sitter without reaching a stop.
 *
 * @param request what was asked
 * @param floors by floor, in the order asked for
 */
public record Comparison(Request request, List<OnFloor> floors) {

    /** Share of the floor's greatest density from which on a transmissibility is told. */
    private static final double SHAKEN = 0.01;
    /** That to which all are held. */
    public static final Entrant SKYHOOK = new Entrant(ControllerFamily.SKYHOOK, Knowledge.FIXED);

    /**
     * What is asked.
     *
     * @param hardware the seat
     * @param floors under it
     * @param sitters on it
     * @param families of controllers, {@link ControllerFamily#SKYHOOK} is added
     * @param jolt every 10 s [m/s²], 0 for none
     * @param settle ridden but not judged [s]
     * @param seconds judged [s]
     * @param seed of floor and sensors
     */
    public record Request(SeatHardware hardware, List<Floor> floors, List<Subject> sitters, List<ControllerFamily> families, double jolt,
            double settle, double seconds, long seed) {

        public Request {
            floors = List.copyOf(floors);
            sitters = List.copyOf(sitters);
            families = List.copyOf(families);
            if (floors.isEmpty() || sitters.isEmpty() || families.isEmpty()) {
                throw new IllegalArgumentException("a comparison needs a floor, a sitter and a controller");
            }
        }
    }

    /** A controller and what it knows. */
    public record Entrant(ControllerFamily family, Knowledge knowledge) {

        /** Such as {@code active-lqg, scheduled}. */
        public String words() {
            return family.knowledge().size() == 1 ? family.word() : family.word() + ", " + knowledge.word();
        }
    }

    /**
     * One floor.
     *
     * @param floor       which
     * @param skyhook tuning of the skyhook whose stroke all are given [N·s/m]
     * @param damper      whichever of the controllers of a damper has the least SEAT with that stroke under the middle sitter
     * @param sitters     by sitter
     * @param transmissibility of each entrant's least SEAT on the first sitter, floor to seat pan
     */
    public record OnFloor(Floor floor, double skyhook, ControllerFamily damper, List<OnSitter> sitters,
            List<Transmissibility> transmissibility) {

        /** Sitters for whom the entrant has so little stroke. */
        public long within(Entrant entrant) {
            return sitters.stream().filter(one -> one.at(entrant).isPresent()).count();
        }

        /** Mean over all sitters for whom the entrant has so little stroke; empty if there is none. */
        public Optional<Front.AtStroke> mean(Entrant entrant) {
            List<Front.AtStroke> all = sitters.stream().flatMap(one -> one.at(entrant).stream()).toList();
            if (all.isEmpty()) {
                return Optional.empty();
            }
            double n = all.size();
            return Optional.of(new Front.AtStroke(all.stream().mapToDouble(Front.AtStroke::seat).sum() / n,
                    all.stream().mapToDouble(Front.AtStroke::head).sum() / n, all.stream().mapToDouble(Front.AtStroke::strokeRms).sum() / n,
                    all.stream().mapToDouble(Front.AtStroke::strokeMost).max().orElseThrow(),
                    all.stream().mapToDouble(Front.AtStroke::stopHits).sum() / n,
                    all.stream().mapToDouble(Front.AtStroke::power).sum() / n, all.stream().mapToDouble(Front.AtStroke::force).sum() / n));
        }
    }

    /**
     * One sitter on one floor.
     *
     * @param words who
     * @param mass [kg]
     * @param stroke that all are given, r.m.s. [m]
     * @param fronts by entrant
     */
    public record OnSitter(String words, double mass, double stroke, List<Front> fronts) {

        /** What an entrant comes to with the stroke that all are given. */
        public Optional<Front.AtStroke> at(Entrant entrant) {
            return front(entrant).at(stroke);
        }

        /** The front of an entrant. */
        public Front front(Entrant entrant) {
            return fronts.stream().filter(front -> front.family() == entrant.family() && front.knowledge() == entrant.knowledge())
                    .findFirst().orElseThrow();
        }
    }

    /**
     * How much of the floor reaches the pan. Arrays are not copied.
     *
     * @param frequency by line [Hz]
     * @param modulus ratio of seat pan to floor, by line; NaN where the floor tells nothing
     */
    public record Transmissibility(Entrant entrant, double[] frequency, double[] modulus) {}

    /**
     * Runs it, one ride after the other.
     *
     * @param progress hears shares from 0 to 1
     */
    public static Comparison run(Request request, DoubleConsumer progress) {
        List<OnFloor> floors = new ArrayList<>();
        List<Entrant> entrants = entrants(request);
        int done = 0;
        int all = request.floors().size() * request.sitters().size();
        for (Floor floor : request.floors()) {
            Maker maker = new Maker(request.hardware(), floor, request.seed());
            Front middle = front(request, maker, Maker.MIDDLE, SKYHOOK);
            double skyhook = middle.best().tuning();
            ControllerFamily damper = damper(request, maker, entrants, middle);
            List<OnSitter> sitters = new ArrayList<>();
            for (Subject sitter : request.sitters()) {
                List<Front> fronts = entrants.stream().map(entrant -> front(request, maker, sitter, entrant)).toList();
                double stroke = fronts.stream().filter(front -> front.family() == ControllerFamily.SKYHOOK)
                        .flatMap(front -> front.points().stream())
                        .filter(point -> point.tuning() == skyhook).findFirst().orElseThrow().result().strokeRms();
                sitters.add(new OnSitter(Sitters.words(sitter), sitter.mass(), stroke, fronts));
                progress.accept((double) ++done / all);
            }
            OnSitter first = sitters.get(0);
            floors.add(new OnFloor(floor, skyhook, damper, sitters, entrants.stream()
                    .map(entrant -> transmissibility(request, maker, entrant, first.front(entrant).best().tuning())).toList()));
        }
        return new Comparison(request, floors);
    }

    /** All controllers with all that they may know. */
    public List<Entrant> entrants() {
        return entrants(request);
    }

    private static List<Entrant> entrants(Request request) {
        List<Entrant> entrants = new ArrayList<>();
        for (ControllerFamily family : ControllerFamily.values()) {
            if (family == ControllerFamily.SKYHOOK || request.families().contains(family)) {
                family.knowledge().forEach(knowledge -> entrants.add(new Entrant(family, knowledge)));
            }
        }
        return entrants;
    }

    /**
     * The fixed one that serves the middle sitter best: a controller is chosen once for a floor, before anybody is known.
     *
     * @param skyhook its front under that sitter, whose best point says the stroke
     */
    private static ControllerFamily damper(Request request, Maker maker, List<Entrant> entrants, Front skyhook) {
        double stroke = skyhook.best().result().strokeRms();
        Map<ControllerFamily, Double> seats = new EnumMap<>(ControllerFamily.class);
        entrants.stream().filter(entrant -> entrant.family().setsDamper() && entrant.knowledge() == Knowledge.FIXED)
                .map(entrant -> entrant.equals(SKYHOOK) ? skyhook : front(request, maker, Maker.MIDDLE, entrant))
                .forEach(front -> front.at(stroke).ifPresent(found -> seats.put(front.family(), found.seat())));
        return seats.entrySet().stream().min(Map.Entry.comparingByValue()).orElseThrow().getKey();
    }

    private static Ride ride(Request request, Floor floor, Subject sitter) {
        return new Ride(sitter, floor, request.settle(), request.seconds(), request.seed()).withJolts(request.jolt());
    }

    private static Front front(Request request, Maker maker, Subject sitter, Entrant entrant) {
        SeatTrial trial = new SeatTrial(request.hardware(), ride(request, maker.floor(), sitter));
        List<Front.Point> points = new ArrayList<>();
        for (double tuning : entrant.family().tunings()) {
            points.add(new Front.Point(tuning, trial.run(maker, entrant.family(), entrant.knowledge(), tuning)));
        }
        return new Front(entrant.family(), entrant.knowledge(), points);
    }

    private static Transmissibility transmissibility(Request request, Maker maker, Entrant entrant, double tuning) {
        double rate = SeatController.RATE;
        CrossSpectrum spectrum = new CrossSpectrum(Segmentation.lasting(rate, Math.min(4, request.seconds() / 2)), Detrend.MEAN, 1);
        new SeatTrial(request.hardware(), ride(request, maker.floor(), request.sitters().get(0))).run(maker, entrant.family(),
                entrant.knowledge(), tuning, (time, floor, seat, deflection, weightedSeat, weightedFloor) -> spectrum.accept(floor, seat));
        FrequencyResponse response = spectrum.response(0, FrequencyResponse.Excited.USUAL);
        double enough = SHAKEN * Arrays.stream(response.inputDensity()).max().orElse(0);
        List<Integer> bins = new ArrayList<>();
        for (int i = 0; i < response.frequency().length; i++) {
            if (response.frequency()[i] >= 0.5 && response.frequency()[i] <= 20) {
                bins.add(i);
            }
        }
        return new Transmissibility(entrant, bins.stream().mapToDouble(i -> response.frequency()[i]).toArray(),
                bins.stream().mapToDouble(i -> response.inputDensity()[i] >= enough ? response.h1().magnitude(i) : Double.NaN).toArray());
    }

    /**
     * What knowing the sitter is worth to a family at equal stroke: SEAT of the fixed controller less that of one that knows more, mean
     * over all floors and sitters at which all of them have so little stroke.
     */
    public Optional<Gain> gain(ControllerFamily family) {
        if (!entrants().contains(new Entrant(family, Knowledge.SCHEDULED))) {
            return Optional.empty();
        }
        double fixed = 0;
        double scheduled = 0;
        double oracle = 0;
        int count = 0;
        for (OnFloor floor : floors) {
            for (OnSitter sitter : floor.sitters()) {
                Optional<Front.AtStroke> f = sitter.at(new Entrant(family, Knowledge.FIXED));
                Optional<Front.AtStroke> s = sitter.at(new Entrant(family, Knowledge.SCHEDULED));
                Optional<Front.AtStroke> o = sitter.at(new Entrant(family, Knowledge.ORACLE));
                if (f.isPresent() && s.isPresent() && o.isPresent()) {
                    fixed += f.get().seat();
                    scheduled += s.get().seat();
                    oracle += o.get().seat();
                    count++;
                }
            }
        }
        return count == 0 ? Optional.empty()
                : Optional.of(new Gain(fixed / count, (fixed - scheduled) / count, (fixed - oracle) / count, count));
    }

    /**
     * A family's scheduled controllers, or fixed ones where it knows no sitter, beside the skyhook at the stroke that that takes: rides
     * that count, those with more than 1.02 times its SEAT, the greatest ratio and the mean one.
     */
    public Beside besideSkyhook(ControllerFamily family) {
        return besideSkyhook(floor -> family);
    }

    /** The same of the damper's controllers that were chosen, each on its floor. */
    public Beside dampersBesideSkyhook() {
        return besideSkyhook(OnFloor::damper);
    }

    private Beside besideSkyhook(Function<OnFloor, ControllerFamily> families) {
        List<Double> ratios = new ArrayList<>();
        for (OnFloor floor : floors) {
            ControllerFamily family = families.apply(floor);
            Knowledge knowledge = family.knowledge().contains(Knowledge.SCHEDULED) ? Knowledge.SCHEDULED : Knowledge.FIXED;
            for (OnSitter sitter : floor.sitters()) {
                double skyhook = sitter.at(SKYHOOK).orElseThrow().seat();
                sitter.at(new Entrant(family, knowledge)).ifPresent(found -> ratios.add(found.seat() / skyhook));
            }
        }
        return new Beside(ratios.size(), (int) ratios.stream().filter(ratio -> ratio > 1.02).count(),
                ratios.stream().mapToDouble(Double::doubleValue).max().orElse(Double.NaN),
                ratios.stream().mapToDouble(Double::doubleValue).average().orElse(Double.NaN));
    }

    /**
     * A controller beside the fixed skyhook.
     *
     * @param rides that count
     * @param worse with more than 1.02 times the skyhook's SEAT
     * @param worst greatest ratio
     * @param mean ratio
     */
    public record Beside(int rides, int worse, double worst, double mean) {

        /** A clause. */
        public String words() {
            return String.format(Locale.ROOT,
                    "%.2f times the skyhook's SEAT at its stroke in the mean, more than 1.02 times in %d of %d ride%s, at most %.2f times",
                    mean,
                    worse, rides, rides == 1 ? "" : "s", worst);
        }
    }

    /**
     * What knowing the sitter is worth at equal stroke.
     *
     * @param fixed mean SEAT of the fixed controller [1]
     * @param scheduled how much less the scheduled one has [1]
     * @param oracle likewise
     * @param rides that count
     */
    public record Gain(double fixed, double scheduled, double oracle, int rides) {

        /** One sentence. */
        public String words(ControllerFamily family) {
            return String.format(Locale.ROOT,
                    "%s: at equal stroke a SEAT of %.3f when fixed, %+.4f when scheduled and %+.4f for the oracle, over %d ride%s",
                    family.word(), fixed, -scheduled, -oracle, rides, rides == 1 ? "" : "s");
        }
    }
}
