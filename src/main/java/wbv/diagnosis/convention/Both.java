package wbv.diagnosis.convention;

import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import wbv.body.Model;
import wbv.recording.Channel;
import wbv.recording.Recording;

/** Two at once that have to do with different things, in whichever order they are read. */
public record Both(Convention one, Convention other) implements Convention {
    public Both {
        if (!one.goesWith(other)) {
            throw new IllegalArgumentException("each has to do with something else: " + one + " and " + other);
        }
    }

    @Override
    public Recording read(Recording recording) {
        return other.read(one.read(recording));
    }

    @Override
    public Model read(Model model) {
        return other.read(one.read(model));
    }

    @Override
    public Set<Channel> touched() {
        return Stream.concat(one.touched().stream(), other.touched().stream()).collect(Collectors.toUnmodifiableSet());
    }

    @Override
    public Channel source(Channel channel) {
        return one.source(other.source(channel));
    }

    @Override
    public boolean ofNumbers() {
        return one.ofNumbers() || other.ofNumbers();
    }

    @Override
    public String amiss() {
        return one.amiss() + " and " + other.amiss();
    }

    @Override
    public String done() {
        return "both were read as they are meant";
    }

    @Override
    public String remedy() {
        return one.remedy() + ", and " + other.remedy();
    }
}
