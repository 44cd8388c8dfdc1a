package wbv.cli;

import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import wbv.body.Model;
import wbv.body.PublishedModels;
import wbv.recording.Channel;
import wbv.recording.inspect.RowSource;
import wbv.report.response.ResponsePage;
import wbv.result.OutputFolder;
import wbv.sensing.SkinMount;
import wbv.sensing.TapTest;
import wbv.study.ResponseAnalysis;
import wbv.study.ResponseRequest;

/** {@code wbv frf}: frequency responses from one or several inputs, with what they are worth. */
@Command(name = "frf", mixinStandardHelpOptions = true,
        description = "Frequency responses (transmissibility, apparent mass, any ratio) from one or several inputs that act at once, by "
                + "H1, H2 and Hv, with coherences and confidence. Writes report.html, frf.json and frf.csv.",
        footer = {"", "Examples:", "  wbv frf data/arff/two-dof.arff --output head.acc.z --out out",
            "  wbv frf data/arff/ride-subject1.arff \\",
            "      --input platform.acc.x,platform.acc.y,platform.acc.z \\",
            "      --output head.acc.x,head.acc.y,head.acc.z --out out",
            "  wbv frf data/arff/one-dof-linear.arff --model wei-griffin-1998-1dof",
            "  wbv frf shaker.csv --input seat.acc.z --output seat.force.z --plate 8.4",
            "  wbv frf data/arff/one-dof-step.arff --wavelet --out out",
            "  wbv frf anne.csv --also bert.csv --also carla.csv --out mean"})
final class Frf implements Callable<Integer> {

    @Mixin
    private RecordingOptions recording;

    @Option(names = "--input", paramLabel = "CHANNEL", split = ",",
            description = "exciting channels (platform.acc.z, floor.acc.z or seat.acc.z if there is one)")
    private List<String> inputs = new ArrayList<>();

    @Option(names = "--output", paramLabel = "CHANNEL", split = ",",
            description = "answering channels (all others of the inputs' quantity and axes, and forces)")
    private List<String> outputs = new ArrayList<>();

    @Option(names = "--also", paramLabel = "RECORDING",
            description = "recording of another person with the same channels; the mean keeps their resonance")
    private List<Path> people = new ArrayList<>();

    @Option(names = "--model", paramLabel = "MODEL",
            description = "model to draw over the responses: a JSON file, or the name of a published one")
    private Optional<String> model = Optional.empty();

    @Option(names = "--segment", paramLabel = "S",
            description = "length of a segment in s, taken to the next power of two of samples (what resolves a sitter's resonance)")
    private Optional<Double> segment = Optional.empty();

    @Option(names = "--level", paramLabel = "SHARE", defaultValue = "0.95", description = "confidence of the bands (${DEFAULT-VALUE})")
    private double level;

    @Option(names = "--plate", paramLabel = "KG", defaultValue = "0",
            description = "mass that moves between load cell and sitter, taken off apparent masses (${DEFAULT-VALUE})")
    private double plate;

    @Option(names = "--wavelet",
            description = "follow the response of each output through time, by Morlet's wavelet, from one input; writes wavelet.csv too")
    private boolean wavelet;

    @Option(names = "--skin", paramLabel = "PLACE=HZ:RATIO|PLACE=TAP",
            description = "natural frequency and damping ratio of the skin under a place's sensor, whose motion is taken out; or "
                    + "a recording of a tap beside it, which shows them")
    private Map<String, String> skin = new LinkedHashMap<>();

    @Mixin
    private ResultFolder out;

    @Mixin
    private Answer answer;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        Map<String, SkinMount> mounts = mounts();
        if (segment.isPresent() && !(segment.get() > 0 && segment.get() < Double.POSITIVE_INFINITY)) {
            throw wrong("--segment must be > 0 s: " + segment.get());
        }
        List<Channel> in = Usage.channels(spec, inputs);
        List<Channel> answering = Usage.channels(spec, outputs);
        Optional<Model> drawn = model.isEmpty() ? Optional.empty() : Optional.of(PublishedModels.find(model.get()));
        Map<String, RowSource> others = new LinkedHashMap<>();
        for (Path path : people) {
            String name = path.getFileName().toString();
            if (others.putIfAbsent(others.containsKey(name) || name.equals(recording.title()) ? path.toString() : name,
                    recording.another(path)) != null) {
                throw wrong("--also names " + path + " twice");
            }
        }
        ResponseRequest request;
        try {
            request = new ResponseRequest(recording.source(), recording.title(), others, in, answering,
                    segment.map(OptionalDouble::of).orElseGet(OptionalDouble::empty), level, drawn, plate, wavelet, mounts,
                    recording.map(), provenance());
        } catch (IllegalArgumentException e) {
            throw wrong(e.getMessage());
        }
        try (OutputFolder folder = out.open(); ProgressBar bar = answer.progress()) {
            ResponseAnalysis analysis = ResponseAnalysis.run(request, folder, bar::at);
            ResponsePage.write(analysis, folder);
            folder.publish();
            bar.close();
            answer.print(analysis.summary(),
                    "Wrote " + out.file("report.html") + ", frf.json, frf.csv" + (wavelet ? ", wavelet.csv" : "") + "\n",
                    out.json("frf.json"));
        }
        return 0;
    }

    private Map<String, SkinMount> mounts() throws IOException {
        Map<String, SkinMount> mounts = new LinkedHashMap<>();
        for (Map.Entry<String, String> entry : skin.entrySet()) {
            String place = entry.getKey();
            String values = entry.getValue();
            Optional<Path> tap = tap(values);
            if (Channel.isLocation(place) && tap.isPresent()) {
                mounts.put(place, TapTest.fit(recording.another(tap.get()).load(), place).mount());
                continue;
            }
            String[] words = values.split(":", -1);
            try {
                if (words.length != 2 || !Channel.isLocation(place)) {
                    throw new IllegalArgumentException("is not PLACE=HZ:RATIO, such as head=30:0.35, and no such file");
                }
                mounts.put(place, new SkinMount(Double.parseDouble(words[0]), Double.parseDouble(words[1])));
            } catch (IllegalArgumentException e) {
                throw wrong("--skin " + place + "=" + values + ": " + e.getMessage());
            }
        }
        return mounts;
    }

    /** The file of a tap, if that is what stands there: two numbers are no name of a file on every system. */
    private static Optional<Path> tap(String values) {
        return Optional.of(new File(values)).filter(File::exists).map(File::toPath);
    }

    private Map<String, String> provenance() throws IOException {
        List<Path> files = new ArrayList<>(recording.inputs());
        files.addAll(people);
        skin.values().forEach(values -> tap(values).ifPresent(files::add));
        model.ifPresent(name -> files.add(Path.of(name)));
        return new ResultProvenance(spec).of(files).entries();
    }

    private ParameterException wrong(String usage) {
        return new ParameterException(spec.commandLine(), usage);
    }
}
