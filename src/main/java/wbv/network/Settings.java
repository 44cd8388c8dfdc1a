package wbv.network;

/**
 * How a network is trained.
 *
 * <p>Table 8-1 of the thesis gives "Dropout Frequency 20". Dropout has no frequency; it reads like a learning rate that drops
 * every
 * 20 epochs, or like a dropout of 20 %. Both are settings; the other defaults are assumed.
 *
 * @param epochs     times that every image is shown
 * @param batch      images at a step
 * @param method     how steps are taken
 * @param rate       learning rate [1]
 * @param dropPeriod epochs after which the rate drops, again and again
 * @param dropFactor by which it is then multiplied
 * @param dropout    share of units left out at each step, 0 to less than 1
 * @param seed       of everything random in training
 */
public record Settings(int epochs, int batch, Method method, double rate, int dropPeriod, double dropFactor, double dropout,
        long seed) {

    /** How steps are taken. */
    public enum Method {
        /** Stochastic gradient descent with momentum 0.9. */
        MOMENTUM,
        /** Kingma and Ba 2015, with their moments 0.9 and 0.999. */
        ADAM
    }

    public Settings {
        if (epochs < 1 || batch < 2 || dropPeriod < 1) {
            throw new IllegalArgumentException("epochs and the drop period must be >= 1, a batch >= 2: " + epochs + ", "
                    + dropPeriod + ", " + batch);
        }
        if (!(rate > 0 && rate <= 1) || !(dropFactor > 0 && dropFactor <= 1) || !(dropout >= 0 && dropout < 1)) {
            throw new IllegalArgumentException("rate and its factor must be > 0 to 1, dropout 0 to less than 1: " + rate + ", "
                    + dropFactor + ", " + dropout);
        }
    }

    /** The learning rate in an epoch, counted from 0. */
    double rate(int epoch) {
        return rate * Math.pow(dropFactor, epoch / dropPeriod);
    }

    /** The same with other epochs, &gt;= 1. */
    public Settings withEpochs(int number) {
        return new Settings(number, batch, method, rate, dropPeriod, dropFactor, dropout, seed);
    }

    /** The same with other random numbers. */
    public Settings withSeed(long other) {
        return new Settings(epochs, batch, method, rate, dropPeriod, dropFactor, dropout, other);
    }
}
