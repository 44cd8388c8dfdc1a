package wbv.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import wbv.filter.Constraint;
import wbv.filter.EstimatorDesign;
import wbv.filter.FixedBounds;
import wbv.filter.Method;
import wbv.learn.Detectors;
import wbv.pole.PolygonFile;
import wbv.pole.TrainedPoles;
import wbv.report.tracking.AsymptotesPage;
import wbv.report.tracking.TrackingPage;
import wbv.report.tracking.WithoutSensorsPage;
import wbv.result.OutputFolder;
import wbv.study.Asymptotes;
import wbv.study.Tracking;
import wbv.study.TrackingRequest;
import wbv.study.WithoutSensors;

/** {@code wbv track}: a body followed through a recording by any estimator. */
@Command(name = "track", mixinStandardHelpOptions = true,
        description = "Follows natural frequency and damping ratio through a recording by one or more estimators. Writes "
                + "tracks.csv, tracks.arff, tracks.json, results.json and report.html.",
        footer = {"", "Examples:", "  wbv track data/arff/one-dof-step.arff --estimator ekf,fused --out out",
            "  wbv track data/arff/ride-subject1.arff --input platform.gyr.y \\",
            "      --output head.gyr.y --estimator particle --particles 2000 --out out",
            "  wbv track data/arff/ride-subject1.arff \\", "      --cross platform.acc.x,platform.gyr.y --out out",
            "  wbv track data/arff/one-dof-linear.arff --asymptotes --out out",
            "  wbv track ride.csv --without head,sternum \\",
            "      --polygons out/polygons.json --out predicted"})
final class Track implements Callable<Integer> {

    private static final String ALL = "all";

    @Mixin
    private RecordingOptions recording;

    @Mixin
    private CommonOptions.Body body;

    @Option(names = "--estimator", paramLabel = "NAME", split = ",", defaultValue = "fused",
            description = "ekf, ekf-adwin, ukf, particle, constrained, fused, or all of them (${DEFAULT-VALUE})")
    private List<String> estimators = new ArrayList<>();

    @Option(names = "--cross", paramLabel = "CHANNEL", split = ",",
            description = "other motions of the base that move the body too, such as platform.acc.x,platform.gyr.y: what they do to "
                    + "an output is learned and taken away")
    private List<String> crossing = new ArrayList<>();

    @Option(names = "--degrees", paramLabel = "N", defaultValue = "1",
            description = "degrees of freedom of the body, 1 or 2 (${DEFAULT-VALUE})")
    private int degrees;

    @Option(names = "--noise", paramLabel = "DENSITY",
            description = "noise density of the sensors, m/s²/√Hz or rad/s/√Hz (0.00196, or 0.000175)")
    private Optional<Double> density = Optional.empty();

    @Option(names = "--particles", paramLabel = "N", defaultValue = "1000",
            description = "particles of a particle filter, the one estimator that draws at random (${DEFAULT-VALUE})")
    private int particles;

    @Mixin
    private CommonOptions.Seed seed;

    @Option(names = "--bound", paramLabel = "NAME=LOW:HIGH", split = ",",
            description = "bounds for the constrained estimator: frequency, damping, real, imaginary or output; 2.frequency for the "
                    + "faster mode")
    private List<String> bounds = new ArrayList<>();

    @Option(names = "--detector", paramLabel = "CLASS", defaultValue = Detectors.USUAL,
            description = "change detector that listens beside the estimators' own tests: a class of MOA's with its options, such as "
                    + "'ADWINChangeDetector -a 0.01' or 'PageHinkleyDM -l 20', or none (${DEFAULT-VALUE})")
    private String detector;

    @Option(names = "--asymptotes",
            description = "draw where the filters ekf and ekf-adwin converge on this recording instead of tracking it")
    private boolean asymptotes;

    @Option(names = "--without", paramLabel = "PLACE", split = ",",
            description = "do without the sensors of these places: predict them by --polygons; writes prediction.csv, tracks.csv, "
                    + "results.json and report.html")
    private List<String> without = new ArrayList<>();

    @Option(names = "--polygons", paramLabel = "FILE", description = "polygons.json of 'wbv poles'")
    private Optional<Path> polygons = Optional.empty();

    @Mixin
    private ResultFolder out;

    @Mixin
    private Answer answer;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        if (without.isEmpty() != polygons.isEmpty()) {
            throw new ParameterException(spec.commandLine(), "--without and --polygons go together");
        }
        if (!without.isEmpty()) {
            return predict();
        }
        if (asymptotes && !crossing.isEmpty()) {
            throw new ParameterException(spec.commandLine(), "--cross is for tracking; --asymptotes knows one input");
        }
        List<EstimatorDesign> designs = designs();
        TrackingRequest request = new TrackingRequest(recording.source(), recording.title(), body.input(), body.outputs(),
                Usage.channels(spec, crossing), designs, body.startFrequency(), body.startDamping(),
                density.isPresent() ? Usage.within(spec, "--noise", density.get(), 1e-9, 1e3) : Double.NaN, detector(),
                new ResultProvenance(spec).of(recording.inputs()).entries());
        try (OutputFolder folder = out.open(); ProgressBar bar = answer.progress()) {
            String summary = asymptotes ? asymptotes(request, folder, bar) : track(request, folder, bar);
            folder.publish();
            bar.close();
            answer.print(summary, "Wrote " + out.file("report.html") + (asymptotes ? ", asymptotes.csv, results.json\n"
                    : ", tracks.csv, tracks.arff, tracks.json, results.json\n"), out.json("results.json"));
        }
        return 0;
    }

    private static String track(TrackingRequest request, OutputFolder folder, ProgressBar bar) throws IOException {
        Tracking tracking = Tracking.run(request, folder, bar::at);
        TrackingPage.write(tracking, folder);
        return tracking.summary();
    }

    private static String asymptotes(TrackingRequest request, OutputFolder folder, ProgressBar bar) throws IOException {
        Asymptotes found = Asymptotes.run(request, folder, bar::at);
        AsymptotesPage.write(found, request, folder);
        return found.summary();
    }

    private int predict() throws IOException {
        TrainedPoles trained = PolygonFile.read(polygons.orElseThrow());
        try (OutputFolder folder = out.open(); ProgressBar bar = answer.progress()) {
            bar.at("predicting", Double.NaN);
            WithoutSensors run = WithoutSensors.run(trained, recording.title(), recording.source().load(),
                    without.stream().distinct().toList());
            List<Path> inputs = new ArrayList<>(recording.inputs());
            inputs.add(polygons.get());
            Map<String, String> provenance = new ResultProvenance(spec).of(inputs).entries();
            run.write(provenance, folder);
            WithoutSensorsPage.write(run, provenance, folder);
            folder.publish();
            bar.close();
            answer.print(run.summary(), "Wrote " + out.file("report.html") + ", prediction.csv, tracks.csv, results.json\n",
                    out.json("results.json"));
        }
        return 0;
    }

    private List<EstimatorDesign> designs() {
        List<String> names = estimators.contains(ALL) ? Method.words() : estimators;
        try {
            Constraint constraint = FixedBounds.parse(String.join(",", bounds));
            List<EstimatorDesign> designs = new ArrayList<>();
            for (String name : names.stream().distinct().toList()) {
                Method method = Method.named(name).orElseThrow(() -> new IllegalArgumentException("--estimator must be one of "
                        + String.join(", ", Method.words()) + " or all: " + name));
                designs.add(new EstimatorDesign(method, degrees, particles, seed.number(),
                        method == Method.CONSTRAINED ? constraint : Constraint.NONE));
            }
            if (constraint != Constraint.NONE && !names.contains(Method.CONSTRAINED.word())) {
                throw new IllegalArgumentException("--bound needs --estimator constrained among the estimators");
            }
            return designs;
        } catch (IllegalArgumentException wrong) {
            throw new ParameterException(spec.commandLine(), wrong.getMessage());
        }
    }

    private String detector() {
        try {
            Detectors.named(detector);
            return detector.strip();
        } catch (IllegalArgumentException wrong) {
            throw new ParameterException(spec.commandLine(), "--detector: " + wrong.getMessage());
        }
    }
}
