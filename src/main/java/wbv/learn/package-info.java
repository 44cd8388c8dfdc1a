/**
 * The estimators as MOA learners and detectors: thin shells whose options become one record of the core.
 */
package wbv.learn;
