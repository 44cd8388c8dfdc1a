package wbv.rig.concealed;

import java.util.function.DoubleFunction;

/**
 * An omission of any size.
 *
 * @param least
 * @param most sizes between which it is physics
 * @param of the omission of a size; larger does more
 */
record OmissionRecipe(double least, double most, DoubleFunction<Omission> of) {}
