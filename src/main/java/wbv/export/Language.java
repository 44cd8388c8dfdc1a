package wbv.export;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** How arithmetic is written where a model goes. */
enum Language {
    PYTHON(Map.ofEntries(Map.entry("abs", "abs(%s)"), Map.entry("min", "min(%s, %s)"), Map.entry("max", "max(%s, %s)"),
            Map.entry("exp", "math.exp(%s)"), Map.entry("expm1", "math.expm1(%s)"), Map.entry("log1p", "math.log1p(%s)"),
            Map.entry("sqrt", "math.sqrt(%s)"), Map.entry("pow", "math.pow(%s, %s)"), Map.entry("sin", "math.sin(%s)"),
            Map.entry("cos", "math.cos(%s)"), Map.entry("tanh", "math.tanh(%s)"), Map.entry("pi", "math.pi"))),
    C(Map.ofEntries(Map.entry("abs", "fabs(%s)"), Map.entry("min", "fmin(%s, %s)"), Map.entry("max", "fmax(%s, %s)"),
            Map.entry("exp", "exp(%s)"), Map.entry("expm1", "expm1(%s)"), Map.entry("log1p", "log1p(%s)"), Map.entry("sqrt", "sqrt(%s)"),
            Map.entry("pow", "pow(%s, %s)"), Map.entry("sin", "sin(%s)"), Map.entry("cos", "cos(%s)"), Map.entry("tanh", "tanh(%s)"),
            Map.entry("pi", "PI"))),
    MODELICA(Map.ofEntries(Map.entry("abs", "abs(%s)"), Map.entry("min", "min(%s, %s)"), Map.entry("max", "max(%s, %s)"),
            Map.entry("exp", "exp(%s)"), Map.entry("expm1", "(exp(%s) - 1)"), Map.entry("log1p", "log(1 + %s)"),
            Map.entry("sqrt", "sqrt(%s)"),
            Map.entry("pow", "(%s) ^ (%s)"), Map.entry("sin", "sin(%s)"), Map.entry("cos", "cos(%s)"), Map.entry("tanh", "tanh(%s)"),
            Map.entry("pi", "3.141592653589793")));

    /** Ranks, the loosest first. */
    private static final List<String> RANKS = List.of("?", "<>", "+-", "*/");
    private static final int TIGHT = RANKS.size();

    private final Map<String, String> functions;

    Language(Map<String, String> functions) {
        this.functions = functions;
    }

    /** The expression with its names as they are. */
    String of(Expression expression) {
        return of(expression, 0);
    }

    /** @param rank of what stands around it: what is looser gets parentheses */
    private String of(Expression expression, int rank) {
        if (expression instanceof Expression.Numeral numeral) {
            return numeral.text();
        }
        if (expression instanceof Expression.Name name) {
            return name.text().equals("pi") ? functions.get("pi") : name.text();
        }
        if (expression instanceof Expression.Negative negative) {
            // Modelica has a sign at the beginning of a sum alone.
            return within("-" + of(negative.of(), TIGHT), this == MODELICA ? 2 : 3, rank);
        }
        if (expression instanceof Expression.Binary binary) {
            int own = rankOf(binary.operator());
            return within(of(binary.left(), own) + " " + binary.operator() + " " + of(binary.right(), own + 1), own, rank);
        }
        if (expression instanceof Expression.Choice choice) {
            String condition = of(choice.condition(), 1);
            String then = of(choice.then(), 1);
            String otherwise = of(choice.otherwise(), 0);
            return within(switch (this) {
                case PYTHON -> then + " if " + condition + " else " + otherwise;
                case C -> condition + " ? " + then + " : " + otherwise;
                case MODELICA -> "if " + condition + " then " + then + " else " + otherwise;
            }, 0, rank);
        }
        Expression.Call call = (Expression.Call) expression;
        String form = functions.get(call.function());
        if (form == null) {
            throw new IllegalArgumentException("no language has the function " + call.function());
        }
        return String.format(form, call.arguments().stream().map(each -> of(each, 0)).collect(Collectors.toList()).toArray());
    }

    private static int rankOf(char operator) {
        for (int rank = 0; rank < TIGHT; rank++) {
            if (RANKS.get(rank).indexOf(operator) >= 0) {
                return rank;
            }
        }
        throw new IllegalArgumentException("no operator: " + operator);
    }

    private static String within(String text, int own, int rank) {
        return own < rank ? "(" + text + ")" : text;
    }
}
