package wbv.proof;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import wbv.body.Assembly;
import wbv.body.LawAt;
import wbv.body.Model;
import wbv.body.law.Law;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.Diagnosis;
import wbv.recording.Recording;

/**
 * The force that an answer adds to a link.
 *
 * @param where the link
 * @param rate of the series [Hz]
 * @param from first moment of the held-out stretch, from the first row [s]
 * @param to its last
 * @param newtons by row of the recording, positive in tension
 * @param terms of which it is the sum; none where the answer does not say
 */
record LawForce(String where, double rate, double from, double to, List<Double> newtons, List<ComparedTerm> terms) {

    LawForce {
        newtons = List.copyOf(newtons);
        terms = List.copyOf(terms);
    }

    /**
     * What all laws together do that the answer's model has in the first named link, and the question's own has not, when it is simulated
     * on the whole recording. Empty where no link is named or the run leaves all bounds.
     */
    static Optional<LawForce> of(Diagnosis diagnosis, Model own, Recording recording) {
        List<String> links = diagnosis.model().links().stream().map(Model.Link::name).toList();
        Optional<String> where = diagnosis.missing().stream().map(Diagnosis.Named::where).filter(links::contains).findFirst();
        return where.flatMap(name -> of(diagnosis, own, recording, links.indexOf(name)));
    }

    private static Optional<LawForce> of(Diagnosis diagnosis, Model own, Recording recording, int place) {
        Assembly assembly = diagnosis.model().assembly();
        String name = diagnosis.model().links().get(place).name();
        // Values were fitted since, so a law that was there before is known by its kind.
        List<Class<?>> before = new ArrayList<>();
        own.links().stream().filter(link -> link.name().equals(name)).flatMap(link -> link.laws().stream()).map(Law::getClass)
                .forEach(before::add);
        Excitation excitation = Excitation.of(diagnosis.model(), recording, recording.length());
        Simulator.Response response = new Simulator(excitation).run(assembly, false);
        double[] sum = new double[excitation.samples()];
        boolean any = false;
        for (int i = 0; i < assembly.laws().size() && !response.diverged(); i++) {
            LawAt at = assembly.laws().get(i);
            if (at.link() == place && !before.remove(at.law().getClass())) {
                double[] force = excitation.series(response.forces()[i]);
                Arrays.setAll(sum, s -> sum[s] + force[s]);
                any = true;
            }
        }
        double[] heldOut = diagnosis.fit().heldOut();
        return any && heldOut.length == 2 ? Optional.of(new LawForce(name, recording.clock().rate(), heldOut[0], heldOut[1],
                Arrays.stream(sum).mapToObj(MarkdownCells::rounded).toList(),
                LearnedTerms.among(diagnosis.model().links().get(place).laws(),
                        diagnosis.model().links().stream().map(Model.Link::name).toList())))
                : Optional.empty();
    }
}
