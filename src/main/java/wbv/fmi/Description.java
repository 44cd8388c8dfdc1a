package wbv.fmi;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * What a unit says of itself: the part of its {@code modelDescription.xml} that a simulation needs.
 *
 * @param version         2 or 3
 * @param model           name of the model
 * @param token           that it was compiled with (its GUID)
 * @param coSimulation    how it steps itself, where it does
 * @param modelExchange   how it gives derivatives, where it does
 * @param variables       scalar variables in their order
 * @param states          number of derivatives of continuous states that are declared
 * @param eventIndicators number that is declared
 * @param step            of the default experiment [s], where one is declared
 * @param logCategories   of which its messages are
 */
public record Description(int version, String model, String token, Optional<Kind> coSimulation, Optional<Kind> modelExchange,
        List<Variable> variables, int states, int eventIndicators, OptionalDouble step, List<String> logCategories) {

    /**
     * One of the ways to run it.
     *
     * @param identifier    name of the binary, without its ending
     * @param variableStep  whether steps of any length can be asked for
     * @param fixedStep     its own step [s], where it has one that never changes
     * @param interpolates  whether it takes derivatives of inputs
     * @param directional   whether it gives directional derivatives
     * @param silentSteps   whether it need not hear of completed integrator steps
     */
    public record Kind(String identifier, boolean variableStep, OptionalDouble fixedStep, boolean interpolates, boolean directional,
            boolean silentSteps) {}

    public Description {
        variables = List.copyOf(variables);
        logCategories = List.copyOf(logCategories);
    }

    /** Its variables of a role that are numbers. */
    public List<Variable> reals(Variable.Role role) {
        return variables.stream().filter(each -> each.real() && each.role() == role).toList();
    }

    /** Parameters that may be wrong. */
    public List<Variable> tunable() {
        return reals(Variable.Role.PARAMETER).stream().filter(Variable::tunable).toList();
    }

    /** Of its log categories those that tell of errors and warnings. */
    String[] errorCategories() {
        return logCategories.stream().filter(category -> category.toLowerCase(Locale.ROOT).matches(".*(error|fatal|warning).*"))
                .toArray(String[]::new);
    }
}
