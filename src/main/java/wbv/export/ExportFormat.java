package wbv.export;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import wbv.body.Model;
import wbv.recording.AtomicFile;
import wbv.recording.DataFault;

/** Where a model can go. */
public enum ExportFormat {
    /** One file that needs NumPy alone. */
    PYTHON,
    /** A functional mock-up unit for co-simulation, FMI 3.0. */
    FMU,
    /** One flat model that needs no library. */
    MODELICA,
    /** An XML file of MuJoCo, and a Python file beside it with what MuJoCo has not. */
    MUJOCO;

    /**
     * The format of a word in any case.
     *
     * @throws IllegalArgumentException if it is none: the message names those that are
     */
    public static ExportFormat of(String word) {
        return Arrays.stream(values()).filter(each -> each.name().equalsIgnoreCase(word)).findFirst().orElseThrow(
                () -> new IllegalArgumentException("'" + word + "' is none of the formats " + Arrays.toString(values())));
    }

    /** As it is written on the command line. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }

    /**
     * Writes a model, all of it or nothing.
     *
     * @return what there is to say about it, in one line; empty for nothing
     */
    public String write(Model model, Path out) throws IOException {
        String remark = written(model, out);
        boolean past = this == PYTHON || model.base().filter().isEmpty();
        return past ? remark : remark + (remark.isEmpty() ? "" : "; ") + "without the sensors' anti-alias filter, which looks ahead";
    }

    private String written(Model model, Path out) throws IOException {
        if (model.outputs().isEmpty()) {
            throw new DataFault("the model '" + model.name() + "' has no sensor: give a body or a link one, whose motion is to be read");
        }
        if (model.excitations().isEmpty()) {
            throw new DataFault("the model '" + model.name()
                    + "' has no input: name the channel that measures its base's motion, or a force ('inputs')");
        }
        if (!model.isAlongOneAxis()) {
            throw new DataFault("the model '" + model.name()
                    + "' moves along several axes or has lever arms, for which no other form is written: run it with wbv simulate");
        }
        if (this == FMU) {
            FmuFile.Made made = FmuFile.of(model);
            AtomicFile.write(out, made.bytes());
            return made.remark();
        }
        if (this == MUJOCO) {
            MujocoText text = new MujocoText(model);
            String name = out.getFileName().toString();
            Path beside = out.resolveSibling(name.replaceAll("\\.xml$", "") + ".py");
            if (beside.equals(out)) {
                throw new DataFault("'" + name + "' is the file of Python beside MuJoCo's: let the name end in .xml");
            }
            String xml = text.xml();
            String python = PythonText.besideMujoco(model, text.foreign(), name);
            try (AtomicFile first = AtomicFile.begin(beside); AtomicFile second = AtomicFile.begin(out)) {
                first.stream().write(python.getBytes(StandardCharsets.UTF_8));
                second.stream().write(xml.getBytes(StandardCharsets.UTF_8));
                first.finish();
                second.finish();
            }
            return "with " + beside + ", which runs it and adds "
                    + (text.foreign().isEmpty() ? "its input" : "its input and " + text.foreign().size()
                            + (text.foreign().size() == 1 ? " law" : " laws") + " that MuJoCo has not");
        }
        AtomicFile.write(out, this == MODELICA ? ModelicaText.of(model) : PythonText.of(model));
        return "";
    }
}
