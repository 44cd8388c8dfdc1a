package wbv.body.law;

import java.util.Locale;
import wbv.body.number.Check;
import wbv.body.number.Key;
import wbv.body.number.Shape;
import wbv.body.number.Units;

/**
 * A term of a law that was learned and comes and goes, as with breath: (cosine cos 2πft + sine sin 2πft) · shape.
 *
 * @param shape what it goes by
 * @param cosine [N per the shape's unit]
 * @param sine likewise
 * @param frequency f [Hz], &gt; 0
 */
public record LearnedWave(@Key("shape") Shape shape, @Key("cosine_N") double cosine, @Key("sine_N") double sine,
        @Key("frequency_hz") double frequency)
        implements Learned {

    public LearnedWave {
        Check.finite("cosine part", Units.newtonsPer(shape.unit()), cosine);
        Check.finite("sine part", Units.newtonsPer(shape.unit()), sine);
        Check.positive("frequency", "Hz", frequency);
    }

    @Override
    public double coefficient() {
        return Math.hypot(cosine, sine);
    }

    @Override
    public String unit() {
        return Units.newtonsPer(shape.unit());
    }

    @Override
    public String kind() {
        return shape + " × wave";
    }

    @Override
    public String formula() {
        return shape + String.format(Locale.ROOT, " × cos(2π · %.4g Hz · t %s %.3g)", frequency, sine > 0 ? "−" : "+",
                Math.abs(Math.atan2(sine, cosine)));
    }

    @Override
    public boolean byTheClock() {
        return true;
    }

    @Override
    public double force(LinkMotion m) {
        double phase = 2 * Math.PI * frequency * m.time;
        return (cosine * Math.cos(phase) + sine * Math.sin(phase)) * shape.of(m.displacement, m.velocity);
    }
}
