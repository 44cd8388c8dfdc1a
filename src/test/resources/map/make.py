"""Makes the tables beside it, in the layouts of several programs, of the simulated ride that ships with wbv; see README.md. python3 make.py RIDE.csv"""
import csv
import math
import sys

G = 9.80665
rows = [row for row in csv.DictReader(line for line in open(sys.argv[1]) if not line.startswith("#"))][3000:3400]
for before, row in zip(rows, rows[1:]):
    row.update({name: before[name] for name in row if not row[name]})  # of a lost packet, the last values
value = lambda row, name: float(row[name])
acc = lambda row, place, gravity=0.0: [value(row, f"{place}.acc.x"), value(row, f"{place}.acc.y"), value(row, f"{place}.acc.z") + gravity]
gyr = lambda row, place: [value(row, f"{place}.gyr.{axis}") for axis in "xyz"]

with open("phyphox.csv", "w") as file:
    file.write('"Time (s)","Acceleration x (m/s^2)","Acceleration y (m/s^2)","Acceleration z (m/s^2)","Absolute acceleration (m/s^2)"\n')
    for i, row in enumerate(rows):
        a = acc(row, "seat", G)
        file.write(",".join(f"{x:.9E}" for x in [i / 60, *a, math.dist(a, (0, 0, 0))]) + "\n")
with open("arduino.csv", "w") as file:
    file.write("t_ms,ax,ay,az,gx,gy,gz\n")
    for i, row in enumerate(rows):
        file.write(",".join(str(round(x)) for x in [5000 + i * 1000 / 60] + [16384 / G * a for a in acc(row, "seat", G)]
                            + [131 * math.degrees(w) for w in gyr(row, "seat")]) + "\n")
with open("dewesoft.txt", "w", encoding="utf-8") as file:
    file.write("Data file: ride.dxd\nStart time: 02/11/2026 10:00:00\nSample rate: 60 Hz\nPost trigger: off\n\n")
    file.write("Time\tSeat X\tSeat Y\tSeat Z\tFloor Z\ns\tm/s²\tm/s²\tm/s²\tg\n")
    for i, row in enumerate(rows):
        file.write("\t".join(f"{x:.6f}".replace(".", ",") for x in [i / 60, *acc(row, "seat"), acc(row, "platform")[2] / G]) + "\n")
with open("pulse.txt", "w", encoding="utf-8") as file:
    file.write("Header Size\t7\nTitle\tTime(Seat)\nSampling Frequency [Hz]\t60\nX-axis unit\ts\nY-axis unit\tm/s²\nData points\t400\n")
    file.write("Index\tTime [s]\tSeat pad Z [m/s²]\n")
    for i, row in enumerate(rows):
        file.write(f"{i}\t{i / 60:.9f}\t{acc(row, 'seat')[2]:.6e}\n")
with open("bare.csv", "w") as file:
    file.write("ax;ay;az\n")
    for row in rows:
        file.write(";".join(f"{x:.4f}" for x in acc(row, "seat")) + "\n")
