package wbv.proof;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import wbv.body.law.Law;
import wbv.body.law.Learned;
import wbv.body.law.LearnedCourse;
import wbv.body.law.LearnedInertance;
import wbv.body.law.LearnedKnee;
import wbv.body.law.LearnedLimited;
import wbv.body.law.LearnedMemory;
import wbv.body.law.LearnedTerm;
import wbv.body.law.LearnedWave;
import wbv.body.number.Modulator;
import wbv.body.number.Shape;

/** Terms of a law that was learned, in the words of the keys. */
final class LearnedTerms {

    private LearnedTerms() {}

    /** @param links names of the model's links, in its order */
    static List<ComparedTerm> of(List<Learned> law, List<String> links) {
        List<ComparedTerm> out = new ArrayList<>();
        for (Learned term : law) {
            Set<ComparedTerm.Factor> factors = new HashSet<>();
            modulator(term.modulator(), links, factors);
            boolean lagged = false;
            if (term instanceof LearnedTerm plain) {
                shape(plain.shape(), factors);
            } else if (term instanceof LearnedLimited limited) {
                shape(limited.shape(), factors);
            } else if (term instanceof LearnedKnee knee) {
                factors.add(new ComparedTerm.Factor(variable(knee.of()), "", switch (knee.side()) {
                    case BOTH -> "magnitude beyond a knee, with sign";
                    case EXTENSION -> "positive part beyond a knee";
                    case COMPRESSION -> "negative part beyond a knee";
                }));
            } else if (term instanceof LearnedMemory memory) {
                shape(memory.of(), factors);
                shape(memory.shape(), factors);
                lagged = true;
            } else if (term instanceof Learned.Thinning thinning) {
                long power = Math.round(thinning.thinning());
                factors.add(new ComparedTerm.Factor("speed", "", "over one plus its " + (power == 2 ? "square" : "power")));
            } else if (term instanceof LearnedInertance) {
                factors.add(new ComparedTerm.Factor("acceleration", "", "itself"));
            } else if (term instanceof LearnedWave wave) {
                shape(wave.shape(), factors);
                factors.add(new ComparedTerm.Factor("time", "", "sine"));
            } else if (term instanceof LearnedCourse course) {
                shape(course.shape(), factors);
                factors.add(new ComparedTerm.Factor("time", "", course.course().name().toLowerCase(Locale.ROOT)));
            }
            out.add(new ComparedTerm(factors, lagged));
        }
        return out;
    }

    /**
     * The terms among some laws.
     *
     * @param laws of a link
     */
    static List<ComparedTerm> among(List<Law> laws, List<String> links) {
        return of(laws.stream().filter(Learned.class::isInstance).map(Learned.class::cast).toList(), links);
    }

    private static String variable(Shape shape) {
        return shape.equals(Shape.SPEED) ? "speed" : "deflection";
    }

    private static void shape(Shape shape, Set<ComparedTerm.Factor> factors) {
        if (shape.deflection() != Shape.Part.ONE) {
            factors.add(new ComparedTerm.Factor("deflection", "", words(shape.deflection())));
        }
        if (shape.speed() != Shape.Part.ONE) {
            factors.add(new ComparedTerm.Factor("speed", "", words(shape.speed())));
        }
    }

    private static String words(Shape.Part part) {
        return switch (part) {
            case ONE -> "1";
            case PLAIN -> "itself";
            case MAGNITUDE -> "magnitude";
            case SQUARE -> "square";
            case SIGNED_SQUARE -> "square with sign";
            case CUBE -> "cube";
            case SIGN -> "sign";
            case POSITIVE -> "positive part";
            case NEGATIVE -> "negative part";
            case POSITIVE_SQUARE -> "square of the positive part";
            case NEGATIVE_SQUARE -> "square of the negative part";
        };
    }

    private static void modulator(Modulator modulator, List<String> links, Set<ComparedTerm.Factor> factors) {
        if (modulator instanceof Modulator.PartOf part) {
            Set<ComparedTerm.Factor> whole = new HashSet<>();
            modulator(part.whole(), links, whole);
            String as = part.part() == Modulator.Part.MAGNITUDE ? "magnitude" : part.part().name().toLowerCase(Locale.ROOT) + " part";
            whole.forEach(factor -> factors.add(new ComparedTerm.Factor(factor.of(), factor.at(), as)));
        } else if (modulator instanceof Modulator.OtherLink other) {
            factors.add(new ComparedTerm.Factor(other.of().name().toLowerCase(Locale.ROOT), links.get(other.link()), "itself"));
        } else if (modulator instanceof Modulator.Angle angle) {
            factors.add(new ComparedTerm.Factor("tilt", angle.rate().toString(), "itself"));
        } else if (modulator instanceof Modulator.Measured measured) {
            factors.add(new ComparedTerm.Factor("channel", measured.channel().toString(), "itself"));
        } else if (modulator instanceof Modulator.Lean lean) {
            factors.add(new ComparedTerm.Factor("lean", lean.upper().toString(), "itself"));
        } else if (modulator instanceof Modulator.Ride) {
            factors.add(new ComparedTerm.Factor("ride", "", "level"));
        }
    }
}
