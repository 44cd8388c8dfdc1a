package wbv.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import wbv.body.PublishedModels;
import wbv.export.ExportFormat;

/** {@code wbv export}: a completed model for another simulator. */
@Command(name = "export", mixinStandardHelpOptions = true,
        description = "Writes a model, such as the model.json of a diagnosis, for other simulators: its bodies, links, laws, drives and "
                + "sensors.",
        footer = {"", "Formats:",
            "  python    a function in one file that needs NumPy alone; it gives what 'wbv simulate --model' gives",
            "  fmu       a functional mock-up unit for co-simulation, FMI 3.0: C source, and a binary for this machine where a C "
                    + "compiler is found",
            "  mujoco    XML, and a Python file beside it that runs it and adds what MuJoCo has not",
            "  modelica  one flat model of plain equations that needs no library",
            "", "What wbv filters to both sides in time, such as the angle that an angular rate makes, is an input of its own in fmu and "
                    + "modelica.",
            "", "Examples:", "  wbv export out/model.json --to python --out model.py",
            "  wbv export wei-griffin-1998-1dof --to fmu --out seated.fmu"})
final class Export implements Callable<Integer> {

    @Parameters(paramLabel = "MODEL", description = "a model as JSON, or the name of a published one (wbv simulate --models lists them)")
    private String model;

    @Option(names = "--to", paramLabel = "FORMAT", required = true, description = "python, fmu, mujoco or modelica")
    private String format;

    @Option(names = "--out", paramLabel = "FILE", required = true, description = "where to write it")
    private Path out;

    @Mixin
    private Answer answer;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        ExportFormat chosen;
        try {
            chosen = ExportFormat.of(format);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), "--to: " + e.getMessage());
        }
        String remark = chosen.write(PublishedModels.find(model), out);
        answer.print("Wrote " + out + (remark.isEmpty() ? "" : "; " + remark) + "\n", new Answer.Written(out.toString()));
        return 0;
    }
}
