package wbv.diagnosis.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.LawAt;
import wbv.body.Spectra;
import wbv.body.Structure;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;

/** A fitted model with what was added to the user's at one place taken out of it, and the force that this had. */
public final class Remainder {

    private final Excitation excitation;
    private final Assembly user;
    private final Assembly full;
    private final boolean onBody;
    private final int place;
    private final Simulator.Response response;

    /**
     * Runs the fitted model once.
     *
     * @param user the model that nothing was added to
     * @param place index of a body, or of a link
     */
    public Remainder(Excitation excitation, Assembly user, Assembly full, boolean onBody, int place) {
        this.excitation = excitation;
        this.user = user;
        this.full = full;
        this.onBody = onBody;
        this.place = place;
        this.response = new Simulator(excitation).run(full, false);
    }

    /** Relative displacement of a link in the full model [m], a spectrum. */
    public double[] stretch(int link) {
        return response.stretch()[link];
    }

    /** The model with everything in it. */
    public Assembly full() {
        return full;
    }

    /** The linear part of the model without what was added at the place. */
    public Assembly bare() {
        List<LawAt> laws = full.laws().stream().filter(at -> at.law().isLinear() && !own(at)).toList();
        List<Assembly.DriveAt> drives = new ArrayList<>();
        for (int i = 0; i < full.drives().size(); i++) {
            Assembly.DriveAt at = full.drives().get(i);
            boolean own = i >= user.drives().size() && at.place() == place && at.drive().actsOnBody() == onBody;
            if (!own) {
                drives.add(at);
            }
        }
        Structure s = full.structure();
        double[] values = s.values();
        for (int l = user.structure().links(); l < s.links(); l++) {
            if (onBody && s.from()[l] == place) {
                values[l] = 1e-3;   // what swung there floats, and no longer pulls
                values[s.links() + l] = 1e-3;
            }
        }
        return new Assembly(s.with(values), laws, drives, full.outputs());
    }

    /**
     * Outputs of a linear model with the forces that the laws elsewhere had, spectra by output in its unit.
     *
     * @param model such as {@link #bare}
     */
    public double[][] outputs(Assembly model) {
        Simulator simulator = new Simulator(excitation);
        double[][] out = simulator.run(model, false).outputs();
        if (full.structure().held()) {
            return out;   // links that are driven do not move each other
        }
        Simulator.Linearised linear = simulator.linearised(model);
        for (int i = 0; i < full.laws().size(); i++) {
            LawAt at = full.laws().get(i);
            double[][] answer = at.law().isLinear() || own(at) ? new double[0][] : linear.answerTo(at.link(), response.forces()[i]);
            for (int o = 0; o < answer.length; o++) {
                Spectra.add(out[o], answer[o], 1);
            }
        }
        return out;
    }

    /** What a force of 1 N, or a moment of 1 N m, at the place does to the outputs of a linear model, spectra by output in its unit. */
    public double[][] answer(Assembly model) {
        Simulator.Linearised linear = new Simulator(excitation).linearised(model);
        return onBody ? linear.ofBodyForce(place) : linear.ofLinkForce(place);
    }

    /** The force of what was added at the place [N] or [N m], a spectrum, as the fit has it. */
    public double[] force() {
        double[] out = new double[2 * excitation.omega().length];
        for (int i = 0; i < full.laws().size(); i++) {
            if (own(full.laws().get(i))) {
                Spectra.add(out, response.forces()[i], 1);
            }
        }
        Structure s = full.structure();
        for (int l = user.structure().links(); l < s.links(); l++) {
            if (onBody && s.from()[l] == place) {
                double[] stretch = response.stretch()[l];
                Spectra.add(out, stretch, s.stiffness()[l]);
                Spectra.add(out, Spectra.timesJOmega(excitation.omega(), stretch), s.damping()[l]);
            }
        }
        for (int i = user.drives().size(); i < full.drives().size(); i++) {
            if (onBody && full.drives().get(i).place() == place && full.drives().get(i).drive() instanceof Drive.Tone tone) {
                Spectra.add(out, excitation.spectrum(series(tone)), 1);
            }
        }
        return out;
    }

    private boolean own(LawAt at) {
        return !onBody && at.link() == place && full.laws().indexOf(at) >= user.laws().size();
    }

    private double[] series(Drive.Tone tone) {
        return IntStream.range(0, excitation.samples()).mapToDouble(i -> 2 * Math.PI * tone.frequency() * i / excitation.rate())
                .map(phase -> tone.cosine() * Math.cos(phase) + tone.sine() * Math.sin(phase)).toArray();
    }
}
