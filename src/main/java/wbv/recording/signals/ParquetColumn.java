package wbv.recording.signals;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Instant;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.function.ToLongFunction;
import org.apache.parquet.column.ColumnDescriptor;
import org.apache.parquet.column.ColumnReader;
import org.apache.parquet.schema.LogicalTypeAnnotation;
import org.apache.parquet.schema.LogicalTypeAnnotation.DecimalLogicalTypeAnnotation;
import org.apache.parquet.schema.LogicalTypeAnnotation.IntLogicalTypeAnnotation;
import org.apache.parquet.schema.LogicalTypeAnnotation.TimestampLogicalTypeAnnotation;
import org.apache.parquet.schema.PrimitiveType;
import org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName;
import wbv.recording.CalendarTime;

/**
 * A column of numbers, one a row. Timestamps, of milli-, micro- or nanoseconds and the old ones of 96 bits, are seconds from the first of
 * them, since a double of 1970's seconds has no room for nanoseconds.
 */
final class ParquetColumn {

    /** Of the days that begin at midnight, the one on which 1970 began; Julian. */
    private static final long EPOCH_DAY = 2_440_588;
    private static final long NANOSECONDS = 1_000_000_000;

    private final ColumnDescriptor descriptor;
    private final String name;
    private final Optional<Ticks> ticks;
    private final ToDoubleFunction<ColumnReader> number;
    private Optional<ColumnReader> values = Optional.empty();
    private long origin;
    private boolean begun;

    /**
     * @param perSecond ticks in a second
     * @param utc whether they count in UTC and not on some clock on a wall
     */
    private record Ticks(ToLongFunction<ColumnReader> value, long perSecond, boolean utc) {}

    private ParquetColumn(ColumnDescriptor descriptor, String name, Optional<Ticks> ticks, ToDoubleFunction<ColumnReader> number) {
        this.descriptor = descriptor;
        this.name = name;
        this.ticks = ticks;
        this.number = ticks.<ToDoubleFunction<ColumnReader>>map(clock -> reader -> seconds(clock.value.applyAsLong(reader), clock))
                .orElse(number);
    }

    /**
     * The column, where it holds one number or timestamp a row.
     *
     * @param name by which it is known
     */
    static Optional<ParquetColumn> of(ColumnDescriptor descriptor, String name) {
        if (descriptor.getMaxRepetitionLevel() > 0) {
            return Optional.empty();
        }
        Optional<Ticks> ticks = ticks(descriptor.getPrimitiveType());
        Optional<ToDoubleFunction<ColumnReader>> number = ticks.isPresent() ? Optional.of(reader -> Double.NaN)
                : number(descriptor.getPrimitiveType());
        return number.map(found -> new ParquetColumn(descriptor, name, ticks, found));
    }

    private static Optional<Ticks> ticks(PrimitiveType type) {
        if (type.getPrimitiveTypeName() == PrimitiveTypeName.INT96) {
            return Optional.of(new Ticks(ParquetColumn::nanoseconds, NANOSECONDS, false));
        }
        return logical(type).filter(TimestampLogicalTypeAnnotation.class::isInstance).map(TimestampLogicalTypeAnnotation.class::cast)
                .map(stamp -> new Ticks(ColumnReader::getLong, switch (stamp.getUnit()) {
                    case MILLIS -> 1_000;
                    case MICROS -> 1_000_000;
                    case NANOS -> NANOSECONDS;
                }, stamp.isAdjustedToUTC()));
    }

    /** Of a timestamp of 96 bits: the day's nanoseconds, then its Julian number. */
    private static long nanoseconds(ColumnReader reader) {
        ByteBuffer bytes = reader.getBinary().toByteBuffer().order(ByteOrder.LITTLE_ENDIAN);
        return bytes.getLong() + (bytes.getInt() - EPOCH_DAY) * 86_400 * NANOSECONDS;
    }

    private static Optional<ToDoubleFunction<ColumnReader>> number(PrimitiveType type) {
        Optional<LogicalTypeAnnotation> logical = logical(type);
        boolean whole = logical.isEmpty() || logical.get() instanceof IntLogicalTypeAnnotation;
        boolean unsigned = logical.isPresent() && logical.get() instanceof IntLogicalTypeAnnotation kind && !kind.isSigned();
        boolean decimal = logical.isPresent() && logical.get() instanceof DecimalLogicalTypeAnnotation;
        double divisor = decimal ? Math.pow(10, ((DecimalLogicalTypeAnnotation) logical.get()).getScale()) : 1;
        return switch (type.getPrimitiveTypeName()) {
            case DOUBLE -> Optional.of(ColumnReader::getDouble);
            case FLOAT -> Optional.of(ColumnReader::getFloat);
            case INT32 -> !whole && !decimal ? Optional.empty()
                    : Optional.of(reader -> (unsigned ? Integer.toUnsignedLong(reader.getInteger()) : reader.getInteger()) / divisor);
            case INT64 -> !whole && !decimal ? Optional.empty()
                    : Optional.of(reader -> (unsigned ? unsigned(reader.getLong()) : reader.getLong()) / divisor);
            default -> Optional.empty();
        };
    }

    private static double unsigned(long bits) {
        return bits >= 0 ? bits : 2.0 * (bits >>> 1 | bits & 1); // the last bit kept, by which halves are rounded
    }

    private static Optional<LogicalTypeAnnotation> logical(PrimitiveType type) {
        return Optional.ofNullable(type.getLogicalTypeAnnotation());
    }

    private double seconds(long now, Ticks clock) {
        if (!begun) {
            origin = now;
            begun = true;
        }
        return (now - origin) / (double) clock.perSecond;
    }

    /** What the first timestamp was; empty before it was read, and of numbers. */
    Optional<CalendarTime> origin() {
        return ticks.filter(clock -> begun).map(clock -> new CalendarTime(origin / (double) clock.perSecond, clock.utc));
    }

    ColumnDescriptor descriptor() {
        return descriptor;
    }

    String name() {
        return name;
    }

    boolean isTimestamp() {
        return ticks.isPresent();
    }

    /** Goes on with the values of the next group of rows. */
    void enter(ColumnReader next) {
        values = Optional.of(next);
    }

    /** The next value; NaN where it is null. */
    double next() {
        ColumnReader reader = values.orElseThrow();
        double value = isNull(reader) ? Double.NaN : number.applyAsDouble(reader);
        reader.consume();
        return value;
    }

    private boolean isNull(ColumnReader reader) {
        return reader.getCurrentDefinitionLevel() < descriptor.getMaxDefinitionLevel();
    }

    /** The date and time of the next value, as ISO 8601 writes them, where it is a timestamp and not null. */
    Optional<String> date() {
        ColumnReader reader = values.orElseThrow();
        return ticks.filter(clock -> !isNull(reader)).map(clock -> {
            long now = clock.value.applyAsLong(reader);
            String date = Instant.ofEpochSecond(Math.floorDiv(now, clock.perSecond),
                    Math.floorMod(now, clock.perSecond) * (NANOSECONDS / clock.perSecond)).toString();
            return clock.utc ? date : date.substring(0, date.length() - 1);
        });
    }
}
