package wbv.diagnosis;

import java.util.Map;

/**
 * What is believed before a recording is seen, as numbers with units and sources. Whatever else a verdict depends on is in the data.
 *
 * @param noPhysics    probability that nothing is missing but numbers [1]: half, so that silence and speech start equal
 * @param freePlace    probability of a force of no known law at a place, over that of a family of the library [1]
 * @param further      what every further part costs beside its own probability [1]
 * @param values       error of given stiffness and damping, one standard deviation of the logarithm, the middle of its own prior [1]: segment
 *                     models from the literature differ among persons of one stature by about so much (Boileau and Rakheja 1998)
 * @param valuesSpread factor by which that error may well be larger or smaller [1]
 * @param amplitude    how strong an effect may well be, in the units that the library gives it, of which one is about a tenth of what its link
 *                     carries [1]
 * @param own          force that a sitter makes on the trunk, root mean square, the middle of its prior [N]: what sitting still took of a driver's
 *                     trunk, as measured on an unshaken seat
 * @param ownSpread    factor by which it may well be larger or smaller [1]
 * @param ownShape     factor by which a band of it may well be stronger or weaker than its usual spectrum has it [1]
 * @param ownCorner    frequency below which most of it lies [Hz]: voluntary motion of the trunk
 * @param trunk        mass from which on a body is of the trunk, over the heaviest body's [1]
 * @param form         part of its own force by which a law's formula may be wrong [1]; one that is more wrong is another law
 * @param formInTime   the same where the formula is a course in time [1]
 * @param freeLeast    least free force in a band that is summed over, root mean square [N]: one that no sensor shows even on a head
 * @param freeMost     greatest [N]: a sitter's weight and more
 * @param errorLeast   the same as an error at a sensor [m/s²]
 * @param errorMost    greatest [m/s²]
 * @param left         free force beside a law, over the law's own, up to which the law's name is kept [1]
 * @param held         probability from which on one name is the answer, and that the names of a set hold together [1]
 */
record Priors(double noPhysics, double freePlace, double further, double values, double valuesSpread, double amplitude, double own, double ownSpread,
              double ownShape, double ownCorner, double trunk, double form, double formInTime, double freeLeast, double freeMost,
              double errorLeast, double errorMost, double left, double held) {

    /** Sources in the description of each. */
    static final Priors USUAL = new Priors(0.5, 0.1, 0.1, 0.1, 2.5, 10, 1.5, 2, 2, 3, 0.3, 0.15, 0.2, 1e-3, 1000, 1e-5, 10, 0.2, 0.9);

    Priors {
        Map<String, Double> shares = Map.of("noPhysics", noPhysics, "freePlace", freePlace, "further", further, "trunk", trunk, "form", form,
                "formInTime", formInTime, "left", left, "held", held);
        shares.forEach((name, value) -> check(name, value > 0 && value < 1, value, "between 0 and 1"));
        Map<String, Double> sizes = Map.of("values", values, "amplitude", amplitude, "own", own, "ownCorner", ownCorner,
                "freeLeast", freeLeast, "errorLeast", errorLeast);
        sizes.forEach((name, value) -> check(name, value > 0 && Double.isFinite(value), value, "> 0"));
        check("valuesSpread", valuesSpread > 1, valuesSpread, "> 1");
        check("ownSpread", ownSpread > 1, ownSpread, "> 1");
        check("ownShape", ownShape > 1, ownShape, "> 1");
        check("freeMost", freeMost > freeLeast, freeMost, "> freeLeast");
        check("errorMost", errorMost > errorLeast, errorMost, "> errorLeast");
        check("held", held > 0.5, held, "> 0.5");
    }

    private static void check(String name, boolean right, double value, String wanted) {
        if (!right) {
            throw new IllegalArgumentException(name + " must be " + wanted + ": " + value);
        }
    }
}
