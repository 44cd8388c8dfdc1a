/**
 * Recordings in which an effect is concealed: a vertical chain of lumped bodies on the platform, of which the model handed out
 * beside the recording leaves something out. What was left out stands in a key, and nowhere else.
 *
 * <p>The generator is the opposite side of {@link wbv.rig} from whatever will look for the effect: it has its own integrator
 * (Runge-Kutta of fourth order at 8640 Hz, {@link wbv.rig.concealed.ChainPlant}) and its own forms of every law (tanh and
 * rational softening, LuGre friction, Jenkins sliders, Hertz stops, ramps, pairs of Maxwell arms, filtered muscle), and every
 * recording carries the ordinary scatter of real ones: gains, clocks, tilts, lever arms, noise, and a sitter who does not sit
 * still. {@link wbv.rig.concealed.Concealer} makes one case from a {@link wbv.rig.concealed.ConcealedSpec}.
 */
package wbv.rig.concealed;
