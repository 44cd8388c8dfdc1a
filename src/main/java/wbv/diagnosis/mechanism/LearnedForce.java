package wbv.diagnosis.mechanism;

import wbv.body.Learned;

/** A force in a link that no other mechanism makes: its law is learned term by term, and only where nothing here explains what is missing. */
public record LearnedForce() implements Mechanism {

    @Override
    public Entry entry() {
        return new Entry(Learned.MECHANISM, Family.UNLISTED, "The link %s has a law that is in no library");
    }
}
