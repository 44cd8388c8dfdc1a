package wbv.diagnosis.picture;

import java.util.ArrayList;
import java.util.List;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.law.Law;
import wbv.body.law.Learned;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.learn.LatentEstimator;
import wbv.diagnosis.learn.LatentForce;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * Chooses the picture in which a mechanism shows: force over deflection, stiffness over time, a line in a spectrum, and so on.
 */
final class Portraits {

    private final Evidence evidence;
    private final Fitter.State base;
    private final Fitter.State chosen;

    Portraits(Evidence evidence, Fitter.State base, Fitter.State chosen) {
        this.evidence = evidence;
        this.base = base;
        this.chosen = chosen;
    }

    /** Portraits of everything that was added, or else of the best place for what nothing explains. */
    List<Portrait> all(List<Diagnosis.Latent> latent) {
        List<Portrait> out = new ArrayList<>();
        List<Hypothesis> added = chosen.candidate().added();
        List<Hypothesis> found = added.subList(base.candidate().added().size(), added.size());
        found.stream().filter(hypothesis -> hypothesis.mechanism().equals(Learned.MECHANISM)).findFirst()
                .ifPresent(term -> out.addAll(learned(term)));
        for (Hypothesis hypothesis : out.isEmpty() ? found : List.<Hypothesis>of()) {
            hypothesis.additions().stream().limit(1).forEach(addition -> out.addAll(of(hypothesis, addition)));
        }
        if (out.isEmpty() && !latent.isEmpty()) {
            out.addAll(of(latent.get(0)));
        }
        return out;
    }

    private List<Portrait> of(Hypothesis hypothesis, Addition addition) {
        if (addition instanceof Addition.InLink in) {
            return new LinkPortraits(evidence, latent(false, in.link()), hypothesis.where(), in.link()).of(found(in.link()));
        }
        if (addition instanceof Addition.Driven driven) {
            if (driven.drive() instanceof Drive.Tone) {
                return new BodyPortraits(evidence, latent(true, driven.place()), hypothesis.where()).force(true);
            }
            Drive drive = chosen.candidate().at(chosen.x()).drives().stream()
                    .filter(at -> at.place() == driven.place() && at.drive().getClass() == driven.drive().getClass()).findFirst()
                    .orElseThrow().drive();
            return driven(drive, driven.place(), hypothesis.where());
        }
        if (addition instanceof Addition.AtSensor at) {
            return new SensorPortraits(evidence, base, chosen, at.output()).of(at.fault());
        }
        return List
                .of(new BodyPortraits(evidence, latent(true, ((Addition.Hidden) addition).body()), hypothesis.where()).mass());
    }

    /** What drives a place; a force whose sensor errs has no motion that it goes by, and is drawn as any other on a body. */
    private List<Portrait> driven(Drive drive, int place, String where) {
        if (drive instanceof Drive.Across across) {
            return List.of(new DrivePortraits(evidence, latent(drive.actsOnBody(), place), where).over(across));
        }
        boolean byMotion = drive instanceof Drive.Rotation || drive instanceof Drive.Swings || drive instanceof Drive.CrossAxis;
        return byMotion ? List.of(new DrivePortraits(evidence, latent(false, place), where).over(drive, place))
                : new BodyPortraits(evidence, latent(true, place), where).force(true);
    }

    /**
     * A law that was learned over the force that the recording asks for: in time, by deflection and speed, and one over the other.
     *
     * @param term one of it
     */
    private List<Portrait> learned(Hypothesis term) {
        int link = ((Addition.InLink) term.additions().get(0)).link();
        LatentForce latent = latent(false, link);
        return new LinkPortraits(evidence, latent, term.where(), link).learned();
    }

    private List<Portrait> of(Diagnosis.Latent place) {
        for (int l = 0; l < evidence.model().links().size(); l++) {
            if (place.kind().equals("link") && evidence.model().links().get(l).name().equals(place.where())) {
                return new LinkPortraits(evidence, latent(false, l), place.where(), l).unnamed();
            }
        }
        for (int b = 0; b < evidence.model().bodies().size(); b++) {
            if (place.kind().equals("body") && evidence.model().bodies().get(b).name().equals(place.where())) {
                return new BodyPortraits(evidence, latent(true, b), place.where()).force(false);
            }
        }
        for (int o = 0; o < evidence.outputs().size(); o++) {
            String name = new Place(place.kind().equals("device") ? Place.Kind.DEVICE : Place.Kind.SENSOR, o).name(evidence);
            if ((place.kind().equals("sensor") || place.kind().equals("device")) && name.equals(place.where())) {
                return new SensorPortraits(evidence, base, chosen, o).unnamed();
            }
        }
        return List.of();
    }

    private LatentForce latent(boolean onBody, int place) {
        return new LatentEstimator(evidence, base.candidate(), chosen, onBody, place).force();
    }

    /** The law that was added in a link, with the numbers found. */
    private Law found(int link) {
        Assembly full = chosen.candidate().at(chosen.x());
        return full.laws().subList(base.candidate().template().laws().size(), full.laws().size()).stream()
                .filter(at -> at.link() == link)
                .findFirst().orElseThrow().law();
    }
}
