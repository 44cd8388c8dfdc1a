package wbv.signal;

/**
 * An orthonormal wavelet by its low-pass filter (Daubechies, Ten Lectures on Wavelets, 1992, chapters 6 and 8).
 *
 * <p>Longer filters part neighbouring bands more sharply, shorter ones tell moments more sharply.
 */
public enum Wavelet {
    /** Two taps: differences and sums of neighbours. */
    HAAR(1 / Math.sqrt(2), 1 / Math.sqrt(2)),
    /** Daubechies' eight taps, four vanishing moments ("db4"). */
    DAUBECHIES_8(-0.010597401785069032, 0.0328830116668852, 0.030841381835560764, -0.18703481171909309, -0.027983769416859854,
            0.6308807679298589, 0.7148465705529157, 0.2303778133088965),
    /** Sixteen taps, eight vanishing moments, nearly symmetric ("sym8"). */
    SYMLET_16(-0.0033824159510061256, -0.0005421323317911481, 0.03169508781149298, 0.007607487324917605, -0.1432942383508097,
            -0.061273359067658524, 0.4813596512583722, 0.7771857517005235, 0.3644418948353314, -0.05194583810770904,
            -0.027219029917056003, 0.049137179673607506, 0.003808752013890615, -0.01495225833704823, -0.0003029205147213668,
            0.0018899503327594609);

    private final double[] low;
    private final double[] high;

    Wavelet(double... low) {
        this.low = low;
        this.high = new double[low.length];
        for (int n = 0; n < low.length; n++) {
            high[n] = (n % 2 == 0 ? -1 : 1) * low[low.length - 1 - n];   // its mirror at a quarter of the rate
        }
    }

    int taps() {
        return low.length;
    }

    double low(int n) {
        return low[n];
    }

    double high(int n) {
        return high[n];
    }
}
