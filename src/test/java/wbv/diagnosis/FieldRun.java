package wbv.diagnosis;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Random;
import wbv.body.Excitation;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.body.Simulator;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.recording.RecordingFile;

final class FieldRun {

    public static void main(String[] args) throws Exception {
        double level = Double.parseDouble(args[0]);
        for (int a = 1; a < args.length; a++) {
            String name = args[a];
            Path folder = Path.of("../shared/practice", name);
            Model model = ModelFile.read(folder.resolve("model.json"));
            Recording recording = new RecordingFile(folder.resolve("recording.csv.gz")).load();
            Random random = new Random(Integer.parseInt(name));
            int n = recording.length();
            double[] force = new double[n];
            double s = 0;
            double p = 0;
            for (int i = 0; i < n; i++) {
                s = 0.85 * s + random.nextGaussian();   // corner about 1.5 Hz
                force[i] = s;
                p += s * s;
            }
            Excitation e = Excitation.of(model, recording, n);
            double[] f = e.spectrum(force);
            double[][] d = new Simulator(e).linearised(model.assembly()).ofBodyForce(model.index("torso"));
            Map<Channel, double[]> values = new LinkedHashMap<>();
            for (Channel c : recording.channels()) values.put(c, recording.values(c).clone());
            for (int o = 0; o < d.length; o++) {
                double[] x = new double[f.length];
                for (int k = 0; k < f.length; k += 2) {
                    x[k] = d[o][k] * f[k] - d[o][k + 1] * f[k + 1];
                    x[k + 1] = d[o][k] * f[k + 1] + d[o][k + 1] * f[k];
                }
                double[] series = e.series(x);
                double[] y = values.get(model.outputs().get(o));
                double gain = 1 + 0.007 * random.nextGaussian();
                double r = 0;
                for (int i = 0; i < n; i++) {
                    y[i] = gain * (y[i] + level * series[i] / Math.sqrt(p / n));
                    r += Math.pow(level * series[i] / Math.sqrt(p / n), 2);
                }
                System.out.printf("%s body noise %.4f m/s2%n", model.outputs().get(o), Math.sqrt(r / n));
            }
            Recording noisy = new Recording(recording.clock(), values, recording.metadata());
            long t1 = System.nanoTime();
            Diagnosis dg = Diagnoser.diagnose(model, noisy, (q, w) -> { });
            System.out.printf("%s %.1f s %s: %s%n", name, (System.nanoTime() - t1) / 1e9, dg.verdict().word(), dg.sentence());
            System.out.printf("    given %.2f before %.2f after %.2f held %.2f %.2f%n", dg.fit().given(), dg.fit().before(), dg.fit().after(), dg.fit().heldBefore(), dg.fit().heldAfter());
            for (Diagnosis.Named q : dg.missing()) System.out.println("    missing " + q);
            for (Diagnosis.Named q : dg.alternatives().subList(0, Math.min(3, dg.alternatives().size()))) System.out.println("    or " + q);
            for (Diagnosis.Latent q : dg.latent()) System.out.println("    latent " + q);
        }
    }
}
