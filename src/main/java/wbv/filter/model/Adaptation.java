package wbv.filter.model;

import java.io.Serializable;
import org.apache.commons.math3.special.Erf;

/**
 * The numbers by which estimators adapt to what they meet: all that is chosen and not derived, in one place, each with its unit. What a
 * half and a double of each does to the estimate of simulated sitters is measured in docs/adaptation.md. Where no source stands a number
 * was chosen on such sitters; most may be twice or half of it and little happens, and the table says which may not.
 *
 * @param prior what is believed before the first sample
 * @param information when samples tell about a body
 * @param noise how what a model does not explain is learned
 * @param wandering how parameters may move
 * @param watch when innovations are what a filter expects
 * @param changes when a body has changed
 * @param scatter how far an estimate really scatters
 * @param restart when an estimate begins anew
 * @param particles of a particle filter
 * @param fusion of several estimators
 * @param others other motions of the base
 */
public record Adaptation(Prior prior, Information information, Noise noise, Wandering wandering, Watch watch, Changes changes,
        Scatter scatter, Restart restart, Particles particles, Fusion fusion, Others others) implements Serializable {

    /** What belongs together of these numbers. */
    public sealed interface Part extends Serializable {}

    /** The numbers that are used where nobody says otherwise. */
    public static final Adaptation USUAL = new Adaptation(new Prior(0.5, 1, 1, 2, 0.8), new Information(0.1, 0.5, 2, 1, 1, 5),
            new Noise(2, 1, 0.5, 10, 0.25, 25, 1, 3, 0.01, 0.1, 0.08, 0.9, 5, 1), new Wandering(0.5, 0.1, 60, 0.25, 10, 300, 3, 2, 4),
            new Watch(5, 3, 10, 0.75, 0.25, 1.5, 30, 100, 5), new Changes(4, 9, 0.4, 0.06, 10, 3, 1, 86400, 4, 20, 10),
            new Scatter(6, 20), new Restart(0.5, 5, 60, 0.5, 1, 5, 10), new Particles(0.98, 40, 0.25, 0.5, 0.5, 20, 0.03, 1.5),
            new Fusion(5, 50, 3, 8, 0.1, 1, 16, 0.05, 1, 0.4, 3, 1), new Others(17, 60, 3, 1, 3, 25, 1, 3));

    /**
     * What is believed before the first sample.
     *
     * @param parameters  standard deviation of the parameters [1, of their logarithms]
     * @param motion      standard deviation of the acceleration that the body may already have [m/s² or rad/s]
     * @param offset      standard deviation of the offset between the two sensors [m/s² or rad/s]
     * @param apart       frequency at which a second mode starts, over the first's [1]: a head on a torso
     * @param firstsShare of the output that the first of two modes starts with [1]
     */
    public record Prior(double parameters, double motion, double offset, double apart, double firstsShare) implements Part {

        public Prior {
            positive("prior", parameters, motion, offset, firstsShare);
            above("prior.apart", apart, 1);
        }
    }

    /**
     * When samples tell about a body.
     *
     * @param corner            of the high-pass that takes gravity and bias away [Hz]: far below the motion of a sitter
     * @param excitationMemory  of the input's power [s]
     * @param excited           input over its sensor's noise above which it excites anything, r.m.s. both [1]
     * @param sensitivityMemory of how much the output depends on a parameter [s]
     * @param sensitive         motion of the output by a parameter that grows e-fold, over the sensor's noise, above which the
     *                          parameter is estimated [1]
     * @param inputMemory       of the power that an input sample that is missing may have had [s]
     */
    public record Information(double corner, double excitationMemory, double excited, double sensitivityMemory, double sensitive,
            double inputMemory) implements Part {

        public Information {
            positive("information", corner, excitationMemory, excited, sensitivityMemory, sensitive, inputMemory);
        }
    }

    /**
     * How what a model does not explain is learned, as a share c of the motion.
     *
     * @param trial           time for which a model is taken to explain nothing [s]
     * @param powerMemory     of the output's power [s]
     * @param shortestMemory  of c² when the trial ends [s]
     * @param longestMemory   of c² in the end, and of the innovations' correlation [s]
     * @param growth          of the memory between both in a second [1]
     * @param largestSurprise ν²/S that counts as this at most [1]
     * @param latelyMemory    of the c² that is shown lately [s]: a fall is believed sooner than a rise
     * @param mostAboveLately c² over that of lately, at most [1]
     * @param visible         share of the motion's power, over that of the sensor's noise, from which motion tells about c [1]
     * @param doubt           c² with which a changed body begins [1]
     * @param little          c² above which a body may not be the right one [1]
     * @param mostCorrelation of an innovation with the next that is believed [1]
     * @param mostBelieved    normalised innovation beyond which it counts as this much [1]
     * @param underweight     share of {@code H P Hᵀ} that R is raised by for what the linearisation leaves out [1] (after Zanetti, DeMars
     *                        and Bishop, J. Guidance, Control and Dynamics 2010)
     */
    public record Noise(double trial, double powerMemory, double shortestMemory, double longestMemory, double growth,
            double largestSurprise, double latelyMemory, double mostAboveLately, double visible, double doubt, double little,
            double mostCorrelation, double mostBelieved, double underweight) implements Part {

        public Noise {
            positive("noise", trial, powerMemory, shortestMemory, longestMemory, growth, largestSurprise, latelyMemory, visible, doubt,
                    little, mostBelieved);
            above("noise.mostAboveLately", mostAboveLately, 1);
            share("noise.mostCorrelation", mostCorrelation);
            notNegative("noise.underweight", underweight);
        }
    }

    /**
     * How parameters may move.
     *
     * @param share          of the corrections' second moment that is process noise [1]: all of it would never let the variance shrink
     * @param most           cap of the drift that is learned [1/√s]: 10 % in one second
     * @param shortest       samples over which it is learned, at least [1]
     * @param change         standard deviation that a change adds to the parameters [1, of their logarithms]
     * @param ratio          of a bank's drifts, one over the next, the second being the one that is assumed [1]: of 0.003/√s, 2 % in an
     *                       hour to a change within 0.7 s
     * @param longest        time after which a way of wandering is left [s]
     * @param clear          input over its sensor's noise from which ways of wandering are told apart [1]: noise of the input dilutes
     *                       the response by its share of the power, a ninth here, as a change of the body would
     * @param surpriseMemory of innovations larger than expected, which are taken for noise [s]
     * @param mostSurprise   ν²/S that counts as this at most there [1], since a few large ones are a change
     */
    public record Wandering(double share, double most, long shortest, double change, double ratio, double longest, double clear,
            double surpriseMemory, double mostSurprise) implements Part {

        public Wandering {
            notNegative("wandering.share", share);
            positive("wandering", most, shortest, change, longest, clear, surpriseMemory, mostSurprise);
            above("wandering.ratio", ratio, 1);
        }

        /** Mean of ν²/S that counts as {@link #mostSurprise} at most, where all is as expected [1]; four digits, on which states rest. */
        public double expectedSurprise() {
            double within = Erf.erf(Math.sqrt(mostSurprise / 2));
            double density = Math.exp(-mostSurprise / 2) / Math.sqrt(2 * Math.PI);
            return Math.rint(1e4 * (within - 2 * Math.sqrt(mostSurprise) * density + mostSurprise * (1 - within))) / 1e4;
        }
    }

    /**
     * When innovations are what a filter expects.
     *
     * @param settling        time for which they must be consistent before anything listens [s]
     * @param memory          of ν²/S [s]
     * @param longMemory      of that mean, which it is held to [s]
     * @param leastConsistent mean ν²/S that is consistent, at least, but where it is steady [1]: then the sensor is better than was said
     * @param steady          share by which the mean and the long one may differ [1]
     * @param mostConsistent  mean ν²/S that is consistent, at most [1]
     * @param hopeless        mean ν²/S that no adapting noise could leave [1]
     * @param mostCounted     ν²/S that counts as this at most [1]
     * @param longestUseless  time for which innovations may be as large as the output itself [s]
     */
    public record Watch(double settling, double memory, double longMemory, double leastConsistent, double steady, double mostConsistent,
            double hopeless, double mostCounted, double longestUseless) implements Part {

        public Watch {
            positive("watch", settling, memory, longMemory, leastConsistent, steady, mostConsistent, hopeless, mostCounted,
                    longestUseless);
            above("watch.mostConsistent", mostConsistent, leastConsistent);
            above("watch.mostCounted", mostCounted, hopeless);
        }
    }

    /**
     * When a body has changed.
     *
     * @param larger        variance of a changed body's innovations over those expected [1], in Page's test (Biometrika 1954)
     * @param mostInSum     ν²/S that counts as this at most there [1]: no single shock is a change
     * @param largestSum    log likelihood at which that test rings, for each sample of a second [1]
     * @param step          of ln ω that is listened for [1]
     * @param stepEvidence  log likelihood at which that test rings [1]: once in {@code e^10} samples falsely, at most (Lorden, Annals of
     *                      Mathematical Statistics 1971)
     * @param mostDeviation |ν|/√S that counts as this at most there [1]
     * @param mostAtOnce    log likelihood that a sample says there, at most [1]
     * @param apart         time between false alarms of the evidence of a change, at least [s]: a day
     * @param leastSamples  that must agree before it rings [1]: to count less never rings more
     * @param likelyOdds    at which another's alarm is one about the body [1]
     * @param finding       time in which what is heard is that a body was found, not that it changed [s]: of 180 starts anywhere between
     *                      1 and 15 Hz, 13 were heard to change, the last after 6.6 s
     */
    public record Changes(double larger, double mostInSum, double largestSum, double step, double stepEvidence, double mostDeviation,
            double mostAtOnce, double apart, double leastSamples, double likelyOdds, double finding) implements Part {

        public Changes {
            above("changes.larger", larger, 1);
            positive("changes", mostInSum, largestSum, step, stepEvidence, mostDeviation, mostAtOnce, finding);
            above("changes.apart", apart, 1);
            notNegative("changes.leastSamples - 1", leastSamples - 1);
            above("changes.likelyOdds", likelyOdds, 1);
        }
    }

    /**
     * How far an estimate really scatters.
     *
     * @param batch   over which moves are summed [s]: some tens of a seated body's memories, and longer than postural sway takes, assumed
     * @param batches that are kept apart, whole [1]: as many as make Student's quantile hardly more than the normal one
     */
    public record Scatter(double batch, double batches) implements Part {

        public Scatter {
            positive("scatter", batch, batches);
            notNegative("scatter.batches - 2", batches - 2);
        }
    }

    /**
     * When an estimate begins anew.
     *
     * @param patience                time for which parameters are held after a start, while the motion is found [s]
     * @param patienceAfterDivergence the same after a divergence, doubled by each that follows [s]
     * @param longestPatience         the same at most [s]
     * @param longestGap              of missing input that is bridged [s]
     * @param longestWait             for an output, after which it is foreseen without one [s]
     * @param elsewhere               where to begin once more when the first body that is found explains little [Hz]
     * @param elsewhereAgain          and when the second does [Hz]; the last one found stays
     */
    public record Restart(double patience, double patienceAfterDivergence, double longestPatience, double longestGap,
            double longestWait, double elsewhere, double elsewhereAgain) implements Part {

        public Restart {
            positive("restart", patience, patienceAfterDivergence, longestPatience, longestGap, longestWait, elsewhere, elsewhereAgain);
        }
    }

    /**
     * Of a particle filter.
     *
     * @param discount           of the kernel [1], 1/3 to 1 (Liu and West 2001)
     * @param impossible         -ln of a likelihood that no right particle has [1]
     * @param longestImpossible  time for which the best may have it [s]
     * @param anywhere           share of particles that begin anywhere, so that a wrong start does no harm [1]
     * @param lowest             natural frequency there, at least [Hz]
     * @param highest            and at most [Hz]
     * @param lightest           damping ratio there, at least [1]
     * @param heaviest           and at most [1]
     */
    public record Particles(double discount, double impossible, double longestImpossible, double anywhere, double lowest,
            double highest, double lightest, double heaviest) implements Part {

        public Particles {
            share("particles.discount", discount);
            above("particles.discount", discount, 1.0 / 3);
            share("particles.anywhere", anywhere);
            positive("particles", impossible, longestImpossible, lowest, lightest);
            above("particles.highest", highest, lowest);
            above("particles.heaviest", heaviest, lightest);
        }

        /** a of Liu and West (2001): how far particles shrink towards their mean [1]. */
        public double shrinkage() {
            return (3 * discount - 1) / (2 * discount);
        }
    }

    /**
     * Of several estimators together.
     *
     * @param memory        of evidence [s]
     * @param far           ln of a likelihood that a member lacks to the best when it is behind [1]
     * @param longestBehind time that it may be [s]
     * @param grace         time that a member has to prove itself after it began anew [s]
     * @param seedDeviation that is added where a member begins from the best [1, of the parameters' logarithms]
     * @param lowest        natural frequency where one begins elsewhere, at least [Hz]
     * @param highest       and at most [Hz]
     * @param lightest      damping ratio there, at least [1]
     * @param heaviest      and at most [1]
     * @param heard         part of the members, by their weight, whose alarms are a change [1]
     * @param trust         memory of those weights [s], since a change moves them
     * @param oneChange     time within which alarms are one [s]
     */
    public record Fusion(double memory, double far, double longestBehind, double grace, double seedDeviation, double lowest,
            double highest, double lightest, double heaviest, double heard, double trust, double oneChange) implements Part {

        public Fusion {
            positive("fusion", memory, far, longestBehind, grace, seedDeviation, lowest, lightest, trust, oneChange);
            above("fusion.highest", highest, lowest);
            above("fusion.heaviest", heaviest, lightest);
            share("fusion.heard", heard);
        }
    }

    /**
     * Other motions of the base.
     *
     * @param decay           of the Laguerre functions [1/s]: about that of a seated body's slow modes
     * @param memory          of their coefficients where nothing tells about them [s]
     * @param measuring       time in which powers are measured before anything is learned [s]
     * @param disturbed       time that responses are disturbed by a missing sample [s]
     * @param noiseMemory     of the innovations' power [s]
     * @param largestSurprise share of that power that counts as this at most [1]
     * @param start           deviation of a coefficient at the start, in units of the output per unit of an input [1]
     * @param startOwn        the same of the estimator's own input, which may claim more [1]
     */
    public record Others(double decay, double memory, double measuring, double disturbed, double noiseMemory, double largestSurprise,
            double start, double startOwn) implements Part {

        public Others {
            positive("others", decay, memory, measuring, disturbed, noiseMemory, largestSurprise, start, startOwn);
        }
    }

    /** The same but for one part of it. */
    public Adaptation with(Part part) {
        return new Adaptation(part instanceof Prior other ? other : prior,
                part instanceof Information other ? other : information,
                part instanceof Noise other ? other : noise,
                part instanceof Wandering other ? other : wandering,
                part instanceof Watch other ? other : watch,
                part instanceof Changes other ? other : changes,
                part instanceof Scatter other ? other : scatter,
                part instanceof Restart other ? other : restart,
                part instanceof Particles other ? other : particles,
                part instanceof Fusion other ? other : fusion,
                part instanceof Others other ? other : others);
    }

    private static void positive(String group, double... values) {
        for (double value : values) {
            above(group + "'s numbers", value, 0);
        }
    }

    private static void above(String name, double value, double least) {
        if (!(value > least) || Double.isInfinite(value)) {
            throw new IllegalArgumentException(name + " must be > " + least + ": " + value);
        }
    }

    private static void notNegative(String name, double value) {
        if (!(value >= 0) || Double.isInfinite(value)) {
            throw new IllegalArgumentException(name + " must be >= 0: " + value);
        }
    }

    private static void share(String name, double value) {
        if (!(value >= 0 && value <= 1)) {
            throw new IllegalArgumentException(name + " must be 0 to 1: " + value);
        }
    }
}
