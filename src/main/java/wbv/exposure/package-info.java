/**
 * What vibration does to the one who sits in it, by ISO 2631-1:1997, ISO 8041-1:2017, ISO 2631-5:2018 and Directive 2002/44/EC:
 * frequency weightings, running means, doses, daily exposure, verdicts.
 *
 * <p>The standards were not at hand; their formulas and numbers come through instrument manuals and public implementations that
 * agree, and are tested against the values that those print. Accelerations are in m/s², daily durations in minutes, measured
 * durations in seconds. Exposure is judged by axis, the highest decides; a vector sum is for comfort only.
 */
package wbv.exposure;
