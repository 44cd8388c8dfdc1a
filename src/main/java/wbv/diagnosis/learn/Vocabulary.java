package wbv.diagnosis.learn;

import java.util.List;
import wbv.body.number.Modulator;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.LearnedForce;

/**
 * What the choice of a term costs: a formula that takes more words to say is the less likely before data are seen (Solomonoff 1964). A law
 * goes by its own link alone or by something else too, either as likely, and any word of a kind is as likely as another.
 *
 * @param named     mechanisms of the library, at least 1
 * @param plain     terms that go by their own link alone, at least 1
 * @param modulated terms that something else multiplies
 */
record Vocabulary(int named, int plain, int modulated) {

    Vocabulary {
        if (named < 1 || plain < 1 || modulated < 0) {
            throw new IllegalArgumentException("a vocabulary has names and plain terms: " + named + ", " + plain + ", " + modulated);
        }
    }

    /** Of all terms that there are beside a library of some size. */
    static Vocabulary of(int named, List<Hypothesis> terms) {
        int plain = (int) terms.stream().filter(Vocabulary::isPlain).count();
        return new Vocabulary(named, Math.max(1, plain), terms.size() - plain);
    }

    /** Logarithm of how many it was chosen among, some likelier than others [nat]. */
    double price(Hypothesis term) {
        if (!(term.kind() instanceof LearnedForce)) {
            return Math.log(named);
        }
        return modulated == 0 ? Math.log(plain) : Math.log(2.0 * (isPlain(term) ? plain : modulated));
    }

    /** The same of all of them [nat]. */
    double price(List<Hypothesis> terms) {
        return terms.stream().mapToDouble(this::price).sum();
    }

    private static boolean isPlain(Hypothesis term) {
        return Grammar.modulator(term) instanceof Modulator.None;
    }
}
