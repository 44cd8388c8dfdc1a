package wbv.diagnosis.convention;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import wbv.body.Model;
import wbv.recording.Channel;
import wbv.recording.Recording;

/** One way in which a recording or a model may be meant otherwise than it is read. */
public sealed interface Convention permits Convention.Misread, Convention.Exchanged, Convention.InUnits, Both {

    /** The recording as it is meant. */
    Recording read(Recording recording);

    /** The model as it is meant. */
    Model read(Model model);

    /** Channels whose values change. */
    Set<Channel> touched();

    /** The channel whose recorded values a channel has as it is meant, but for a factor. */
    default Channel source(Channel channel) {
        return channel;
    }

    /** Whether it changes numbers of the model. */
    default boolean ofNumbers() {
        return false;
    }

    /** Whether another may be amiss beside it: one that has to do with something else. */
    default boolean goesWith(Convention other) {
        return !(ofNumbers() && other.ofNumbers()) && Collections.disjoint(touched(), other.touched());
    }

    /** What is amiss, as a clause. */
    String amiss();

    /** What was done about it, as the end of that clause. */
    String done();

    /** What the user does about it, as a clause. */
    String remedy();

    /**
     * A channel that reads another multiple of what it says.
     *
     * @param factor what it reads over what is there in SI units [1]
     * @param unit   the unit that it is in then, but for its sign; empty where that is SI
     */
    record Misread(Channel channel, double factor, String unit) implements Convention {
        public Misread {
            if (!(Math.abs(factor) > 0 && Double.isFinite(factor)) || factor == 1) {
                throw new IllegalArgumentException("factor must be finite, neither 0 nor 1: " + factor);
            }
        }

        /** Whether it is of the other sign. */
        boolean turned() {
            return factor < 0;
        }

        @Override
        public Recording read(Recording recording) {
            return with(recording, Map.of(channel, Arrays.stream(recording.values(channel)).map(x -> x / factor).toArray()));
        }

        @Override
        public Model read(Model model) {
            return model;
        }

        @Override
        public Set<Channel> touched() {
            return Set.of(channel);
        }

        @Override
        public String amiss() {
            String sign = "is of the other sign than the model's";
            String times = new BigDecimal(Math.abs(factor)).round(new MathContext(3)).stripTrailingZeros().toPlainString();
            String amount = "reads " + times + " times what the model makes of it";
            return channel + " " + (unit.isEmpty() ? sign : turned() ? amount + " and " + sign : amount);
        }

        @Override
        public String done() {
            return "was " + (unit.isEmpty() ? "turned" : "read in " + unit + (turned() ? " and turned" : ""));
        }

        @Override
        public String remedy() {
            return "say " + Stream.of(unit.isEmpty() ? "" : "\"unit\": \"" + unit + "\"", turned() ? "\"scale\": -1" : "")
                    .filter(word -> !word.isEmpty()).collect(Collectors.joining(", ")) + " of " + channel + " in a column map (--map)";
        }
    }

    /** Two channels of one quantity, each of which has the other's name. */
    record Exchanged(Channel one, Channel other) implements Convention {
        public Exchanged {
            if (one.equals(other) || one.quantity() != other.quantity()) {
                throw new IllegalArgumentException("two channels of one quantity are exchanged: " + one + " and " + other);
            }
        }

        @Override
        public Recording read(Recording recording) {
            return with(recording, Map.of(one, recording.values(other), other, recording.values(one)));
        }

        @Override
        public Model read(Model model) {
            return model;
        }

        @Override
        public Set<Channel> touched() {
            return Set.of(one, other);
        }

        @Override
        public Channel source(Channel channel) {
            return channel.equals(one) ? other : channel.equals(other) ? one : channel;
        }

        @Override
        public String amiss() {
            return one + " and " + other + " have each other's name";
        }

        @Override
        public String done() {
            return "were exchanged";
        }

        @Override
        public String remedy() {
            return "exchange " + one + " and " + other + " in a column map (--map)";
        }
    }

    /**
     * Numbers of the model in another unit than its keys say.
     *
     * @param what    which of them, in words
     * @param stiffness by what factor it is taken more [1]
     * @param damping by what factor [1]
     * @param mass    by what factor, a moment of inertia too [1]
     * @param unit    what they are in
     */
    record InUnits(String what, double stiffness, double damping, double mass, String unit) implements Convention {
        public InUnits {
            if (!(stiffness > 0 && damping > 0 && mass > 0)) {
                throw new IllegalArgumentException("factors must be > 0: " + List.of(stiffness, damping, mass));
            }
        }

        @Override
        public Recording read(Recording recording) {
            return recording;
        }

        @Override
        public Model read(Model model) {
            List<Model.Link> links = model.links().stream().map(link -> link.completed(stiffness * link.stiffness(),
                    damping * link.damping(), link.laws(), link.drives(), link.faults())).toList();
            List<Model.Body> bodies = model.bodies().stream().map(body -> body.fixed() ? body
                    : body.completed(mass * body.mass(), body.faults(), body.hidden(), body.forces())).toList();
            return model.with(bodies, links);
        }

        @Override
        public Set<Channel> touched() {
            return Set.of();
        }

        @Override
        public boolean ofNumbers() {
            return true;
        }

        @Override
        public String amiss() {
            return "the model's " + what + " look to be in " + unit;
        }

        @Override
        public String done() {
            return "were read so";
        }

        @Override
        public String remedy() {
            return "give the model's " + what + " in the units that its keys say";
        }
    }

    private static Recording with(Recording recording, Map<Channel, double[]> others) {
        Map<Channel, double[]> values = new LinkedHashMap<>();
        recording.channels().forEach(channel -> values.put(channel, others.getOrDefault(channel, recording.values(channel))));
        return recording.with(values);
    }
}
