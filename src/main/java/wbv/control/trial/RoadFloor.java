package wbv.control.trial;

import wbv.result.Digits;

/**
 * A cab's floor on a road of ISO 8608: displacement spectrum {@code G(n) = G₀ (n/n₀)⁻²} at n₀ = 0.1 1/m, the classes' geometric means G₀ =
 * 16 · 4^k 10⁻⁶ m³ from A on; through a cab that stands on 1.8 Hz with damping ratio 0.35 and hears nothing above 12 Hz, which is assumed.
 *
 * @param roughness {@code A} to {@code E}
 * @param speed [km/h], &gt; 0 to 200
 */
public record RoadFloor(char roughness, double speed) implements Floor {

    private static final double REFERENCE = 0.1;
    private static final double CAB = 1.8;
    private static final double CAB_DAMPING = 0.35;
    private static final double TYRES = 12;

    public RoadFloor {
        if (roughness < 'A' || roughness > 'E') {
            throw new IllegalArgumentException("class of a road must be A to E: " + roughness);
        }
        if (!(speed > 0 && speed <= 200)) {
            throw new IllegalArgumentException("speed must be > 0 to 200 km/h: " + speed);
        }
    }

    @Override
    public String word() {
        return "road:" + roughness + ":" + Digits.significant(speed, 4);
    }

    @Override
    public String description() {
        return "road of class " + roughness + " of ISO 8608 at " + Digits.significant(speed, 4) + " km/h under an assumed cab";
    }

    @Override
    public double density(double frequency) {
        double v = speed / 3.6;
        double displacement = 16e-6 * Math.pow(4, roughness - 'A') * Math.pow(frequency / v / REFERENCE, -2) / v;
        double r = frequency / CAB;
        double damper = 2 * CAB_DAMPING * r;
        double cab = (1 + damper * damper) / ((1 - r * r) * (1 - r * r) + damper * damper);
        double tyres = 1 / (1 + Math.pow(frequency / TYRES, 4));
        return Math.pow(2 * Math.PI * frequency, 4) * displacement * cab * tyres;
    }
}
