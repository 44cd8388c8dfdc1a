package wbv.rig.concealed;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.apache.commons.math3.random.RandomGenerator;
import wbv.rig.platform.Seeds;

/**
 * Everything about a recording that is there without any omission: the sitter, the platform's motion, the motion across.
 *
 * @param fore  by place, along x
 * @param side by place, along y
 * @param calm  how the linear chain moves
 * @param blind places without a sensor
 */
record RideScene(Setting setting, Chain chain, Shaking shaking, Map<String, Sway> fore, Map<String, Sway> side, ChainPlant.Trace calm,
        List<String> blind) {

    static final List<String> PLACES = List.of("platform", "seat", "pelvis", "sternum", "head");

    static RideScene of(Setting setting, Seeds seeds) {
        return of(setting, OptionalDouble.empty(), seeds);
    }

    /** @param seconds how long it lasts, where that is not as usual */
    static RideScene of(Setting setting, OptionalDouble seconds, Seeds seeds) {
        RandomGenerator random = seeds.source("sitter");
        Topology[] all = Topology.values();
        Chain chain = all[random.nextInt(all.length)].draw(random);
        double level = (chain.size() == 4 ? 0.7 : 1) * (0.8 + 0.3 * random.nextDouble());
        return of(setting, chain, level, seconds, random, seeds);
    }

    /**
     * A sitter on a ride of some level; 1 is the usual one.
     *
     * @param random the rest of what made the sitter
     */
    private static RideScene of(Setting setting, Chain chain, double level, OptionalDouble seconds, RandomGenerator random, Seeds seeds) {
        Shaking shaking = Shaking.of(setting, level, seconds, seeds.of("shaking"));
        Map<String, Sway> fore = new LinkedHashMap<>();
        Map<String, Sway> side = new LinkedHashMap<>();
        for (String place : PLACES) {
            int body = chain.rider(place);
            // A sensor moves with the body it rides on, whatever its place is called.
            String of = body < 0 ? Chain.PLATFORM : chain.place(body);
            fore.put(place, Sway.of(of, shaking.x(), shaking.pitch()));
            side.put(place, Sway.of(of, shaking.y(), UniformSeries.scaled(shaking.roll(), -1)));
        }
        List<String> blind = setting == Setting.FIELD && random.nextBoolean() ? List.of("sternum") : List.of();
        return new RideScene(setting, chain, shaking, fore, side, trace(new Setup(chain), shaking, ChainPlant.COARSE), blind);
    }

    /** The same sitter on another ride of so many seconds, at a level over the usual one. */
    RideScene ride(double level, double seconds, Seeds seeds) {
        return of(setting, chain, level, OptionalDouble.of(seconds), seeds.source("sitter"), seeds);
    }

    /** The same sitter on a platform that moves along z by another acceleration [m/s²]. */
    RideScene shaken(double[] z) {
        Shaking other = new Shaking(shaking.x(), shaking.y(), z, shaking.roll(), shaking.pitch(), shaking.yaw());
        return new RideScene(setting, chain, other, fore, side, trace(new Setup(chain), other, ChainPlant.COARSE), blind);
    }

    /** The same sitter where nothing shakes the platform along z or turns it. */
    RideScene still() {
        double[] none = new double[shaking.length()];
        return new RideScene(setting, chain, new Shaking(shaking.x(), shaking.y(), none, none, none, none), fore, side, calm, blind);
    }

    private static ChainPlant.Trace trace(Setup setup, Shaking shaking, int substeps) {
        return new ChainPlant(setup, UniformSeries.RATE, substeps).run(shaking.z(), UniformSeries.RATE);
    }

    /** How a setup moves, as far as sizes matter. */
    ChainPlant.Trace sketch(Setup setup) {
        return setup.isLinear() ? calm : trace(setup, shaking, ChainPlant.COARSE);
    }

    /** How a setup moves. */
    ChainPlant.Trace play(Setup setup) {
        return trace(setup, shaking, ChainPlant.FINE);
    }

    /** Places whose vertical the user's model predicts. */
    List<String> outputs() {
        return PLACES.stream().filter(place -> {
            int body = chain.rider(place);
            return body >= 0 && chain.place(body).equals(place) && !blind.contains(place);
        }).toList();
    }
}
