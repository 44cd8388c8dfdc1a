package wbv.diagnosis;
import java.util.*;
import wbv.body.*;
import wbv.recording.*;
final class Dbg {
    public static void main(String[] a) throws Exception {
        Recording r = RealRun.joined(RealRun.training(List.of("ImperialValleyDBE", "ImperialValleyMCE", "KocaeliDBE", "KocaeliMCE"), "KocaeliMCE"));
        Model m = ModelFile.read(java.nio.file.Path.of("data/models/friction_damper.json"));
        Question q = new Question(m, r, Optional.of(Channel.parse("lugre.force.z")), OptionalDouble.empty());
        Evidence ev = new Evidence(q.asked(), r, OptionalDouble.empty());
        Fitter f = new Fitter(ev);
        Candidate b = Baseline.of(ev);
        Fitter.State s = f.fit(b, b.start(), f.frame(b, b.start(), ev.fit()), 10, 1e-4);
        System.out.println(s.reduced() + " " + Arrays.toString(s.x()));
        Motion mo = new Motion(ev, b.at(s.x()));
        for (Hypothesis h : new RigBank(ev, b.at(s.x()), mo).hypotheses()) {
            if (!h.overturns()) continue;
            System.out.println(h.numbers());
            Candidate w = b.with(h);
            for (Hypothesis.Start st : h.starts()) {
                double[] x = b.extended(b.start(), w, h, st.values());
                Fitter.State t = f.lookWithSlopes(w, x, s.frame());
                System.out.println(Arrays.toString(st.values()) + " x " + Arrays.toString(x) + " look " + t.reduced()+" "+t.cost());
                for (double[] sl : t.slopes()) System.out.print(Fitter.dot(sl, sl) + " ");
                System.out.println();
                t = f.fit(w, x, s.frame(), 10, 1e-3);
                System.out.println("   " + t.reduced() + " " + Arrays.toString(t.x()));
            }
        }
    }
}
