#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Writes the files points_* and volume_* of this folder with plain Python, from the descriptions of the formats. The tests
# need only the files, which are committed. Voxel (i, j, k) of 4 x 3 x 2 has the value i + 10 j + 100 k before scaling;
# point r is (r/2, r*r, -r), its normal an axis of the world.
import gzip
import os
import struct
import zlib

FOLDER = os.path.dirname(os.path.abspath(__file__))
DIMS = (4, 3, 2)
VALUES = [i + 10 * j + 100 * k for k in range(2) for j in range(3) for i in range(4)]
POINTS = [(r / 2, float(r * r), float(-r)) for r in range(7)]
NORMALS = [tuple(float(r % 3 == a) for a in range(3)) for r in range(7)]
NAN = float("nan")


def save(name, data):
    with open(os.path.join(FOLDER, name), "wb") as file:
        file.write(data if isinstance(data, bytes) else data.encode())


def numbers(letter, order="<"):
    return struct.pack(f"{order}{len(VALUES)}{letter}", *VALUES)


def nifti(order, code, bits, qform=0, sform=0, quaternion=(0, 0, 0), offset=(0, 0, 0), rows=(0,) * 12, pixdim=(1, 1, 1),
          qfac=1, slope=0, intercept=0, dims=DIMS, vox_offset=352, magic=b"n+1\0"):
    header = bytearray(348)
    dim = [len(dims), *dims] + [1] * (7 - len(dims))
    struct.pack_into(order + "i", header, 0, 348)
    struct.pack_into(order + "8h", header, 40, *dim)
    struct.pack_into(order + "2h", header, 70, code, bits)
    struct.pack_into(order + "8f", header, 76, qfac, *pixdim, 0, 0, 0, 0)
    struct.pack_into(order + "3f", header, 108, vox_offset, slope, intercept)
    struct.pack_into(order + "2h", header, 252, qform, sform)
    struct.pack_into(order + "6f", header, 256, *quaternion, *offset)
    struct.pack_into(order + "12f", header, 280, *rows)
    header[344:348] = magic
    return bytes(header)


def gzipped(data):
    return gzip.compress(data, mtime=0)


def lzf(data):
    """LZF, taking the first repetition of three bytes and more that it finds."""
    out, literals, at, seen = bytearray(), bytearray(), 0, {}

    def flush():
        for first in range(0, len(literals), 32):
            part = literals[first:first + 32]
            out.append(len(part) - 1)
            out.extend(part)
        literals.clear()

    while at < len(data):
        key = data[at:at + 3]
        found = seen.get(key, -1) if len(key) == 3 else -1
        seen[key] = at
        if found < 0 or at - found > 8192:
            literals.append(data[at])
            at += 1
            continue
        n = 3
        while n < 264 and at + n < len(data) and data[found + n] == data[at + n]:
            n += 1
        flush()
        back = at - found - 1
        if n - 2 < 7:
            out += bytes([(n - 2) << 5 | back >> 8, back & 255])
        else:
            out += bytes([7 << 5 | back >> 8, n - 9, back & 255])
        at += n
    flush()
    return bytes(out)


def volumes():
    # A third of a turn about (1, 1, 1), the third axis the other way; no sform.
    save("volume_qform.nii", nifti("<", 2, 8, qform=1, quaternion=(.5, .5, .5), offset=(10, 20, 30), pixdim=(2, 3, 4),
                                   qfac=-1) + bytes(4) + numbers("B"))
    # The sform, with a shear, goes before the qform.
    save("volume_sform_big.nii.gz",
         gzipped(nifti(">", 16, 32, qform=1, sform=2, rows=(2, .5, 0, -10, 0, 3, 0, -20, 0, 0, 4, -30), slope=2,
                       intercept=-5, offset=(1, 2, 3)) + bytes(4) + numbers("f", ">")))
    save("volume_pair.hdr", nifti("<", 4, 16, pixdim=(1, .5, .25), dims=(*DIMS, 1), vox_offset=0, magic=b"ni1\0"))
    save("volume_pair.img", numbers("h"))

    grid = "sizes: 4 3 2\ndimension: 3\n"
    turned = "space: left-posterior-superior\nspace directions: (0,2,0) (-3,0,0) (0,0,4)\nspace origin: (10,20,30)\n"
    save("volume_raw.nrrd", f"NRRD0004\n# a comment\ntype: short\n{grid}{turned}kinds: domain domain domain\n"
         "endian: big\nencoding: raw\na key:=a value: with colon\n\n".encode() + numbers("h", ">"))
    save("volume_gzip.nrrd", f"NRRD0005\r\ntype: double\r\n{grid}{turned}endian: little\r\nencoding: gzip\r\n\r\n".encode()
         + gzipped(numbers("d")))
    save("volume_text.nrrd", "NRRD0001\ntype: int8\ndimension: 3\nsizes: 4 3 2\nspacings: 2 3 4\naxis mins: 9 18.5 28\n"
         "centers: cell cell cell\nencoding: ascii\n\n" + " ".join(map(str, VALUES)) + "\n")
    save("volume_detached.nhdr", "NRRD0004\ntype: uint16\ndimension: 4\nsizes: 1 4 3 2\nspace dimension: 3\n"
         "space directions: none (2,0,0) (0,3,0) (0,0,4)\nspace origin: (10,20,30)\nendian: little\nencoding: raw\n"
         "line skip: 1\nbyte skip: -1\ndata file: ./volume_detached.raw\n")
    save("volume_detached.raw", b"one line\nand some bytes" + numbers("H"))

    meta = "ObjectType = Image\nNDims = 3\nDimSize = 4 3 2\nElementSpacing = 2 3 4\nOffset = 10 20 30\n"
    turned = "TransformMatrix = 0 1 0 -1 0 0 0 0 1\n"
    save("volume_local.mha", f"{meta}{turned}BinaryData = True\nBinaryDataByteOrderMSB = True\nElementType = MET_SHORT\n"
         "ElementDataFile = LOCAL\n".encode() + numbers("h", ">"))
    packed = zlib.compress(numbers("f"))
    save("volume_zlib.mha", f"{meta}CompressedData = True\nCompressedDataSize = {len(packed)}\nElementType = MET_FLOAT\n"
         "ElementDataFile = LOCAL\n".encode() + packed)
    save("volume_text.mhd", f"{meta}BinaryData = False\nElementType = MET_UCHAR\nElementDataFile = volume_text.raw\n"
         .replace("\n", "\r\n"))
    save("volume_text.raw", "\n".join(map(str, VALUES)))


def points():
    rows = [" ".join(f"{x:g}" for x in p + n) for p, n in zip(POINTS, NORMALS)]
    save("points_normals.xyz", "# x y z and a normal\r\n" + rows[0] + "\r\n\r\n" + rows[1] + "  # a remark\r" +
         "\n".join(rows[2:]))
    bare = [" ".join(f"{x:g}" for x in p) for p in POINTS]
    save("points_counted.pts", "7\n" + "\n".join(f"{row} -12 1 2 {i}" for i, row in enumerate(bare)) + "\n")
    save("points_marked.pts", "# made by hand\n" + "\n".join("p " + row for row in bare) + "\n")
    save("points_bytes.txt", "\n".join(f"{row} 255 0 {i}" for i, row in enumerate(bare)))

    def pcd(data, fields, n, letters="F F F F F F U", sizes="4 4 4 4 4 4 4"):
        count = " ".join("1" for _ in fields.split())
        return (f"# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS {fields}\nSIZE {sizes}\nTYPE {letters}\n"
                f"COUNT {count}\nWIDTH {n}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {n}\nDATA {data}\n").encode()

    fields = "x y z normal_x normal_y normal_z rgb"
    full = [p + n + (7,) for p, n in zip(POINTS, NORMALS)]
    full.insert(2, (NAN, NAN, NAN, 0., 0., 1., 9))
    full.append((1., 2., 3., NAN, NAN, NAN, 9))
    save("points_text.pcd", pcd("ascii", "x y z", 8, "F F F", "4 4 4") +
         "\n".join(bare[:3] + ["nan nan nan"] + bare[3:]).encode() + b"\n")
    save("points_binary.pcd", pcd("binary", fields, 9) + b"".join(struct.pack("<6fI", *row) for row in full))
    columns = b"".join(struct.pack(f"<{len(full)}{'f' if c < 6 else 'I'}", *(row[c] for row in full)) for c in range(7))
    packed = lzf(columns)
    save("points_compressed.pcd", pcd("binary_compressed", fields, 9) + struct.pack("<2I", len(packed), len(columns)) +
         packed)
    header = "ply\nformat binary_little_endian 1.0\nelement vertex 7\n" + "".join(
        f"property float {name}\n" for name in ("x", "y", "z", "nx", "ny", "nz")) + "end_header\n"
    save("points_normals.ply", header.encode() + b"".join(struct.pack("<6f", *p, *n) for p, n in zip(POINTS, NORMALS)))


if __name__ == "__main__":
    points()
    volumes()
