package wbv.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import wbv.network.Architecture;
import wbv.network.Bodies;
import wbv.network.Order;
import wbv.network.Settings;
import wbv.network.Trainer;
import wbv.recording.AtomicFile;
import wbv.report.NetworkTrainingReport;
import wbv.report.OutputFolder;

/** {@code wbv net train}: from the virtual rig to a model. */
@Command(name = "train", mixinStandardHelpOptions = true,
        description = "Simulates trials, trains a network on them, and writes model.safetensors with its card, losses.csv and "
                + "report.html. The same seeds give the same model.",
        footer = {"", "Example:", "  wbv net train --bodies 1-dof --network pooled --images 2046 --members 3 --out out"})
final class NetTrain implements Callable<Integer> {

    @Option(names = "--bodies", paramLabel = "KIND", defaultValue = "1-dof",
            description = "who sits on the rig: 1-dof, 2-dof, coupled (a base that moves in three axes) or people "
                    + "(${DEFAULT-VALUE})")
    private String bodies;

    @Option(names = "--network", paramLabel = "NAME", defaultValue = "pooled",
            description = "cnn or residual (the thesis'), pooled (ours), answer-only (ours without a sensor at the seat), or "
                    + "three-axes (ours that sees x and y at the seat as well) (${DEFAULT-VALUE})")
    private String network;

    @Option(names = "--images", paramLabel = "N", defaultValue = "2046",
            description = "trials, a tenth of them held back (${DEFAULT-VALUE})")
    private int images;

    @Option(names = "--members", paramLabel = "N", defaultValue = "1",
            description = "networks from other seeds that are asked together (${DEFAULT-VALUE})")
    private int members;

    @Option(names = "--data-seed", paramLabel = "N", defaultValue = "1", description = "seed of the trials (${DEFAULT-VALUE})")
    private long dataSeed;

    @Option(names = "--seed", paramLabel = "N", defaultValue = "1", description = "seed of the training (${DEFAULT-VALUE})")
    private int seed;

    @Option(names = "--epochs", paramLabel = "N", description = "times that every image is shown (the network's own)")
    private Optional<Integer> epochs = Optional.empty();

    @Option(names = "--batch", paramLabel = "N", description = "images at a step")
    private Optional<Integer> batch = Optional.empty();

    @Option(names = "--rate", paramLabel = "RATE", description = "learning rate")
    private Optional<Double> rate = Optional.empty();

    @Option(names = "--drop-period", paramLabel = "N",
            description = "epochs after which the learning rate drops: one reading of the thesis' \"Dropout Frequency 20\"")
    private Optional<Integer> dropPeriod = Optional.empty();

    @Option(names = "--drop-factor", paramLabel = "FACTOR", description = "by which it is multiplied then")
    private Optional<Double> dropFactor = Optional.empty();

    @Option(names = "--dropout", paramLabel = "SHARE",
            description = "units left out at each step: the other reading")
    private Optional<Double> dropout = Optional.empty();

    @Option(names = "--checkpoint", paramLabel = "FILE",
            description = "keeps the state after every epoch; where the file is there already, training goes on from it")
    private Optional<Path> checkpoint = Optional.empty();

    @Mixin
    private ResultFolder out = new ResultFolder();

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        Order order = order();
        try (OutputFolder folder = out.open(); ProgressBar bar = new ProgressBar()) {
            Trainer trainer = new Trainer(order, checkpoint, bar::at);
            Trainer.Result result = trainer.train();
            NetworkTrainingReport report = new NetworkTrainingReport(order, result, new Provenance(words()).entries());
            AtomicFile.write(folder.file("model.safetensors"), result.model().bytes());
            report.write(folder);
            folder.publish();
            trainer.forget();
            bar.close();
            spec.commandLine().getOut().print(report.summary() + "Wrote " + out.file("model.safetensors")
                    + ", losses.csv, report.html\n");
            spec.commandLine().getOut().flush();
        }
        return 0;
    }

    private Order order() {
        try {
            Architecture architecture = Architecture.named(network).orElseThrow(() -> new IllegalArgumentException(
                    "--network must be one of " + String.join(", ", Architecture.words()) + ": " + network));
            Settings usual = architecture.settings();
            Settings settings = new Settings(epochs.orElse(usual.epochs()), batch.orElse(usual.batch()), usual.method(),
                    rate.orElse(usual.rate()), dropPeriod.orElse(usual.dropPeriod()), dropFactor.orElse(usual.dropFactor()),
                    dropout.orElse(usual.dropout()), seed);
            return new Order(kind(bodies), images, dataSeed, architecture, settings, members);
        } catch (IllegalArgumentException wrong) {
            throw new ParameterException(spec.commandLine(), wrong.getMessage());
        }
    }

    static Bodies kind(String word) {
        return Arrays.stream(Bodies.values()).filter(each -> each.word().equals(word)).findFirst()
                .orElseThrow(() -> new IllegalArgumentException("--bodies must be one of "
                        + String.join(", ", Arrays.stream(Bodies.values()).map(Bodies::word).toList()) + ": " + word));
    }

    private List<String> words() {
        List<String> words = new ArrayList<>(List.of("net", "train", "--bodies", bodies, "--network", network, "--images",
                Integer.toString(images), "--members", Integer.toString(members), "--data-seed", Long.toString(dataSeed),
                "--seed", Integer.toString(seed)));
        epochs.ifPresent(value -> words.addAll(List.of("--epochs", value.toString())));
        batch.ifPresent(value -> words.addAll(List.of("--batch", value.toString())));
        rate.ifPresent(value -> words.addAll(List.of("--rate", value.toString())));
        dropPeriod.ifPresent(value -> words.addAll(List.of("--drop-period", value.toString())));
        dropFactor.ifPresent(value -> words.addAll(List.of("--drop-factor", value.toString())));
        dropout.ifPresent(value -> words.addAll(List.of("--dropout", String.format(Locale.ROOT, "%s", value))));
        return words;
    }
}
