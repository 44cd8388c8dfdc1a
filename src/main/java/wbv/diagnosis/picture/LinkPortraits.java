package wbv.diagnosis.picture;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import wbv.body.law.Law;
import wbv.body.law.ScheduledFriction;
import wbv.body.law.ScheduledLink;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.learn.LatentForce;
import wbv.diagnosis.learn.LawShape;
import wbv.diagnosis.learn.LawShape.Side;
import wbv.diagnosis.learn.LinkScale;

/** The latent force in a link over deflection, velocity, frequency or time, whichever shows the law. */
final class LinkPortraits {

    private static final double[][] NO_CURVE = new double[3][0];
    /** Part of the force's range by which a law must change in the band for that to be drawn. */
    private static final double VISIBLE = 0.04;

    private final Evidence evidence;
    private final LatentForce latent;
    private final String where;
    private final double stiffness;
    private final double damping;
    private final double rate;
    private final double[] r;
    private final double[] v;
    private final double[] force;
    private final Clouds clouds;
    private final LinkScale scale;
    private final Portrait.Scale beside;

    LinkPortraits(Evidence evidence, LatentForce latent, String where, int link) {
        this.evidence = evidence;
        this.scale = LinkScale.of(evidence, link);
        this.beside = Portrait.Scale.of(scale.effort() + " beside the linear link", scale.force());
        this.latent = latent;
        this.where = where;
        this.stiffness = latent.bare().structure().stiffness()[link];
        this.damping = latent.bare().structure().damping()[link];
        this.rate = evidence.recording().clock().rate();
        this.r = latent.displacement();
        this.v = latent.velocity();
        this.force = latent.force();
        this.clouds = new Clouds(evidence, latent::known);
    }

    /** Portraits of a law that was found. */
    List<Portrait> of(Law law) {
        if (law.isLinear()) {
            return new DynamicStiffness(evidence, latent, where, scale).portraits();
        }
        if (law instanceof ScheduledLink link) {   // over motion it is another curve at each level
            return schedule(new LinkSchedule(evidence, latent, where, link.by(), scale).of(link, stiffness, damping));
        }
        if (law instanceof ScheduledFriction friction) {
            return schedule(new LinkSchedule(evidence, latent, where, friction.by(), scale).of(friction));
        }
        LawShape shape = new LawShape(law, stiffness, damping, known(r), known(v), evidence.recording().clock(),
                (int) (evidence.recording().elapsed(evidence.recording().length() - 1) * rate) + 1);
        if (shape.dependsOnTime()) {
            return new LinkHistory(latent, where, stiffness, damping, evidence.recording(), scale).portraits(shape.overTime());
        }
        if (shape.dependsOnly(Side.DEFLECTION)) {
            double[][] curve = shape.curve(Side.DEFLECTION);
            return List.of(over(Side.DEFLECTION, force, 0, curve),
                    over(Side.DEFLECTION, whole(Side.DEFLECTION, force), stiffness, curve),
                    over(Side.VELOCITY, force, 0, NO_CURVE));
        }
        if (shape.dependsOnly(Side.VELOCITY)) {
            double[][] curve = shape.curve(Side.VELOCITY);
            return List.of(over(Side.VELOCITY, force, 0, curve), over(Side.VELOCITY, whole(Side.VELOCITY, force), damping, curve),
                    over(Side.DEFLECTION, force, 0, NO_CURVE));
        }
        return List.of(loop(Side.DEFLECTION), loop(Side.VELOCITY));
    }

    private List<Portrait> schedule(Portrait overChannel) {
        return List.of(overChannel, over(Side.DEFLECTION, force, 0, NO_CURVE), over(Side.VELOCITY, force, 0, NO_CURVE));
    }

    /** Portraits of a force that no law carries. */
    List<Portrait> unnamed() {
        List<Portrait> out = new ArrayList<>(List.of(over(Side.DEFLECTION, force, 0, NO_CURVE),
                over(Side.VELOCITY, force, 0, NO_CURVE)));
        out.addAll(new LinkHistory(latent, where, stiffness, damping, evidence.recording(), scale).portraits(NO_CURVE));
        return out;
    }

    /** A law that was learned, beside the force that the recording asks for with no law assumed. */
    List<Portrait> learned() {
        double[] law = latent.lawInBand();
        List<Portrait> out = new ArrayList<>();
        out.add(new Portrait(scale.effort() + " in " + where + " over time", Portrait.Scale.of("Time", "s"), beside,
                Clouds.histories(evidence, force, "law found", law), "Held-out part, through the sensors' band."));
        List<Portrait.Trail> trails = new ArrayList<>(clouds.samples(law, 1, force, 1));
        double end = Arrays.stream(known(law)).map(Math::abs).max().orElse(1);
        trails.add(new Portrait.Trail("if the law were all", Portrait.Kind.REFERENCE, new double[] {-end, end}, new double[] {-end, end},
                new double[0]));
        out.add(new Portrait(scale.effort() + " in " + where + " over that of the law",
                Portrait.Scale.of(scale.effort() + " of the law found", scale.force()),
                Portrait.Scale.of(scale.effort() + " that the recording asks for", scale.force()), trails,
                "Above 1 Hz. On the straight line nothing is left."));
        for (Side side : Side.values()) {
            List<Portrait.Trail> along = new ArrayList<>(clouds.samples(along(side), scale.turn(), force, 1));
            along.add(clouds.mean("law found, mean", Portrait.Kind.LAW, along(side), scale.turn(), law, 1));
            out.add(new Portrait(scale.effort() + " in " + where + (side == Side.DEFLECTION ? " over deflection" : " over velocity"),
                    along(side, scale), beside, along,
                    "A law that goes by more than this shows as a cloud about its mean."));
        }
        return out;
    }

    private double[] known(double[] x) {
        return IntStream.range(0, x.length).filter(latent::known).mapToDouble(i -> x[i]).toArray();
    }

    private static Portrait.Scale along(Side side, LinkScale scale) {
        return side == Side.DEFLECTION ? Portrait.Scale.of("Deflection", scale.deflection())
                : Portrait.Scale.of("Velocity", scale.velocity());
    }

    private double[] along(Side side) {
        return side == Side.DEFLECTION ? r : v;
    }

    private double[] whole(Side side, double[] beside) {
        double slope = side == Side.DEFLECTION ? stiffness : damping;
        return IntStream.range(0, beside.length).mapToDouble(i -> beside[i] + slope * along(side)[i]).toArray();
    }

    /** @param slope of the straight part that y holds beside the latent force; 0 if it holds none */
    private Portrait over(Side side, double[] y, double slope, double[][] curve) {
        double[] x = along(side);
        List<Portrait.Trail> trails = new ArrayList<>(clouds.samples(x, scale.turn(), y, 1));
        if (curve[0].length > 0) {
            double[] law = IntStream.range(0, curve[0].length).mapToDouble(i -> curve[1][i] + slope * curve[0][i]).toArray();
            trails.add(Portrait.Trail.law("law found", scaled(curve[0]), law));
            double range = Arrays.stream(law).max().orElse(0) - Arrays.stream(law).min().orElse(0);
            double[] inBand = latent.lawInBand();
            Portrait.Trail seen = clouds.mean("the same through the sensors' band", Portrait.Kind.LAW_IN_BAND, x, scale.turn(),
                    slope == 0 ? inBand : whole(side, inBand), 1);
            if (IntStream.range(0, seen.x().length).anyMatch(i -> Math.abs(seen.y()[i]
                    - at(scaled(curve[0]), law, seen.x()[i])) > VISIBLE * range)) {
                trails.add(seen);
            }
            if (slope != 0) {
                trails.add(linear(curve[0], law, slope));
            }
        }
        boolean deflection = side == Side.DEFLECTION;
        String what = slope == 0 ? "Latent " + scale.effort().toLowerCase(Locale.ROOT) : deflection ? "Whole spring" : "Whole damper";
        return new Portrait(what + " in " + where + " over " + (deflection ? "deflection" : "velocity"),
                along(side, scale),
                slope == 0 ? beside
                        : Portrait.Scale.of((deflection ? "Spring " : "Damper ") + scale.effort().toLowerCase(Locale.ROOT), scale.force()),
                trails, note());
    }

    /** The straight part, as far as it stays near the forces that were there. */
    private Portrait.Trail linear(double[] x, double[] law, double slope) {
        double most = 1.5 * Arrays.stream(law).map(Math::abs).max().orElse(0);
        double low = Math.max(x[0], -most / slope);
        double high = Math.min(x[x.length - 1], most / slope);
        return new Portrait.Trail("linear part alone", Portrait.Kind.REFERENCE, new double[] {low * scale.turn(), high * scale.turn()},
                new double[] {slope * low, slope * high}, new double[0]);
    }

    /** The curve's value at x, by straight lines. */
    private static double at(double[] xs, double[] ys, double x) {
        int i = Arrays.binarySearch(xs, x);
        int upper = Math.max(1, Math.min(xs.length - 1, i >= 0 ? i : -i - 1));
        double share = (x - xs[upper - 1]) / (xs[upper] - xs[upper - 1]);
        return ys[upper - 1] + share * (ys[upper] - ys[upper - 1]);
    }

    private String note() {
        return String.format(Locale.ROOT, "One point a sample%s; the sensors' noise alone scatters it by ±%.2g %s.",
                latent.lowest() > 0 ? String.format(Locale.ROOT, ", from %.0f Hz up", latent.lowest()) : "", 2
                        * latent.pointNoise(),
                scale.force());
    }

    /** The strongest second as a loop, measured and as the law has it. */
    private Portrait loop(Side side) {
        int fine = latent.refinement();
        double[] x = side == Side.DEFLECTION ? latent.fineDisplacement() : latent.fineVelocity();
        int from = strongest() * fine;
        int to = from + (int) Math.round(rate) * fine;
        List<Portrait.Trail> trails = new ArrayList<>(clouds.samples(along(side), scale.turn(), force, 1).subList(0, 2));
        double[] shown = scaled(Arrays.copyOfRange(x, from, to));
        trails.add(new Portrait.Trail("strongest second", Portrait.Kind.MEASURED, shown,
                Arrays.copyOfRange(latent.fineForce(), from, to), new double[0]));
        trails.add(Portrait.Trail.law("the same as the law has it", shown, Arrays.copyOfRange(latent.fineLaw(), from, to)));
        return new Portrait(
                "Latent " + scale.effort().toLowerCase(Locale.ROOT) + " in " + where + " over "
                        + (side == Side.DEFLECTION ? "deflection" : "velocity"),
                along(side, scale), beside, trails, note());
    }

    /** First sample of the second with the most deflection. */
    private int strongest() {
        int length = (int) Math.round(rate);
        int best = 0;
        double most = 0;
        for (int from = 0; from + length < r.length; from += length / 2) {
            if (latent.known(from) && latent.known(from + length) && Motion.rms(Arrays.copyOfRange(r, from, from + length),
                    length) > most) {
                most = Motion.rms(Arrays.copyOfRange(r, from, from + length), length);
                best = from;
            }
        }
        return best;
    }

    private double[] scaled(double[] x) {
        return Arrays.stream(x).map(value -> scale.turn() * value).toArray();
    }
}
