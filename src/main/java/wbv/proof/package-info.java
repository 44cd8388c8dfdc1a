/**
 * The proof: effects are concealed in simulated recordings, diagnosed by a process that knows only recording and model, and only
 * then are the keys opened and the answers marked.
 *
 * <p>{@link wbv.proof.Suite} says what is asked, {@link wbv.proof.Proof} runs it, {@link wbv.proof.Vault} keeps the keys,
 * {@link wbv.proof.Marking} marks one answer, {@link wbv.proof.Tables} writes what came of it.
 */
package wbv.proof;
