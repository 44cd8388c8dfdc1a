/**
 * What was recorded, as a model sees it, before any fit: {@link wbv.diagnosis.measured.Measured} is the input and what each output read,
 * with the samples of it that count ({@link wbv.diagnosis.measured.Dropouts}) and how noisy its sensors are
 * ({@link wbv.diagnosis.measured.NoiseLevel}); {@link wbv.diagnosis.measured.SmallError} is what is known of any sensor beforehand.
 */
package wbv.diagnosis.measured;
