package wbv.fmi;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import wbv.recording.DataFault;

/** Reads a {@code modelDescription.xml} of FMI 2.0 or 3.0. No external entity is followed, and no document type is read. */
final class DescriptionReader {

    private static final Set<String> TYPES = Set.of("Float64", "Float32", "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64",
            "UInt64", "Boolean", "String", "Binary", "Enumeration", "Clock");
    private static final int SHOWN = 120;

    private final XMLStreamReader xml;
    private final List<String> path = new ArrayList<>();
    private final Map<String, VariableUnit> units = new HashMap<>();
    private final Map<String, String> unitOfType = new HashMap<>();
    private final List<Variable> variables = new ArrayList<>();
    private final List<String> categories = new ArrayList<>();
    private Optional<Variable> open = Optional.empty();
    private Optional<Description.Kind> coSimulation = Optional.empty();
    private Optional<Description.Kind> modelExchange = Optional.empty();
    private OptionalDouble step = OptionalDouble.empty();
    private String version = "";
    private String model = "";
    private String token = "";
    private String named = "";
    private int states;
    private int indicators;

    private DescriptionReader(XMLStreamReader xml) {
        this.xml = xml;
    }

    /**
     * @param name of the unit, for messages
     * @throws DataFault if it is not of FMI 2.0 or 3.0, or damaged
     */
    static Description read(Path file, String name) throws IOException {
        XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        try (InputStream in = Files.newInputStream(file)) {
            return new DescriptionReader(factory.createXMLStreamReader(in)).description();
        } catch (XMLStreamException | IllegalArgumentException wrong) {
            String why = wrong instanceof XMLStreamException at && at.getLocation() != null
                    ? "line " + at.getLocation().getLineNumber() + ", " : "";
            String said = String.valueOf(wrong.getMessage()).replaceAll("(?s).*Message: ", "").replaceAll("\\s+", " ");
            throw DataFault.in(name, "its modelDescription.xml cannot be read: " + why + said.substring(0, Math.min(SHOWN, said.length())),
                    wrong);
        } catch (DataFault fault) {
            throw fault.of(name);
        }
    }

    private Description description() throws XMLStreamException {
        while (xml.hasNext()) {
            switch (xml.next()) {
                case XMLStreamConstants.START_ELEMENT -> {
                    begin(xml.getLocalName());
                    path.add(xml.getLocalName());
                }
                case XMLStreamConstants.END_ELEMENT -> {
                    path.remove(path.size() - 1);
                    if (inside("ModelVariables")) {
                        open.ifPresent(variables::add);
                        open = Optional.empty();
                    }
                }
                default -> {}
            }
        }
        return new Description(version.startsWith("3") ? 3 : 2, model, token, coSimulation, modelExchange, variables, states, indicators,
                step, categories);
    }

    /** @param element that begins inside of {@link #path} */
    private void begin(String element) {
        if (path.isEmpty()) {
            root(element);
        } else if (path.size() == 1) {
            switch (element) {
                case "CoSimulation" -> coSimulation = Optional.of(kind());
                case "ModelExchange" -> modelExchange = Optional.of(kind());
                case "DefaultExperiment" -> step = number("stepSize");
                default -> {}
            }
        } else if (inside("ModelVariables")) {
            open = Optional.of(variable(element));
        } else if (path.get(1).equals("ModelVariables") && open.isPresent()) {
            detail(element);
        } else if (path.get(1).equals("UnitDefinitions")) {
            unit(element);
        } else if (path.get(1).equals("TypeDefinitions")) {
            named = text("name").orElse(named);
            text("unit").ifPresent(unit -> unitOfType.put(named, unit));
        } else if (path.get(1).equals("LogCategories")) {
            text("name").ifPresent(categories::add);
        } else if (path.get(1).equals("ModelStructure")) {
            boolean derivative = element.equals("ContinuousStateDerivative") || element.equals("Unknown") && inside("Derivatives");
            states += derivative ? 1 : 0;
            indicators += element.equals("EventIndicator") ? 1 : 0;
        }
    }

    private void root(String element) {
        version = text("fmiVersion").orElse("");
        if (!element.equals("fmiModelDescription")) {
            throw new DataFault("its modelDescription.xml begins with <" + element
                    + ">, not with <fmiModelDescription>; is it a functional mock-up unit?");
        }
        if (!version.startsWith("2.") && !version.startsWith("3.")) {
            throw new DataFault("is of FMI " + (version.isEmpty() ? "no version" : version) + "; export it as FMI 2.0 or 3.0");
        }
        model = text("modelName").orElse("");
        token = text("instantiationToken").or(() -> text("guid")).orElse("");
        indicators = (int) number("numberOfEventIndicators").orElse(0);
    }

    private Description.Kind kind() {
        String identifier = text("modelIdentifier").orElse("");
        if (identifier.isEmpty() || identifier.contains("/") || identifier.contains("\\") || identifier.contains("..")) {
            throw new DataFault("its modelIdentifier is no name of a file: '" + identifier + "'");
        }
        return new Description.Kind(identifier, is("canHandleVariableCommunicationStepSize"), number("fixedInternalStepSize"),
                is("canInterpolateInputs"), is("providesDirectionalDerivative") || is("providesDirectionalDerivatives"),
                is("completedIntegratorStepNotNeeded") || text("needsCompletedIntegratorStep").filter("false"::equals).isPresent());
    }

    private Variable variable(String element) {
        Variable.Role role = switch (text("causality").orElse("local")) {
            case "input" -> Variable.Role.INPUT;
            case "output" -> Variable.Role.OUTPUT;
            case "parameter" -> Variable.Role.PARAMETER;
            default -> Variable.Role.OTHER;
        };
        boolean tunable = text("variability").filter("tunable"::equals).isPresent();
        String name = text("name").orElseThrow(() -> new DataFault("a variable of its modelDescription.xml has no name"));
        long reference;
        try {
            reference = Long.parseLong(text("valueReference").orElse(""));
        } catch (NumberFormatException none) {
            throw new DataFault("its variable " + name + " has no valueReference that is a number", none);
        }
        boolean real = TYPES.contains(element) && element.equals("Float64");
        return new Variable(name, (int) reference, role, tunable, real, real ? start() : OptionalDouble.empty(),
                real ? unit() : VariableUnit.NONE);
    }

    /** What stands inside of a variable: in FMI 2.0 its type, in 3.0 the dimensions of an array, which is not touched. */
    private void detail(String element) {
        Variable outer = open.orElseThrow();
        boolean real = element.equals("Real");
        if (real || element.equals("Dimension")) {
            open = Optional.of(new Variable(outer.name(), outer.reference(), outer.role(), outer.tunable(), real,
                    real ? start() : OptionalDouble.empty(), real ? unit() : VariableUnit.NONE));
        }
    }

    private OptionalDouble start() {
        // Of an array several, which is left alone.
        return text("start").filter(value -> !value.strip().contains(" ")).isPresent() ? number("start") : OptionalDouble.empty();
    }

    private VariableUnit unit() {
        String name = text("unit").or(() -> text("declaredType").map(unitOfType::get)).orElse("");
        return units.getOrDefault(name, new VariableUnit(name, 1, 0, Optional.empty()));
    }

    private void unit(String element) {
        if (element.equals("Unit")) {
            named = text("name").orElse("");
        } else if (element.equals("BaseUnit")) {
            Map<String, Integer> exponents = new HashMap<>();
            for (String base : List.of("kg", "m", "s", "A", "K", "mol", "cd")) {
                number(base).ifPresent(exponent -> exponents.put(base, (int) exponent));
            }
            units.put(named, new VariableUnit(named, number("factor").orElse(1), number("offset").orElse(0),
                    Optional.of(VariableUnit.significant(exponents))));
        }
    }

    private boolean inside(String element) {
        return !path.isEmpty() && path.get(path.size() - 1).equals(element);
    }

    private boolean is(String attribute) {
        return text(attribute).map(value -> value.toLowerCase(Locale.ROOT)).filter(value -> value.equals("true") || value.equals("1"))
                .isPresent();
    }

    private OptionalDouble number(String attribute) {
        Optional<String> text = text(attribute);
        if (text.isEmpty()) {
            return OptionalDouble.empty();
        }
        try {
            return OptionalDouble.of(Double.parseDouble(text.get().strip()));
        } catch (NumberFormatException none) {
            throw new DataFault("its modelDescription.xml says " + attribute + "=\"" + text.get() + "\", which is no number", none);
        }
    }

    private Optional<String> text(String attribute) {
        return Optional.ofNullable(xml.getAttributeValue(null, attribute));
    }
}
