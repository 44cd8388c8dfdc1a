package wbv.diagnosis.picture;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import wbv.diagnosis.learn.LatentForce;
import wbv.diagnosis.learn.LinkScale;
import wbv.recording.Recording;

/** Stiffness and damping of a link by blocks of time: least squares of everything that it carries on deflection and velocity. */
final class LinkHistory {

    /** Length of a block [s], and how many a shorter record has at least (assumed). */
    private static final double BLOCK = 4;
    private static final int FEWEST = 10;
    /** Neighbouring samples of a band-limited signal are not independent: about two thirds of them are. */
    static final double INDEPENDENT = 0.67;

    private final LatentForce latent;
    private final String where;
    private final double stiffness;
    private final double damping;
    private final Recording recording;
    private final double rate;
    private final LinkScale scale;

    LinkHistory(LatentForce latent, String where, double stiffness, double damping, Recording recording, LinkScale scale) {
        this.scale = scale;
        this.latent = latent;
        this.where = where;
        this.stiffness = stiffness;
        this.damping = damping;
        this.recording = recording;
        this.rate = recording.clock().rate();
    }

    /** @param law time, stiffness and damping that were found; empty where none were */
    List<Portrait> portraits(double[][] law) {
        double[] r = latent.displacement();
        double[] v = latent.velocity();
        double[] force = latent.force();
        int length = Math.max(1, Math.min(r.length / FEWEST, (int) Math.round(BLOCK * rate)));
        int blocks = r.length / length;
        double[] time = new double[blocks];
        double[][] value = new double[2][blocks];
        double[][] deviation = new double[2][blocks];
        for (int b = 0; b < blocks; b++) {
            time[b] = recording.elapsed(Math.round((b + 0.5) * length));
            double[] fitted = fitted(r, v, force, b * length, length);
            value[0][b] = scale.stiff() * (stiffness + fitted[0]);
            value[1][b] = damping + fitted[1];
            deviation[0][b] = scale.stiff() * fitted[2];
            deviation[1][b] = fitted[3];
        }
        String blocksOf = String.format(Locale.ROOT, "by blocks of %.2g s", length / rate);
        return List.of(portrait("Stiffness", scale.stiffness(), blocksOf, time, value[0], deviation[0], law[0],
                Arrays.stream(law[1]).map(k -> scale.stiff() * k).toArray()),
                portrait("Damping", scale.damping(), blocksOf, time, value[1], deviation[1], law[0], law[2]));
    }

    /** What a block has beside stiffness and damping, and the standard errors of both; NaN where too little of it is known. */
    private double[] fitted(double[] r, double[] v, double[] force, int from, int length) {
        double rr = 0;
        double rv = 0;
        double vv = 0;
        double fr = 0;
        double fv = 0;
        double ff = 0;
        int count = 0;
        for (int i = from; i < from + length; i++) {
            if (latent.known(i)) {
                rr += r[i] * r[i];
                rv += r[i] * v[i];
                vv += v[i] * v[i];
                fr += force[i] * r[i];
                fv += force[i] * v[i];
                ff += force[i] * force[i];
                count++;
            }
        }
        if (count <= length / 2) {
            return new double[] {Double.NaN, Double.NaN, Double.NaN, Double.NaN};
        }
        double det = rr * vv - rv * rv;
        double k = (fr * vv - fv * rv) / det;
        double c = (fv * rr - fr * rv) / det;
        double scatter = Math.max(0, ff - k * fr - c * fv) / Math.max(1, INDEPENDENT * count - 2);
        return new double[] {k, c, Math.sqrt(scatter * vv / det), Math.sqrt(scatter * rr / det)};
    }

    private Portrait portrait(String what, String unit, String blocks, double[] time, double[] value, double[] deviation, double[] lawTime,
            double[] law) {
        List<Portrait.Trail> trails = new ArrayList<>();
        trails.add(new Portrait.Trail(blocks, Portrait.Kind.MEAN, time, value, deviation));
        if (law.length > 0) {
            trails.add(Portrait.Trail.law("law found", lawTime, law));
        }
        return new Portrait(what + " of " + where + " over time", Portrait.Scale.of("Time", "s"), Portrait.Scale.of(what, unit),
                trails,
                "From what the link must carry for model and recording to agree, with nothing assumed of when it changes.");
    }
}
