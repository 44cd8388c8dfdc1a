package wbv.study;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.IntSummaryStatistics;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.identify.ArmaxFit;
import wbv.identify.EquivalentBody;
import wbv.identify.ExcitedBand;
import wbv.identify.OrderSelection;
import wbv.identify.Orders;
import wbv.identify.PredictionError;
import wbv.identify.RefinedInstruments;
import wbv.identify.Samples;
import wbv.identify.Slower;
import wbv.identify.TransferFit;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.signal.GapBridge;
import wbv.signal.Upsampler;

/**
 * Linear models identified from a recording, as {@code wbv identify} gives them: ARMAX by prediction error, of the orders that
 * Schwarz's criterion chooses, and a model in continuous time by refined instruments; each with its modes.
 *
 * @param rate_hz of the recording [Hz]
 * @param from_s  beginning of the longest stretch without a gap [s]
 * @param used_s  how long it is [s]
 * @param used_rate_hz at which it was used: as slow as {@link Slower} makes it [Hz]
 * @param excited_from_hz lowest frequency at which the output follows an input [Hz]; empty where it does nowhere
 * @param excited_to_hz   the highest [Hz]
 */
public record Identification(String recording, List<String> inputs, String output, double rate_hz, double from_s, double used_s,
        double used_rate_hz, OptionalDouble excited_from_hz, OptionalDouble excited_to_hz, List<Tried> tried, Discrete armax,
        Optional<Continuous> instruments, Map<String, String> provenance) {

    /** Missing samples that are bridged [s]. */
    private static final double LONGEST_BRIDGE = 0.05;
    /** Pulsation about which a seated body is active [rad/s]: that of 5 Hz. */
    private static final double CENTRE = 2 * Math.PI * 5;

    /** Samples in the place of one for instruments: what a straight line misses of 15 Hz at 60 Hz falls from 19 % to 1 %. */
    private static final int CLOSER = 4;

    /**
     * A number of poles that was tried.
     *
     * @param schwarz Schwarz's criterion [1], the lower the better
     */
    public record Tried(int poles, double schwarz) {}

    /** A mode that the recording determines, and where it lies with one standard deviation. */
    public record Mode(double natural_frequency_hz, double natural_frequency_sd_hz, double damping_ratio, double damping_ratio_sd) {

        private static Mode of(EquivalentBody.Mode mode) {
            return new Mode(mode.frequency(), mode.frequencyDeviation(), mode.damping(), mode.dampingDeviation());
        }
    }

    /**
     * A pole pair of the model that is no mode of the recording's.
     *
     * @param near_hz where the model has it [Hz]
     * @param why     it has no number
     */
    public record Undetermined(double near_hz, String why) {}

    /** Modes of a model, told apart by whether the recording determines them. */
    private record Told(List<EquivalentBody.Mode> modes, List<Undetermined> undetermined) {

        List<Mode> known() {
            return modes.stream().map(Mode::of).toList();
        }
    }

    /**
     * ARMAX.
     *
     * @param a as long as there are poles [1]
     * @param b by input, in the output's unit over the input's
     * @param c as long as {@link wbv.identify.Armax} has it [1]
     * @param residual_sd in the output's unit
     * @param predicted share of the output's variance that is predicted one step ahead
     * @param simulated share that is simulated from the inputs alone
     */
    public record Discrete(int poles, double[] a, double[][] b, double[] c, double residual_sd, double predicted, double simulated,
            boolean converged, String equation, List<Mode> modes, List<Undetermined> undetermined) {}

    /**
     * {@code B(s)/A(s)} of every input, s in rad/s; coefficients of the highest power first, A's leading 1 left out.
     *
     * @param a as long as there are poles; units as {@link wbv.identify.TransferModel} has them
     * @param b by input; units likewise
     * @param simulated share of the output's variance that is simulated from the inputs alone
     */
    public record Continuous(int poles, double[] a, double[][] b, double simulated, List<Mode> modes,
            List<Undetermined> undetermined) {}

    /**
     * Identifies.
     *
     * @param poles candidates for the order of A
     * @throws DataFault if a channel is missing, does not move, or there are too few samples without a gap
     */
    public static Identification of(String name, Recording recording, List<Channel> inputs, Channel output, List<Integer> poles,
            Map<String, String> provenance) {
        List<double[]> channels = new ArrayList<>();
        double rate = recording.clock().rate();
        for (Channel channel : inputs) {
            channels.add(bridged(recording.values(channel), rate));
        }
        channels.add(bridged(recording.values(output), rate));
        int[] whole = longestWhole(channels);
        double[][] cut = channels.stream().map(each -> centred(each, whole[0], whole[1])).toArray(double[][]::new);
        for (int i = 0; i < cut.length; i++) {
            if (cut[i].length > 0 && !(power(cut[i]) > 0)) {
                throw DataFault.in(name, (i < inputs.size() ? inputs.get(i) : output) + " does not move; nothing can be identified");
            }
        }
        List<Orders> candidates = poles.stream().map(Orders::body).toList();
        IntSummaryStatistics fewest = candidates.stream().mapToInt(each -> new PredictionError(each).fewest(inputs.size()))
                .summaryStatistics();
        if (whole[1] - whole[0] < fewest.getMin()) {
            throw DataFault.in(name, String.format(Locale.ROOT,
                    "has %d samples without a gap; these orders need at least %d: record longer, or ask for fewer --poles",
                    whole[1] - whole[0], fewest.getMin()));
        }
        Samples recorded = new Samples(rate, Arrays.copyOf(cut, inputs.size()), cut[inputs.size()]);
        ExcitedBand band = ExcitedBand.of(recorded);
        Samples samples = band.exists() ? Slower.of(recorded, band.to(), fewest.getMax()) : recorded;
        OrderSelection selection = OrderSelection.among(candidates, samples);
        ArmaxFit best = selection.best().fit();
        Told told = told(best.modes(), best.converged(), band);
        Discrete discrete = discrete(best, samples, told);
        return new Identification(name, inputs.stream().map(Channel::toString).toList(), output.toString(), rate,
                recording.clock().time(whole[0]), recorded.length() / rate, samples.rate(), some(band.from()), some(band.to()),
                selection.tried().stream().map(each -> new Tried(each.orders().na(), each.criterion())).toList(), discrete,
                continuous(selection.best().orders().na(), samples, band), provenance);
    }

    private static OptionalDouble some(double value) {
        return Double.isFinite(value) ? OptionalDouble.of(value) : OptionalDouble.empty();
    }

    private static Told told(List<EquivalentBody.Mode> modes, boolean converged, ExcitedBand band) {
        List<EquivalentBody.Mode> known = new ArrayList<>();
        List<Undetermined> unknown = new ArrayList<>();
        for (EquivalentBody.Mode mode : modes) {
            if (!converged) {
                unknown.add(new Undetermined(mode.frequency(), "the estimate did not converge"));
            } else if (!band.holds(mode.frequency(), mode.damping())) {
                unknown.add(new Undetermined(mode.frequency(), "nothing is excited there that the output follows"));
            } else if (!mode.determined()) {
                unknown.add(new Undetermined(mode.frequency(), "the recording does not determine it"));
            } else {
                known.add(mode);
            }
        }
        return new Told(known, unknown);
    }

    private static Discrete discrete(ArmaxFit fit, Samples samples, Told told) {
        return new Discrete(fit.model().a().length, fit.model().a(), fit.model().b(), fit.model().c(), Math.sqrt(fit.model().variance()),
                share(samples.y(), fit.model().predict(samples, fit.initial())),
                share(samples.y(), fit.model().simulate(samples.u(), fit.initial())), fit.converged(), fit.model().toString(),
                told.known(), told.undetermined());
    }

    /**
     * Of the most poles, up to a number, with which instruments converge; empty where there are none. They take an input for
     * straight between samples, which one of up to half the rate is not: so the samples are laid closer first, band-limited.
     */
    private static Optional<Continuous> continuous(int most, Samples recorded, ExcitedBand band) {
        Samples samples = new Samples(recorded.rate() * CLOSER, Arrays.stream(recorded.u()).map(Identification::closer)
                .toArray(double[][]::new), closer(recorded.y()));
        for (int poles = most; poles >= 2; poles--) {
            try {
                TransferFit fit = new RefinedInstruments(poles, poles - 1, CENTRE).fit(samples);
                double simulated = share(samples.y(), fit.model().simulate(samples.u(), samples.rate(), fit.initial()));
                if (fit.converged() && simulated > 0) {
                    Told told = told(fit.modes(), true, band);
                    return Optional.of(new Continuous(poles, fit.model().a(), fit.model().b(), simulated, told.known(),
                            told.undetermined()));
                }
            } catch (ArithmeticException | IllegalArgumentException undetermined) {
                continue; // fewer poles may be told apart
            }
        }
        return Optional.empty();
    }

    private static double[] closer(double[] values) {
        Upsampler upsampler = new Upsampler(CLOSER);
        double[] out = new double[values.length * CLOSER];
        double[] block = new double[CLOSER];
        int at = 0;
        for (int k = 0; at < out.length; k++) {
            if (upsampler.accept(values[Math.min(k, values.length - 1)], block)) {
                System.arraycopy(block, 0, out, at, CLOSER);
                at += CLOSER;
            }
        }
        return out;
    }

    /** Share of the variance that is explained. */
    private static double share(double[] y, double[] said) {
        double left = 0;
        for (int k = 0; k < y.length; k++) {
            left += (y[k] - said[k]) * (y[k] - said[k]);
        }
        return 1 - left / power(y);
    }

    private static double power(double[] x) {
        return Arrays.stream(x).map(value -> value * value).sum();
    }

    private static double[] bridged(double[] values, double rate) {
        return GapBridge.over(values, Math.max(1, (int) Math.round(LONGEST_BRIDGE * rate)));
    }

    /** Begin and end of the longest stretch in which no channel misses a sample. */
    private static int[] longestWhole(List<double[]> channels) {
        int[] best = {0, 0};
        int from = 0;
        int length = channels.get(0).length;
        for (int k = 0; k <= length; k++) {
            int at = k;
            if (k == length || channels.stream().anyMatch(each -> !Double.isFinite(each[at]))) {
                if (k - from > best[1] - best[0]) {
                    best = new int[] {from, k};
                }
                from = k + 1;
            }
        }
        return best;
    }

    private static double[] centred(double[] values, int from, int to) {
        double[] cut = Arrays.copyOfRange(values, from, to);
        double mean = Arrays.stream(cut).average().orElse(0);
        Arrays.setAll(cut, i -> cut[i] - mean);
        return cut;
    }

    /** The result in a few lines. */
    public String summary() {
        StringBuilder text = new StringBuilder(String.format(Locale.ROOT, "%s: %s to %s, %.1f s without a gap at %.2f Hz%s%n", recording,
                String.join(", ", inputs), output, used_s, rate_hz,
                used_rate_hz < rate_hz ? String.format(Locale.ROOT, ", used at %.2f Hz", used_rate_hz) : ""));
        text.append(excited_to_hz.isEmpty() ? String.format("The output follows the input at no frequency%n")
                : String.format(Locale.ROOT, "The output follows what is excited from %.2g to %.3g Hz%n",
                        excited_from_hz.orElseThrow(), excited_to_hz.orElseThrow()));
        text.append(tried.size() == 1 ? String.format(Locale.ROOT, "%d poles%n", armax.poles())
                : String.format(Locale.ROOT, "Schwarz's criterion chooses %d poles of %s%n", armax.poles(), String.join(", ",
                        tried.stream().map(Tried::poles).sorted().map(String::valueOf).toList())));
        text.append(String.format(Locale.ROOT, "ARMAX by prediction error: %s of the variance predicted one step ahead, %s simulated%s%n",
                percent(armax.predicted()), percent(armax.simulated()), armax.converged() ? "" : "; not converged"));
        modes(text, armax.modes(), armax.undetermined());
        if (instruments.isEmpty()) {
            text.append(String.format("Refined instruments: converge with no number of poles%n"));
        } else {
            text.append(String.format(Locale.ROOT, "Refined instruments, in continuous time, %d poles: %s simulated%n",
                    instruments.get().poles(), percent(instruments.get().simulated())));
            modes(text, instruments.get().modes(), instruments.get().undetermined());
        }
        return text.toString();
    }

    private static String percent(double share) {
        return String.format(Locale.ROOT, share > 0.99 ? "%.2f %%" : "%.0f %%", 100 * share);
    }

    private static void modes(StringBuilder text, List<Mode> modes, List<Undetermined> undetermined) {
        for (Mode mode : modes) {
            text.append(String.format(Locale.ROOT, "  natural frequency %.3f ± %.3f Hz, damping ratio %.3f ± %.3f%n",
                    mode.natural_frequency_hz(), 2 * mode.natural_frequency_sd_hz(), mode.damping_ratio(), 2 * mode.damping_ratio_sd()));
        }
        for (Undetermined mode : undetermined) {
            text.append(String.format(Locale.ROOT, "  a pole near %.2g Hz is no mode with a number: %s%n", mode.near_hz(), mode.why()));
        }
        if (modes.isEmpty() && undetermined.isEmpty()) {
            text.append(String.format("  no mode: nothing swings%n"));
        }
    }
}
