"""Makes the files beside it with other programs than wbv; see README.md. Needs numpy, scipy, pyuff, soundfile, h5py and hdf5storage."""
import os

import h5py
import hdf5storage
import numpy as np
import pyuff
import scipy.io
import scipy.io.wavfile
import soundfile

N, RATE = 120, 60.0
i = np.arange(N)
rng = np.random.default_rng(22)
# Computed, not measured: a sine with noise for each of four channels, on a grid of 2^-12 so that every format but the coarse ones is exact.
grid = lambda x: np.round(x * 4096) / 4096
seat = grid(0.7 * np.sin(0.5 * i) + 0.1 * rng.standard_normal(N)).clip(-0.999, 0.999)
head = grid(0.5 * np.sin(0.5 * i - 1) + 0.1 * rng.standard_normal(N)).clip(-0.999, 0.999)
gyro = grid(0.2 * np.cos(0.3 * i)).clip(-0.999, 0.999)
force = grid(400 + 30 * np.sin(0.5 * i))
np.savetxt("expected.csv", np.column_stack([i / RATE, seat, head, gyro, force]), delimiter=",", fmt="%.17g",
           header="t,seat,head,gyro,force", comments="")


def uff(name, sets, binary):
    if os.path.exists(name):
        os.remove(name)
    file = pyuff.UFF(name)
    for each in sets:
        each["binary"] = int(binary)
        file.write_sets(each, "add")


def signal(data, title, entity, node, direction, kind, unit):
    return pyuff.prepare_58(
        binary=0, id1=title, id2="NONE", id3="NONE", id4="NONE", id5="NONE", func_type=1, ver_num=0, load_case_id=0,
        rsp_ent_name=entity, rsp_node=node, rsp_dir=direction, ref_ent_name="NONE", ref_node=0, ref_dir=0,
        data=data, x=i / RATE, num_pts=N, abscissa_spacing=1, abscissa_min=0.0, abscissa_inc=1 / RATE, z_axis_value=0.0,
        abscissa_spec_data_type=17, ordinate_spec_data_type=kind, ordinate_axis_units_lab=unit, abscissa_axis_units_lab="s",
        orddenom_spec_data_type=0, z_axis_spec_data_type=0)


four = lambda: [signal(seat, "NONE", "seat", 1, 3, 12, "m/s^2"), signal(head / 9.80665, "NONE", "head", 2, -3, 12, "g"),
                signal(gyro, "NONE", "head", 2, 5, 11, "rad/s"), signal(force, "NONE", "seat", 1, 3, 13, "N")]
spectrum = signal(seat, "NONE", "seat", 1, 3, 12, "m/s^2")
spectrum.update(func_type=2, abscissa_spec_data_type=18)
uff("pyuff-ascii.uff", four() + [spectrum], False)
uff("pyuff-binary.uff", four() + [spectrum], True)
uneven = [signal(seat, "NONE", "seat", 1, 3, 12, "m/s^2"), signal(head, "NONE", "head", 2, 3, 12, "m/s^2")]
for each in uneven:
    each.update(abscissa_spacing=0, x=i / RATE + 0.25)
uff("pyuff-uneven.uff", uneven, False)
# pyuff leaves the abscissa out of binary datasets: these bytes stand here as the standard has them, big-endian, abscissa in single precision.
text = open("pyuff-uneven.uff", "rb").read().split(b"\n")
pairs = np.zeros(N, dtype=[("x", ">f4"), ("y", ">f8")])
pairs["x"], pairs["y"] = i / 64 + 0.25, seat
with open("struct-uneven.uff", "wb") as file:
    id_line = b"    58b%6d%6d%12d%12d%6d%6d%12d%12d" % (2, 2, 11, pairs.nbytes, 0, 0, 0, 0)
    file.write(b"\n".join([b"    -1", id_line] + text[2:13]) + b"\n" + pairs.tobytes() + b"\n    -1\n")
millimetres = pyuff.prepare_164(units_code=5, units_description="mm (milli-newton)", temp_mode=1, length=1000.0, force=1000.0, temp=1.0,
                                temp_offset=273.15)
uff("pyuff-millimetres.uff", [millimetres, signal(1000 * seat, "NONE", "NONE", 7, 1, 12, "NONE"), signal(1000 * force, "NONE", "NONE", 7, 1, 13, "NONE")], False)
uff("pyuff-no-direction.uff", [signal(seat, "Seat pad", "seat", 1, 0, 12, "m/s^2")], False)
uff("pyuff-no-unit.uff", [signal(seat, "NONE", "seat", 1, 3, 12, "NONE")], False)

named = {"t": (i / RATE)[:, None], "seat_acc_z": seat[:, None], "head_acc_z": head[None, :], "head_gyr_y": gyro.astype("f4")[:, None], "comment": "computed"}
scipy.io.savemat("scipy-5.mat", named)
scipy.io.savemat("scipy-7.mat", named, do_compression=True)
scipy.io.savemat("scipy-struct.mat", {"ride": {"acc": np.column_stack([seat, head]), "info": "computed"}, "fs": RATE}, do_compression=True)
hdf5storage.savemat("hdf5storage-73.mat", {"fs": RATE, "acc": np.column_stack([seat, head]), "head_gyr_y": gyro[:, None], "comment": "computed"},
                    format="7.3", matlab_compatible=True, compress=True, compress_size_threshold=0)
with h5py.File("h5py.h5", "w") as file:
    group = file.create_group("ride")
    group.create_dataset("seat.acc.z", data=seat / 9.80665).attrs["unit"] = "g"
    group.create_dataset("head.acc.z", data=head, compression="gzip", shuffle=True, chunks=(50,))
    group.create_dataset("pads", data=np.column_stack([seat, head]), compression="lzf", chunks=(50, 2))
    file["fs"] = RATE

two = np.column_stack([seat, head])
scipy.io.wavfile.write("scipy-16.wav", 60, np.round(two * 32768).astype("i2"))
scipy.io.wavfile.write("scipy-32.wav", 60, np.round(two * 2147483648).astype("i4"))
scipy.io.wavfile.write("scipy-float.wav", 60, two.astype("f4"))
scipy.io.wavfile.write("scipy-double.wav", 60, two)
soundfile.write("soundfile-24.wav", two, 60, subtype="PCM_24")
soundfile.write("soundfile-8.wav", two, 60, subtype="PCM_U8")
soundfile.write("soundfile-extensible-24.wav", two, 60, subtype="PCM_24", format="WAVEX")
soundfile.write("soundfile-rf64.wav", two, 60, subtype="FLOAT", format="RF64")
