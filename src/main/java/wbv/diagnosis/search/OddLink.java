package wbv.diagnosis.search;

import java.util.Optional;
import wbv.body.law.MaxwellArm;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.fit.Normal;
import wbv.diagnosis.fit.Slot;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * A link whose stiffness or damping had to move far before the model fitted, where all other links' moved little. Either that number
 * was wrong, or something acts there that a spring and a damper nearly imitate over the band that was shaken: a memory makes a link
 * stiffer and more damped at once.
 *
 * <p>The model's own numbers tell. How far off they are is read from the other links, s in ln k and ln c; held to that, the link
 * pays {@code (ln k/k₀)²/s²}, and a mechanism that fits with the number as it was given pays nothing. The difference is twice the
 * logarithm of the odds, as in the hierarchical model where all numbers share one scale of error (Lindley and Smith, 1972). Not asked of a
 * model that stands for a simulation: its numbers were not given by anybody, and one that hardly matters may be identified as anything.
 *
 * @param link  index of the link
 * @param scale s
 * @param moved ln k/k₀ of the link
 */
record OddLink(int link, double scale, double moved) {

    private static final double LEAST_SCALE = 0.1;
    /** How many standard deviations make a number odd, and how far off it must be at least, in ln. */
    private static final double ODD = 4;
    private static final double LEAST_MOVE = 0.4;
    private static final int OTHERS = 2;
    /** How much of the move may be left. */
    private static final double CAME_BACK = 0.5;
    private static final int STEPS_AGAIN = 12;

    /**
     * The oddest link of a fit; empty where no number of the model is odd, or too few are there to compare with.
     *
     * @param base with its derivatives
     */
    static Optional<OddLink> in(Fitter.State base) {
        double[][] curvature = new Normal(base).curvature();
        int links = base.candidate().template().structure().links();   // with those of hidden masses, which have no given numbers
        Optional<OddLink> oddest = Optional.empty();
        double most = ODD;
        for (int link = 0; link < links; link++) {
            double sum = 0;
            int others = 0;
            int own = -1;
            for (int i = 0; i < base.candidate().given(); i++) {
                Slot slot = base.candidate().knobs().get(i).slot();
                if (base.candidate().knobs().get(i).isOfLink() && slot.at() != link) {
                    sum += base.x()[i] * base.x()[i];
                    others++;
                } else if (slot.kind() == Slot.Kind.STIFFNESS) {
                    own = i;
                }
            }
            if (own < 0 || others < OTHERS) {
                continue;
            }
            double scale = Math.max(LEAST_SCALE, Math.sqrt(sum / others));
            double moved = base.x()[own];
            double oddness = Math.abs(moved) / Math.sqrt(scale * scale + OwnNumbers.variance(curvature, own));
            if (oddness > most && Math.abs(moved) > LEAST_MOVE) {
                most = oddness;
                oddest = Optional.of(new OddLink(link, scale, moved));
            }
        }
        return oddest;
    }

    /** Whether a fit spares the link most of its move, and asks for no other as far. */
    boolean cameBack(Fitter.State fit) {
        double now = fit.x()[fit.candidate().stiffness(link).orElseThrow()];
        return now * Math.signum(moved) < CAME_BACK * Math.abs(moved) && Math.abs(now) < Math.abs(moved);
    }

    /** The same fit once more, from the link's numbers as they were given and held to what the others show. */
    Fitter.State held(Fitter fitter, Fitter.State fit) {
        return fitter.fit(held(fit.candidate()), asGiven(fit.candidate(), fit.x()), fit.frame(), STEPS_AGAIN, 1e-3);
    }

    private Candidate held(Candidate candidate) {
        return new Candidate(candidate.template(), candidate.knobs().stream().map(this::held).toList(), candidate.added(),
                candidate.freeWays());
    }

    private double[] asGiven(Candidate candidate, double[] x) {
        double[] out = x.clone();
        for (int i = 0; i < x.length; i++) {
            Knob knob = candidate.knobs().get(i);
            out[i] = knob.isOfLink() && knob.slot().at() == link ? 0 : x[i];
        }
        return out;
    }

    /** Whether a hypothesis is what an odd stiffness of this link makes up for most often. */
    boolean isMemory(Hypothesis hypothesis) {
        return hypothesis.additions().get(0) instanceof Addition.InLink in && in.link() == link
                && in.law() instanceof MaxwellArm;
    }

    private Knob held(Knob knob) {
        return knob.isOfLink() && Double.isFinite(knob.deviation())
                ? new Knob(knob.name(), knob.slot(), knob.reference(), knob.unit(), knob.low(), knob.high(), scale) : knob;
    }
}
