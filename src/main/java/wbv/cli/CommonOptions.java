package wbv.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import wbv.filter.Method;
import wbv.recording.Channel;

/** Options that mean the same in several commands, each described once. */
final class CommonOptions {

    private CommonOptions() {}

    /** Where all that is random begins. */
    static final class Seed {

        @Option(names = "--seed", paramLabel = "N", defaultValue = "1",
                description = "what everything random is drawn from: the same seed gives the same results (${DEFAULT-VALUE})")
        private long number;

        long number() {
            return number;
        }
    }

    /** How samples were made. */
    static final class Sampling {

        @Option(names = "--boxcar", description = "samples are means over the sampling period (Xsens MTw, DOT): undo their droop")
        private boolean boxcar;

        boolean boxcar() {
            return boxcar;
        }
    }

    /** Where the sitter is met. */
    static final class Contact {

        @Option(names = "--seat", paramLabel = "PLACE",
                description = "where the vibration enters the sitter (seat, else platform or floor)")
        private Optional<String> seat = Optional.empty();

        @Spec(Spec.Target.MIXEE)
        private CommandSpec spec;

        Optional<String> seat() {
            return seat.map(name -> Usage.place(spec, "--seat", name));
        }
    }

    /** Who follows the body of a seat, where many are followed. */
    static final class Follower {

        @Option(names = "--estimator", paramLabel = "NAME", defaultValue = "ekf-adwin",
                description = "ekf, ekf-adwin, ukf, particle, constrained or fused (${DEFAULT-VALUE})")
        private String estimator;

        @Spec(Spec.Target.MIXEE)
        private CommandSpec spec;

        Method method() {
            return Method.named(estimator).orElseThrow(() -> new ParameterException(spec.commandLine(),
                    "--estimator must be one of " + String.join(", ", Method.words()) + ": " + estimator));
        }
    }

    /** From where to where a body is looked at, and where an estimator starts. */
    static final class Body {

        @Option(names = "--input", paramLabel = "CHANNEL",
                description = "exciting channel (platform.acc.z, floor.acc.z or seat.acc.z if there is one)")
        private Optional<String> input = Optional.empty();

        @Option(names = "--output", paramLabel = "CHANNEL", split = ",",
                description = "answering channels (all others of the input's quantity and axis)")
        private List<String> outputs = new ArrayList<>();

        @Option(names = "--start-frequency", paramLabel = "HZ", defaultValue = "5",
                description = "natural frequency to start from (${DEFAULT-VALUE})")
        private double frequency;

        @Option(names = "--start-damping", paramLabel = "RATIO", defaultValue = "0.4",
                description = "damping ratio to start from (${DEFAULT-VALUE})")
        private double damping;

        @Spec(Spec.Target.MIXEE)
        private CommandSpec spec;

        /** One or none. */
        List<Channel> input() {
            return Usage.channels(spec, input.stream().toList());
        }

        List<Channel> outputs() {
            return Usage.channels(spec, outputs);
        }

        double startFrequency() {
            return Usage.within(spec, "--start-frequency", frequency, wbv.filter.model.Spec.LEAST_FREQUENCY,
                    wbv.filter.model.Spec.MOST_FREQUENCY, " Hz");
        }

        double startDamping() {
            return Usage.within(spec, "--start-damping", damping, wbv.filter.model.Spec.LEAST_DAMPING, wbv.filter.model.Spec.MOST_DAMPING);
        }
    }
}
