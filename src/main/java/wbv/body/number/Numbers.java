package wbv.body.number;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** The numbers of a law, a drive or a sensor fault, by their JSON keys, in the order of the record's components. */
public final class Numbers {

    private Numbers() {}

    /** Keys of the numeric components, such as {@code knee_m}. */
    public static List<String> keys(Class<?> type) {
        List<String> keys = new ArrayList<>();
        for (RecordComponent component : type.getRecordComponents()) {
            if (component.getType() == double.class) {
                keys.add(component.getAnnotation(Key.class).value());
            }
        }
        return keys;
    }

    /** The numeric components of a record, by component, each in its own unit. */
    public static double[] values(Record record) {
        return java.util.Arrays.stream(record.getClass().getRecordComponents()).filter(c -> c.getType() == double.class)
                .mapToDouble(c -> (Double) read(record, c)).toArray();
    }

    /** What of a record no number tells but a choice does, by its JSON key, in the words of the file: such as on which side a stop is. */
    public static Map<String, String> choices(Record record) {
        Map<String, String> out = new LinkedHashMap<>();
        for (RecordComponent component : record.getClass().getRecordComponents()) {
            if (component.getType().isEnum()) {
                out.put(component.getAnnotation(Key.class).value(), read(record, component).toString().toLowerCase(Locale.ROOT));
            }
        }
        return out;
    }

    /**
     * The same record with other numbers.
     *
     * @param values one for each numeric component, in its own unit. Not modified.
     */
    public static <T extends Record> T with(T record, double[] values) {
        RecordComponent[] components = record.getClass().getRecordComponents();
        Class<?>[] types = new Class<?>[components.length];
        Object[] arguments = new Object[components.length];
        int next = 0;
        for (int i = 0; i < components.length; i++) {
            types[i] = components[i].getType();
            arguments[i] = types[i] == double.class ? values[next++] : read(record, components[i]);
        }
        @SuppressWarnings("unchecked")
        Class<T> type = (Class<T>) record.getClass();
        return create(type, types, arguments);
    }

    /**
     * A record from arguments in the order of its components. What it refuses, it refuses with its own {@link IllegalArgumentException}.
     * Arrays are not modified.
     */
    public static <T> T create(Class<T> type, Class<?>[] types, Object[] arguments) {
        try {
            Constructor<T> constructor = type.getDeclaredConstructor(types);
            return constructor.newInstance(arguments);
        } catch (InvocationTargetException e) {
            if (e.getCause() instanceof IllegalArgumentException refused) {
                throw refused;
            }
            throw new IllegalStateException(e);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    /** The value of a component. */
    public static Object read(Record record, RecordComponent component) {
        try {
            return component.getAccessor().invoke(record);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }
}
