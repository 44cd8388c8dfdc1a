package wbv.filter;

import wbv.filter.model.BodyModel;
import wbv.filter.model.Spec;

/**
 * The extended Kalman filter and nothing more: every parameter is estimated from every output, wanders as was said, and every
 * innovation is believed with the variance that was said.
 */
final class TextbookFilter extends JointFilter {

    private static final long serialVersionUID = 1;

    /**
     * @param model       with slopes; set by this filter
     * @param offsetDecay what is left of the sensors' offset after one sample
     */
    TextbookFilter(Spec spec, BodyModel model, double offsetDecay) {
        super(spec, model, Linearised.of(model, offsetDecay), offsetDecay);
    }

    @Override
    boolean estimates(int parameter) {
        return true;
    }

    @Override
    double wandering(int parameter) {
        return resting;
    }

    @Override
    double believed(double s) {
        return Double.POSITIVE_INFINITY;
    }

    @Override
    double weighed(double variance, double predicted) {
        return variance;
    }
}
