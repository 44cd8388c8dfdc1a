package wbv.filter;

import wbv.filter.drift.ChangeTest;
import wbv.filter.drift.EvidenceTest;
import wbv.filter.model.Spec;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Tests on a {@link Bank}, which follows changes by itself, so that its innovations do not tell of them: what is heard are those
 * of its witness, which stays as it was.
 */
final class Witness implements ChangeTests {

    private static final long serialVersionUID = 1;

    private final double rate;
    private final double finding;
    private final Bank bank;
    private final EvidenceTest evidence;
    private double since;

    /** @param spec rate and adaptation */
    Witness(Spec spec, Bank bank) {
        this.rate = spec.rate();
        this.finding = spec.adaptation().changes().finding();
        this.bank = bank;
        this.evidence = new EvidenceTest(rate, spec.adaptation().changes());
    }

    @Override
    public void restart() {
        since = 0;
        forget();
    }

    @Override
    public void forget() {
        evidence.restart();
    }

    @Override
    public boolean listenEarly() {
        return true;
    }

    @Override
    public double nis(double own) {
        return bank.witnessNis();
    }

    /** A body of another kind is followed better than not, whether it changes or not. */
    @Override
    public ChangeTest hear(double nis, double normalised, double slope, OutputNoise noise) {
        since += 1 / rate;
        if (!evidence.hear(noise.explainsLittle() ? 0 : bank.gain())) {
            return ChangeTest.NONE;
        }
        if (since < finding) {
            bank.doubt();
            forget();
            return ChangeTest.NONE;
        }
        return ChangeTest.EVIDENCE;
    }

    /** Otherwise what disturbs it has. */
    @Override
    public boolean isOfTheBody(boolean rose) {
        return rose && evidence.likely();
    }

    @Override
    public boolean deafAfterChange() {
        return false;
    }

    @Override
    public void save(StateWriter out) {
        out.put(since);
        out.put(evidence);
    }

    @Override
    public void load(StateReader in) {
        since = in.number();
        in.part(evidence);
    }
}
