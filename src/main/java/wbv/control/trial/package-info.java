/**
 * Controlled seats tried: a person of the virtual rig, on a suspension with friction, stops, a leveller, a damper or an actuator that
 * is late, on a floor that shakes as machines do, with sensors that err and fail.
 *
 * <p>The plant ({@link wbv.control.trial.SuspendedPerson}) is not the controllers' model: seven bodies that soften stand against one
 * mass on a spring. A {@link wbv.control.trial.SeatTrial} is one ride; a {@link wbv.control.trial.Front} holds rides of one controller at
 * several prices of stroke, so that controllers are compared at equal stroke, which alone is honest; a
 * {@link wbv.control.trial.Comparison} holds fronts of many controllers, floors and sitters.
 */
package wbv.control.trial;
