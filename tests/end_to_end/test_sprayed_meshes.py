#!/usr/bin/env python3
"""Meshes of all formats give one path; damaged files are told with their line and nothing is written."""
import json
import math
import struct
import unittest

from arelem_run import ArelemCase

HEAD = "UNITS/MM\nG1=GUN/CONE,14,STNDOF,100,FLOW,.2,EFFIC,.6\n"


def half_tube(radius=150, length=300, n=36):
    """Corners and triangles of the upper half of a tube along y, seen from outside."""
    corners = [(radius * math.cos(math.pi * i / n), y, radius * math.sin(math.pi * i / n)) for i in range(n + 1) for y in (0, length)]
    faces = [f for i in range(n) for f in ((2 * i, 2 * i + 1, 2 * i + 3), (2 * i, 2 * i + 3, 2 * i + 2))]
    return corners, faces


def off(corners, faces):
    rows = [f"{len(corners)} {len(faces)} 0", *(" ".join(map(repr, c)) for c in corners), *("3 %d %d %d" % f for f in faces)]
    return ("OFF\n" + "\n".join(rows) + "\n").encode()


def obj(corners, faces):
    rows = ["v " + " ".join(map(repr, c)) for c in corners] + ["f " + " ".join(str(i + 1) for i in f) for f in faces]
    return ("\n".join(rows) + "\n").encode()


def ply(corners, faces):
    head = ("ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty double x\nproperty double y\nproperty double z\n"
            "element face %d\nproperty list uchar int vertex_indices\nend_header\n" % (len(corners), len(faces)))
    return head.encode() + b"".join(struct.pack("<3d", *c) for c in corners) + b"".join(struct.pack("<B3i", 3, *f) for f in faces)


def stl(corners, faces):
    rows = b"".join(struct.pack("<12fH", 0, 0, 0, *corners[f[0]], *corners[f[1]], *corners[f[2]], 0) for f in faces)
    return b"solid".ljust(80) + struct.pack("<I", len(faces)) + rows


class Meshes(ArelemCase):
    def spray(self, format, data, words="SECTN,(PLANE/0,1,0,0)", before=""):
        (self.folder / "a.mesh").write_bytes(data)
        self.write("part.apt", HEAD + before + f"M1=MESH/{format},'a.mesh'\nSPRAY/M1,GUN,G1,FILM,.04,{words}\nFINI\n")
        self.assertExit(0, "spray", "part.apt", "--json")
        return json.loads(self.out)[0]

    def test_formats_agree(self):
        corners, faces = half_tube()
        area = 36 * 2 * 150 * math.sin(math.pi / 72) * 300
        for format, write in (("OFF", off), ("OBJ", obj), ("PLY", ply), ("STL", stl)):
            with self.subTest(format):
                one = self.spray(format, write(corners, faces))
                self.assertAlmostEqual(one["area"], area, delta=area * 1e-6)
                self.assertEqual(one["passes"], 14)  # 300 / 24.93 = 12.03: 13 intervals
                self.assertAlmostEqual(one["Xi"], 14 * math.pi * 150, delta=14)

    def test_radial_sections_and_the_other_side(self):
        corners, faces = half_tube()
        one = self.spray("OFF", off(corners, faces), "RADIAL,(POINT/0,0,0),(VECTOR/0,1,0)")
        self.assertEqual(one["passes"], 20)  # 471.2 / 24.93 = 18.9: 19 intervals
        self.assertAlmostEqual(one["Xi"], 20 * 300, delta=1)
        self.spray("OFF", off(corners, faces), "SECTN,(PLANE/0,1,0,0),REVERS")
        self.assertExit(0, "compile", "part.apt", "-o", "in.lng")
        self.assertExit(0, "verify", "in.lng", "--with", "part.apt")

    def test_refsys_moves_a_mesh(self):
        corners, faces = half_tube()
        self.write("part.apt", HEAD + "MX=MATRIX/TRANSL,1000,0,0\nREFSYS/MX\nM1=MESH/OFF,'a.off'\nREFSYS/NOMORE\n"
                                      "SPRAY/M1,GUN,G1,FILM,.04,SECTN,(PLANE/0,1,0,0)\nFINI\n")
        (self.folder / "a.off").write_bytes(off(corners, faces))
        self.assertExit(0, "compile", "part.apt")
        xs = [float(l.split("/")[1].split(",")[0]) for l in self.out.splitlines() if l.replace(" ", "").startswith("GOTO/")]
        self.assertGreater(min(xs), 740)

    def test_damaged_files_write_nothing(self):
        corners, faces = half_tube()
        for format, data, code in (("OFF", off(corners, faces)[:-9], "E0344"), ("STL", stl(corners, faces)[:-1], "E0344"),
                                   ("PLY", ply(corners, faces)[:-1], "E0344"), ("OBJ", b"v 0 0 0\n", "E0344"),
                                   ("OBJ", b"\x00\xff\x80", "E0344"), ("STL", b"", "E0344")):
            with self.subTest(format + code):
                (self.folder / "a.mesh").write_bytes(data)
                self.write("part.apt", HEAD + f"M1=MESH/{format},'a.mesh'\nSPRAY/M1,GUN,G1,FILM,.04,SECTN,(PLANE/0,1,0,0)\nFINI\n")
                self.assertNotEqual(self.run_arelem("part.apt", "-o", "part.cls"), 0)
                self.assertIn(code, self.err)
                self.assertFalse((self.folder / "part.cls").exists())

    def test_a_mesh_that_bends_too_much(self):
        corners, faces = half_tube(radius=20)
        (self.folder / "a.mesh").write_bytes(off(corners, faces))
        self.write("part.apt", HEAD + "M1=MESH/OFF,'a.mesh'\nSPRAY/M1,GUN,G1,FILM,.04,SECTN,(PLANE/0,1,0,0)\nFINI\n")
        self.assertNotEqual(self.run_arelem("part.apt"), 0)
        self.assertIn("E0379", self.err)


if __name__ == "__main__":
    unittest.main()
