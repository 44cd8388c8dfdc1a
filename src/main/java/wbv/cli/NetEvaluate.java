package wbv.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import wbv.learn.AdwinAlarm;
import wbv.network.Architecture;
import wbv.network.Bodies;
import wbv.network.Evaluation;
import wbv.network.LabelledMotion;
import wbv.network.Ridge;
import wbv.network.RigTrials;
import wbv.network.TrainedNetwork;
import wbv.network.TrainingOrder;
import wbv.report.network.NetworkComparisonReport;
import wbv.result.OutputFolder;

/** {@code wbv net evaluate}: networks beside classical methods, on bodies that none has seen. */
@Command(name = "evaluate", mixinStandardHelpOptions = true,
        description = "Asks networks, ridge regression on the same images, refined instruments and the streaming estimators "
                + "about fresh trials, in and out of the networks' domain. Writes evaluation.csv and report.html.",
        footer = {"", "Examples:", "  wbv net evaluate --out out",
            "  wbv net evaluate --bodies 1-dof,2-dof --model a.safetensors,b.safetensors --out out", "",
            "Models that differ in their training's seed alone make one row: means, and how far the seeds lie apart."})
final class NetEvaluate implements Callable<Integer> {

    private static final double FALSE_CUTS = 0.002;

    @Option(names = "--model", paramLabel = "FILE", split = ",",
            description = "models of 'wbv net train' (those that come with wbv)")
    private List<Path> files = new ArrayList<>();

    @Option(names = "--bodies", paramLabel = "KIND", split = ",", description = "kinds of trial (all that a model fits); people "
            + "take a quarter of a second each")
    private List<String> kinds = new ArrayList<>();

    @Option(names = "--trials", paramLabel = "N", defaultValue = "200",
            description = "fresh trials of each kind (${DEFAULT-VALUE})")
    private int trials;

    @Option(names = "--seed", paramLabel = "N", defaultValue = "2000003",
            description = "seed of the fresh trials (${DEFAULT-VALUE})")
    private long seed;

    @Option(names = "--ridge", paramLabel = "N", defaultValue = "1000",
            description = "trials of the models' data that ridge regression learns from; 0 for none (${DEFAULT-VALUE})")
    private int ridge;

    @Mixin
    private ResultFolder out;

    @Mixin
    private Answer answer;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        if (trials < 20 || trials > 100_000 || ridge != 0 && (ridge < 100 || ridge > 5000)) {
            throw new ParameterException(spec.commandLine(), "--trials must be 20 to 100000, --ridge 0 or 100 to 5000: "
                    + trials + ", "
                    + ridge);
        }
        List<Bodies> asked = kinds();
        List<TrainedNetwork> models = new ArrayList<>();
        for (Path file : files) {
            models.add(TrainedNetwork.read(file));
        }
        if (models.isEmpty()) {
            models.add(TrainedNetwork.shipped(1));
            models.add(TrainedNetwork.shipped(2));
        }
        try (OutputFolder folder = out.open(); ProgressBar bar = answer.progress()) {
            List<Evaluation> evaluations = new ArrayList<>();
            Map<Integer, Map<String, Ridge>> ridges = new HashMap<>();
            for (Bodies bodies : asked) {
                List<TrainedNetwork> fitting = models.stream().filter(model -> model.modes() == bodies.modes()
                        && model.channels().size() <= bodies.channels().size()).toList();
                if (!fitting.isEmpty()) {
                    List<LabelledMotion> fresh = RigTrials.of(bodies, trials, seed, share -> bar.at("simulating " + bodies.word(), share));
                    bar.at("asking", Double.NaN);
                    evaluations.add(Evaluation.of(bodies, fresh, fitting, ridges.computeIfAbsent(bodies.modes(),
                            modes -> ridges(fitting.get(0), bar)),
                            () -> new AdwinAlarm(FALSE_CUTS)));
                }
            }
            if (evaluations.isEmpty()) {
                throw new ParameterException(spec.commandLine(), "none of the models knows as many modes as bodies "
                        + String.join(", ", kinds) + " have, and sees no more axes than move there");
            }
            NetworkComparisonReport report = new NetworkComparisonReport(evaluations, models,
                    new ResultProvenance(spec).of(files).entries());
            report.write(folder);
            folder.publish();
            bar.close();
            answer.print(report.summary(), "Wrote " + out.file("report.html") + ", evaluation.csv\n", report::json);
        }
        return 0;
    }

    private List<Bodies> kinds() {
        try {
            return kinds.isEmpty() ? List.of(Bodies.values()) : kinds.stream().map(NetTrain::kind).toList();
        } catch (IllegalArgumentException wrong) {
            throw new ParameterException(spec.commandLine(), wrong.getMessage());
        }
    }

    /** Ridge regression on the trials that the model learned from, on the thesis' images and on ours. */
    private Map<String, Ridge> ridges(TrainedNetwork model, ProgressBar bar) {
        Map<String, Ridge> ridges = new LinkedHashMap<>();
        if (ridge == 0) {
            return ridges;
        }
        Bodies bodies = model.modes() == 1 ? Bodies.ONE_DOF : Bodies.TWO_DOF;
        long dataSeed = Long.parseLong(model.card().getOrDefault("data seed", "1"));
        List<LabelledMotion> all = RigTrials.of(bodies, ridge, dataSeed, share -> bar.at("simulating for ridge regression", share));
        int held = all.size() / TrainingOrder.HELD_BACK;
        for (Architecture architecture : List.of(Architecture.CNN, Architecture.POOLED)) {
            ridges.put("ridge on images of " + architecture.word(), Ridge.fit(architecture.imaging(),
                    all.subList(0, all.size() - held), all.subList(all.size() - held, all.size())));
        }
        return ridges;
    }
}
