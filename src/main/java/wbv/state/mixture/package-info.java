/**
 * Mixtures of Gaussians and how many there are: by message length ({@link wbv.state.mixture.MessageLength}, Figueiredo and Jain 2002) or as
 * a Dirichlet process ({@link wbv.state.mixture.DirichletProcess}, Blei and Jordan 2006). Knows nothing of motion.
 */
package wbv.state.mixture;
