"""Makes the Parquet files beside it from expected.csv with other programs than wbv; see README.md. Needs numpy, pandas, polars and pyarrow."""
import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pyarrow.parquet as pq

RATE = 60
truth = pd.read_csv("expected.csv")
n, t, seat, head, gyro = len(truth), *(truth[name].to_numpy() for name in ("t", "seat", "head", "gyro"))
lost = np.where(np.isin(np.arange(n), (7, 8)), np.nan, head)  # one null and one NaN: both are lost samples
arrow_lost = pa.array([None if i == 7 else value for i, value in enumerate(lost)], pa.float64())
nanoseconds = np.round(np.arange(n) * 1e9 / RATE).astype("i8") + 1_790_000_000_123_456_789
words = pa.array(["computed"] * n)

# Times [s], doubles and floats, a unit by the footer, several groups of rows, columns that are no numbers.
table = pa.table({"t": t, "seat.acc.z": seat / 9.80665, "head.acc.z": arrow_lost, "head.gyr.y": gyro.astype("f4"), "remark": words,
                  "even": pa.array(np.arange(n) % 2 == 0)})
table = table.replace_schema_metadata({"units": '{"seat.acc.z": "g"}', "rate_hz": "60"})
pq.write_table(table, "pyarrow-none.parquet", compression="none", row_group_size=50)
# What pandas writes by itself: Snappy, the index as a column without a name, attributes of the frame.
frame = pd.DataFrame({"head_acc_z": lost, "seat_acc_z": seat / 9.80665}, index=pd.DatetimeIndex(nanoseconds, tz="UTC"))
frame.attrs = {"rate_hz": RATE, "units": {"seat_acc_z": "g"}}
frame.to_parquet("pandas-snappy.parquet")
# What polars writes by itself: Zstandard; microseconds on a clock on the wall, a struct, a list.
pl.DataFrame({"when": pl.Series(nanoseconds // 1000).cast(pl.Datetime("us")), "head": [{"acc": {"z": value}} for value in lost], "seat.acc.z": seat,
              "pads": [[1.0, 2.0]] * n}).write_parquet("polars-zstd.parquet")
# A rate and no times; whole numbers of all widths; the newer encodings, pages of the second version.
counts = np.round(seat * 4096).astype("i8")
pq.write_table(pa.table({"a16": counts.astype("i2"), "a64": counts, "u8": np.arange(n, dtype="u1") + 100, "u32": np.arange(n, dtype="u4") + 4_000_000_000,
                         "u64": np.arange(n, dtype="u8") + (1 << 63), "seat.acc.z": seat, "cents": pa.array(np.arange(n), pa.int16()).cast(pa.decimal128(12, 2))},
                        metadata={"sampling rate": "60 Hz"}), "pyarrow-gzip.parquet", compression="gzip", use_dictionary=False, data_page_version="2.0",
               store_decimal_as_integer=True, column_encoding={"a64": "DELTA_BINARY_PACKED", "a16": "DELTA_BINARY_PACKED", "seat.acc.z": "BYTE_STREAM_SPLIT"})
# The timestamps of 96 bits that Spark and Impala wrote, and those of milliseconds; LZ4.
stamps = {"when": pa.array(nanoseconds, pa.timestamp("ns")), "seat.acc.z": seat}
pq.write_table(pa.table(stamps), "pyarrow-lz4-int96.parquet", compression="lz4", use_deprecated_int96_timestamps=True)
pq.write_table(pa.table(stamps), "pyarrow-milliseconds.parquet", coerce_timestamps="ms", allow_truncated_timestamps=True)
# Half a second later, at another place, on a clock of milliseconds: to be joined with polars-zstd.parquet.
pq.write_table(pa.table({"when": pa.array(nanoseconds[30:] // 1_000_000, pa.timestamp("ms")), "sternum.acc.z": seat[30:]}), "pyarrow-later.parquet")
# What is refused.
pq.write_table(pa.table({"t": t, "head.acc.z": head}), "pyarrow-brotli.parquet", compression="brotli")
pq.write_table(pa.table({"when": stamps["when"], "pads": pa.array([[1.0, 2.0]] * n), "remark": words}), "pyarrow-nested.parquet")
