package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.TDistribution;
import wbv.body.Model;
import wbv.body.simulate.Excitation;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.search.Effort;
import wbv.diagnosis.search.Priors;
import wbv.diagnosis.search.Search;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.Recording;

/**
 * Force sensors that count the other way round than the model does.
 *
 * <p>A bench is passive: on average a force does work on the body that it pushes, and what a link carries on what stretches it. A sensor
 * whose force takes energy out, by motion that other sensors or the model tell, is asked: does the model fit much better with its sign
 * turned?
 */
final class ForceSign {

    /** Student's t that the mean of so many stretches passes by chance as rarely as is believed. */
    private static final double SURE = new TDistribution(Effort.STRETCHES - 1).inverseCumulativeProbability(1 - Priors.CHANCE);

    private final Question question;
    private final Evidence evidence;

    private ForceSign(Question question, Evidence evidence) {
        this.question = question;
        this.evidence = evidence;
    }

    /**
     * A question with forces turned.
     *
     * @param sentence that says which, and why
     */
    record Turned(Question question, String sentence) {}

    /** The question with those forces turned that are of the other sign; empty where none is, or nothing tells. */
    static Optional<Turned> in(Question question, Evidence evidence) {
        return evidence.onRig() ? new ForceSign(question, evidence).turned() : Optional.empty();
    }

    private Optional<Turned> turned() {
        Model model = evidence.model();
        Motion motion = Motion.measured(evidence, model.assembly());
        List<Channel> draining = new ArrayList<>(
                model.inputs().stream().filter(input -> drains(input, evidence)).map(Model.Input::sensor).toList());
        IntStream.range(0, model.links().size()).filter(l -> drains(l, evidence, motion))
                .mapToObj(l -> model.links().get(l).sensor().orElseThrow())
                .forEach(draining::add);
        if (draining.isEmpty()) {
            return Optional.empty();
        }
        double asRecorded = base(evidence).reduced();
        return sets(draining).stream().map(set -> candidate(set, asRecorded)).flatMap(Optional::stream).findFirst();
    }

    /** All of them, then each by itself. */
    private static List<List<Channel>> sets(List<Channel> channels) {
        List<List<Channel>> out = new ArrayList<>(List.of(channels));
        if (channels.size() > 1) {
            channels.forEach(channel -> out.add(List.of(channel)));
        }
        return out;
    }

    private Optional<Turned> candidate(List<Channel> channels, double asRecorded) {
        Map<Channel, double[]> values = new HashMap<>();
        Recording recording = question.recording();
        recording.channels().forEach(channel -> values.put(channel,
                channels.contains(channel) ? negative(recording.values(channel)) : recording.values(channel)));
        Question other = question.with(recording.with(values));
        Evidence turned = new Evidence(other.asked(), other.recording(), other.noise(), other.provedFrom());
        double left = base(turned).reduced();
        if (!(left < Priors.MAJORITY * asRecorded)) {
            return Optional.empty();
        }
        String names = String.join(" and ", channels.stream().map(Channel::toString).toList());
        boolean one = channels.size() == 1;
        return Optional.of(new Turned(other, names + (one ? " is" : " are") + " of the other sign than the model's, and "
                + (one ? "was" : "were") + String.format(java.util.Locale.ROOT,
                        " turned: as recorded %s would take energy out of a bench that has none to give, and the model would leave %.3g "
                                + "times what it leaves now; turn %s in the recording too before the model is simulated on it.",
                        one ? "it" : "they", asRecorded / left, one ? "it" : "them")));
    }

    private static double[] negative(double[] x) {
        return Arrays.stream(x).map(value -> -value).toArray();
    }

    private static Fitter.State base(Evidence evidence) {
        return new Search(evidence, (step, share) -> {}).base(Baseline.of(evidence));
    }

    /** Whether a measured force takes energy out of the body that it pushes, by that body's own sensor. */
    private static boolean drains(Model.Input input, Evidence evidence) {
        Model model = evidence.model();
        Optional<Channel> sensor = model.bodies().get(model.index(input.body())).sensor();
        return sensor.filter(channel -> drains(evidence.series(input.sensor()), velocity(evidence, channel))).isPresent();
    }

    /** Whether the force measured in a link takes energy out of it, by the link's motion. */
    private static boolean drains(int link, Evidence evidence, Motion motion) {
        Optional<Channel> sensor = evidence.model().links().get(link).sensor();
        Excitation excitation = evidence.excitation();
        int finer = excitation.fineSamples() / excitation.samples();
        double[] fine = motion.velocity(link);
        double[] v = IntStream.range(0, fine.length / finer).mapToDouble(i -> fine[i * finer]).toArray();
        return sensor.filter(channel -> drains(evidence.series(channel), v)).isPresent();
    }

    private static double[] velocity(Evidence evidence, Channel sensor) {
        Excitation whole = evidence.whole();
        double[] x = evidence.series(sensor);
        double mean = Arrays.stream(x).average().orElse(0);
        double[] spectrum = whole.spectrum(Arrays.stream(x).map(value -> value - mean).toArray());
        int order = sensor.quantity() == Quantity.POSITION ? 1 : sensor.quantity() == Quantity.VELOCITY ? 0 : -1;
        double[] omega = whole.omega();
        for (int k = 0; k < omega.length; k++) {
            double re = spectrum[2 * k];
            double im = spectrum[2 * k + 1];
            double factor = order == 0 ? 1 : order > 0 ? omega[k] : k == 0 ? 0 : -1 / omega[k];
            spectrum[2 * k] = order == 0 ? re : -factor * im;
            spectrum[2 * k + 1] = order == 0 ? im : factor * re;
        }
        return whole.series(spectrum);
    }

    /**
     * Whether the mean power of a force is negative beyond chance, as its scatter over stretches has it. Means count for nothing: they are
     * offsets.
     */
    private static boolean drains(double[] force, double[] velocity) {
        int n = Math.min(force.length, velocity.length);
        double mean = Arrays.stream(force, 0, n).average().orElse(0);
        double[] work = new double[Effort.STRETCHES];
        for (int i = 0; i < n; i++) {
            work[(int) ((long) i * Effort.STRETCHES / n)] += (force[i] - mean) * velocity[i];
        }
        double average = Arrays.stream(work).average().orElse(0);
        double square = Arrays.stream(work).map(w -> (w - average) * (w - average)).sum() / (Effort.STRETCHES - 1);
        return average < -SURE * Math.sqrt(square / Effort.STRETCHES);
    }
}
