package wbv.rig.concealed;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.Locale;

/** The force of a concealed law through the whole recording, as a sensor in its place would send it. */
final class ConcealedForce {

    static final String HEAD = "time_s,force_N,extension_m,rate_m_per_s\n";

    private ConcealedForce() {}

    /**
     * By row: in a link, all that it carries less stiffness · extension and damping · rate of its linear part, positive in tension; on a
     * body, what a mass that nobody sees pulls it up by. Extension and rate are those of the link, or of that below the body.
     */
    static String of(Omission omission, Chain chain, ChainPlant.Trace trace, Imus imus) {
        int body = chain.body(omission.where());
        int link = body;
        for (int i = 0; i < chain.size(); i++) {
            link = chain.link(i).equals(omission.where()) ? i : link;
        }
        double[] r = trace.extension()[link];
        double[] v = trace.rate()[link];
        double[] f = trace.force()[body < 0 ? link : chain.size()].clone();
        for (int s = 0; body < 0 && s < f.length; s++) {
            f[s] -= chain.stiffness()[link] * r[s] + chain.damping()[link] * v[s];
        }
        double[] force = imus.thinned(f);
        double[] extension = imus.thinned(r);
        double[] rate = imus.thinned(v);
        StringBuilder out = new StringBuilder(HEAD);
        for (int i = 0; i < force.length; i++) {
            out.append(String.format(Locale.ROOT, "%.6f,%.6g,%.6g,%.6g\n", i / Imus.RATE, force[i], extension[i], rate[i]));
        }
        return out.toString();
    }

    /** SHA-256 in lower-case hex, by which a key holds its force. */
    static String digest(String text) {
        try {
            return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(text.getBytes(StandardCharsets.UTF_8)));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }
}
