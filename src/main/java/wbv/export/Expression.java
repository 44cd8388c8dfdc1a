package wbv.export;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.UnaryOperator;

/** A piece of arithmetic that every language can say. */
sealed interface Expression {

    /** As written. */
    record Numeral(String text) implements Expression {}

    record Name(String text) implements Expression {}

    record Negative(Expression of) implements Expression {}

    /** @param operator one of {@code + - * / < >} */
    record Binary(char operator, Expression left, Expression right) implements Expression {}

    /** A function of the {@link Language}s. */
    record Call(String function, List<Expression> arguments) implements Expression {
        public Call {
            arguments = List.copyOf(arguments);
        }
    }

    record Choice(Expression condition, Expression then, Expression otherwise) implements Expression {}

    /** The names that it asks for, in order. */
    default Set<String> names() {
        Set<String> out = new TreeSet<>();
        collect(out);
        return out;
    }

    private void collect(Set<String> out) {
        if (this instanceof Name name) {
            out.add(name.text());
        } else if (this instanceof Negative negative) {
            negative.of().collect(out);
        } else if (this instanceof Binary binary) {
            binary.left().collect(out);
            binary.right().collect(out);
        } else if (this instanceof Call call) {
            call.arguments().forEach(each -> each.collect(out));
        } else if (this instanceof Choice choice) {
            choice.condition().collect(out);
            choice.then().collect(out);
            choice.otherwise().collect(out);
        }
    }

    /** The same of other names. */
    default Expression renamed(UnaryOperator<String> other) {
        if (this instanceof Name name) {
            return new Name(other.apply(name.text()));
        }
        if (this instanceof Negative negative) {
            return new Negative(negative.of().renamed(other));
        }
        if (this instanceof Binary binary) {
            return new Binary(binary.operator(), binary.left().renamed(other), binary.right().renamed(other));
        }
        if (this instanceof Call call) {
            return new Call(call.function(), call.arguments().stream().map(each -> each.renamed(other)).toList());
        }
        return this instanceof Choice choice
                ? new Choice(choice.condition().renamed(other), choice.then().renamed(other), choice.otherwise().renamed(other)) : this;
    }

    /**
     * Reads {@code x < 0 ? -k * x : exp(x)}.
     *
     * @throws IllegalArgumentException where it cannot be read
     */
    static Expression parse(String text) {
        Reader reader = new Reader(text);
        Expression out = reader.choice();
        reader.end();
        return out;
    }

    /** One text, from left to right. */
    final class Reader {
        private final String text;
        private int at;

        private Reader(String text) {
            this.text = text;
        }

        private Expression choice() {
            Expression condition = chain("<>", 0);
            if (!take("?")) {
                return condition;
            }
            Expression then = choice();
            require(":");
            return new Choice(condition, then, choice());
        }

        /** Operators of one rank, from left to right. */
        private Expression chain(String operators, int rank) {
            Expression left = rank == 2 ? factor() : chain(rank == 0 ? "+-" : "*/", rank + 1);
            while (true) {
                skip();
                if (at == text.length() || operators.indexOf(text.charAt(at)) < 0) {
                    return left;
                }
                char operator = text.charAt(at++);
                left = new Binary(operator, left, rank == 2 ? factor() : chain(rank == 0 ? "+-" : "*/", rank + 1));
            }
        }

        private Expression factor() {
            if (take("-")) {
                return new Negative(factor());
            }
            if (take("(")) {
                Expression inside = choice();
                require(")");
                return inside;
            }
            String word = word();
            if (Character.isDigit(word.charAt(0))) {
                return new Numeral(word);
            }
            if (!take("(")) {
                return new Name(word);
            }
            List<Expression> arguments = new ArrayList<>(List.of(choice()));
            while (take(",")) {
                arguments.add(choice());
            }
            require(")");
            return new Call(word, arguments);
        }

        private String word() {
            skip();
            int from = at;
            while (at < text.length() && (Character.isLetterOrDigit(text.charAt(at)) || "_.".indexOf(text.charAt(at)) >= 0
                    || text.charAt(at) == '-' && at > from && text.charAt(at - 1) == 'e' && Character.isDigit(text.charAt(from)))) {
                at++;
            }
            if (from == at) {
                throw wrong("a number or a name");
            }
            return text.substring(from, at);
        }

        private boolean take(String sign) {
            skip();
            boolean there = text.startsWith(sign, at);
            at += there ? sign.length() : 0;
            return there;
        }

        private void require(String sign) {
            if (!take(sign)) {
                throw wrong("'" + sign + "'");
            }
        }

        private void end() {
            skip();
            if (at < text.length()) {
                throw wrong("the end");
            }
        }

        private void skip() {
            while (at < text.length() && text.charAt(at) == ' ') {
                at++;
            }
        }

        private IllegalArgumentException wrong(String wanted) {
            return new IllegalArgumentException(wanted + " should stand at " + at + " of '" + text + "'");
        }
    }
}
