package wbv.study;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import wbv.pole.RemovalCheck;
import wbv.recording.Channel;

/**
 * Whether an absent place's motion can be predicted, as recordings that took no part show: on every one, less than half of the
 * variance is left, and less than by the population's mean body, which needs no pole.
 *
 * @param channel absent
 * @param tried   whether a recording with its sensor was held back
 * @param holds   whether it can
 * @param reason  why it cannot, or is not known; empty if it can
 * @param least   smallest share of the variance that was left, NaN where nothing was tried
 * @param most    largest share
 */
public record RemovalVerdict(String channel, boolean tried, boolean holds, String reason, double least, double most) {

    /** More than half unexplained is no prediction. */
    static final double HALF = 0.5;

    /**
     * The verdict on one channel.
     *
     * @param all checks of all channels
     */
    public static RemovalVerdict of(Channel channel, List<RemovalCheck> all) {
        List<RemovalCheck> own = all.stream().filter(check -> check.channel().equals(channel)).toList();
        if (own.isEmpty()) {
            return new RemovalVerdict(channel.toString(), false, false, "not tried: no recording with its sensor was held back (--check)",
                    Double.NaN, Double.NaN);
        }
        String reason = "";
        for (RemovalCheck check : own) {
            if (reason.isEmpty() && Double.isNaN(check.error())) {
                reason = "on " + check.name() + " it does not move, or was not measured";
            } else if (reason.isEmpty() && !(check.error() < HALF)) {
                reason = String.format(Locale.ROOT, "on %s %.0f %% of its variance is left", check.name(), 100 * check.error());
            } else if (reason.isEmpty() && !(check.error() < check.meanError())) {
                reason = String.format(Locale.ROOT, "on %s the population's mean body, which needs no pole, does as well (%.1f %% of the "
                        + "variance left, %.1f %%)", check.name(), 100 * check.meanError(), 100 * check.error());
            }
        }
        return new RemovalVerdict(channel.toString(), true, reason.isEmpty(), reason,
                own.stream().mapToDouble(RemovalCheck::error).min().orElseThrow(),
                own.stream().mapToDouble(RemovalCheck::error).max().orElseThrow());
    }

    /**
     * In one sentence for each channel.
     *
     * @param recordings held back
     */
    public static String sentence(List<RemovalVerdict> all, int recordings) {
        List<String> said = new ArrayList<>();
        for (RemovalVerdict each : all) {
            if (each.holds()) {
                said.add(String.format(Locale.ROOT, "%s can be predicted without its sensor: %s of its variance is left on %s that took "
                        + "no part", each.channel(), range(each), recordings == 1 ? "a recording" : recordings + " recordings"));
            } else if (!each.tried()) {
                said.add("whether " + each.channel() + " can be predicted without its sensor was " + each.reason());
            } else {
                said.add(each.channel() + " cannot be predicted without its sensor: " + each.reason());
            }
        }
        String text = String.join("; ", said);
        return Character.toUpperCase(text.charAt(0)) + text.substring(1) + ".";
    }

    private static String range(RemovalVerdict each) {
        String most = String.format(Locale.ROOT, "%.1f %%", 100 * each.most());
        String least = String.format(Locale.ROOT, "%.1f", 100 * each.least());
        return most.equals(least + " %") ? most : least + " to " + most;
    }
}
