package wbv.report.page;

import java.util.List;
import java.util.Locale;
import wbv.result.Digits;

/**
 * States as circles on a ring and transitions as arrows between them, drawn as SVG without a script. Arrays are not copied.
 *
 * @param names   of the states
 * @param chances probabilities by state, from (row) and to (column)
 * @param shares of time by state, the size of circles
 * @param least   probability: transitions less likely than this are left out
 */
public record StateGraph(String title, List<String> names, double[][] chances, double[] shares, double least) implements Block {

    private static final double SIZE = 640;
    private static final double RING = 235;

    public StateGraph {
        names = List.copyOf(names);
        if (names.size() != chances.length || names.size() != shares.length) {
            throw new IllegalArgumentException("a graph needs a row and a share for each of " + names.size() + " states: "
                    + chances.length + ", " + shares.length);
        }
    }

    /** The drawing. Names are escaped by {@code escape}. */
    String svg(java.util.function.UnaryOperator<String> escape) {
        StringBuilder svg = new StringBuilder(String.format(Locale.ROOT,
                "<svg class=\"graph\" viewBox=\"0 0 %.0f %.0f\" role=\"img\" aria-label=\"%s\">%n", SIZE, SIZE,
                escape.apply(title)));
        int n = names.size();
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                if (i != j && chances[i][j] >= least) {
                    arrow(svg, i, j);
                }
            }
        }
        for (int i = 0; i < n; i++) {
            svg.append(String.format(Locale.ROOT, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\"/>", x(i), y(i), radius(i)))
                    .append(String.format(Locale.ROOT, "<text x=\"%.1f\" y=\"%.1f\" class=\"stay\">%s</text>", x(i), y(i) + 5,
                            percent(chances[i][i])));
            double out = radius(i) + 14;
            double sin = Math.sin(angle(i));
            svg.append(String.format(Locale.ROOT, "<text x=\"%.1f\" y=\"%.1f\">%s</text>%n", x(i)
                    + 0.4 * out * Math.cos(angle(i)),
                    y(i) + (sin > 0 ? out + 6 : -out), escape.apply(names.get(i))));
        }
        return svg.append("</svg>\n").toString();
    }

    /** A bent arrow, so that there and back do not lie on each other, with its chance at its middle. */
    private void arrow(StringBuilder svg, int i, int j) {
        double dx = x(j) - x(i);
        double dy = y(j) - y(i);
        double length = Math.hypot(dx, dy);
        double bend = 0.14;
        double mx = (x(i) + x(j)) / 2 - bend * dy;
        double my = (y(i) + y(j)) / 2 + bend * dx;
        double width = 1 + 5 * Math.sqrt(chances[i][j]);
        double[] from = toward(i, mx, my, radius(i) + 1);
        double[] to = toward(j, mx, my, radius(j) + 3 + 2 * width);
        double ax = to[0] - mx;
        double ay = to[1] - my;
        double a = Math.hypot(ax, ay);
        ax /= a;
        ay /= a;
        double head = 3 + 1.6 * width;
        svg.append(String.format(Locale.ROOT, "<path d=\"M%.1f %.1fQ%.1f %.1f %.1f %.1f\" stroke-width=\"%.1f\"/>", from[0],
                from[1], mx, my,
                to[0], to[1], width));
        svg.append(String.format(Locale.ROOT, "<polygon points=\"%.1f,%.1f %.1f,%.1f %.1f,%.1f\"/>", to[0] + head * ax, to[1]
                + head * ay,
                to[0] - 0.6 * head * ay, to[1] + 0.6 * head * ax, to[0] + 0.6 * head * ay, to[1] - 0.6 * head * ax));
        if (length > 0) {
            double t = 0.36;
            double px = (1 - t) * (1 - t) * from[0] + 2 * t * (1 - t) * mx + t * t * to[0];
            double py = (1 - t) * (1 - t) * from[1] + 2 * t * (1 - t) * my + t * t * to[1];
            svg.append(String.format(Locale.ROOT, "<text x=\"%.1f\" y=\"%.1f\" class=\"chance\">%s</text>%n", px, py + 4,
                    percent(chances[i][j])));
        }
    }

    private double[] toward(int node, double px, double py, double distance) {
        double dx = px - x(node);
        double dy = py - y(node);
        double length = Math.max(1e-9, Math.hypot(dx, dy));
        return new double[] {x(node) + distance * dx / length, y(node) + distance * dy / length};
    }

    private static String percent(double chance) {
        return Digits.rounded(100 * chance, chance < 0.1 || chance > 0.995 ? 1 : 0);
    }

    private double angle(int i) {
        return 2 * Math.PI * i / names.size() - Math.PI / 2;
    }

    private double x(int i) {
        return SIZE / 2 + RING * Math.cos(angle(i));
    }

    private double y(int i) {
        return SIZE / 2 + RING * Math.sin(angle(i));
    }

    private double radius(int i) {
        return 20 + 18 * Math.sqrt(shares[i]);
    }
}
