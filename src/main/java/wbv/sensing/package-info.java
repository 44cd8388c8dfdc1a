/**
 * From what a sensor reads to what the body does: orientation and free acceleration, the pose in which a sensor is worn, motion
 * of one point from that of another, the skin under a sensor, angles between segments.
 *
 * <p>Vectors are arrays of 3 in the axes x forward, y left, z up of the frame that is named; a rotation turns vectors of the
 * sensor
 * into those of the world or the body, as the quaternions of a recording do.
 */
package wbv.sensing;
