/**
 * The forces that are concealed: the generator's own forms of every law, each a {@link wbv.rig.concealed.law.LinkPhysics} with a state of
 * its own. They share nothing with the laws of the library, so that a diagnosis has to know the kind and not the formula.
 */
package wbv.rig.concealed.law;
