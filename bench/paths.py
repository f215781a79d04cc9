"""Passes of every kind of cutter over every kind of surface: cut vectors per second, and how both grow."""
import math
import pathlib
import struct


def polyconic(radius=100.0, half=0.8, growth=-0.1):
    """An arch over y, of arcs of `half` radians to both sides of the top, that grows along y from -45 to 45: z = 30 at the first top."""
    sine, cosine = math.sin(half), math.cos(half)
    fall, share = radius * sine * sine / cosine, cosine / (1 + cosine)
    rows = [[k, growth * k] for k in (-radius * sine, fall, -radius * sine, -fall, radius * sine)]
    rows += [[30 + radius * (cosine - 1), growth * radius * (cosine - 1)], [0.5 * (1 + share), 0.02]]
    values = [1, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, -45, 90]
    values += [k for row in rows for k in row + [0] * 6] + [0] * 7
    return "POLCON/CANON," + ",$\n".join(f"{k:.12g}" for k in values)


# Part surfaces under the tool; the passes run along x in planes of constant y between -width and width.
SURFACES = {
    "plane": ("PLANE/.1,.2,1,0", 40),
    "cylinder": ("CYLNDR/0,0,-60,0,1,0,80", 40),
    "cone": ("CONE/(POINT/0,-300,-60),(VECTOR/0,1,0),15", 40),
    "sphere": ("SPHERE/0,0,-60,80", 40),
    "torus": ("TORUS/0,0,-100,0,1,0,100,30", 15),
    "general quadric": ("QADRIC/0.0002,0.0003,0.00025,0,0,0,0,0,0,-1", 40),
    "tabulated cylinder": ("TABCYL/NOY,SPLINE,2,-70,9,-45,12,-20,8,5,5,25,11,50,13,75", 40),
    "ruled surface": ("RLDSRF/CA,(POINT/-60,-45,0),(POINT/60,-45,0),(POINT/0,-45,30),$\n"
                      "CB,(POINT/-60,45,0),(POINT/60,45,0),(POINT/0,45,20)", 40),
    "polyconic": (polyconic(), 40),
    "mesh of 200 000 triangles": ("MESH/STL,'wavy.stl'", 40),
}
BEFORE = {"ruled surface": "CA=CYLNDR/0,0,-70,0,1,0,100\nCB=CYLNDR/0,0,-80,0,1,0,100\n"}
CUTTERS = {
    "ball": "12,6",
    "flat": "12,0",
    "bull-nose": "12,1.5",
    "tapered": f"12,1.5,{6 - 1.5 * (1 - math.sin(math.radians(10))) / math.cos(math.radians(10)):.9f},1.5,0,10,20",
}
# On a plane the passes run along leaning cylinders: along planes each would be one cut vector.
DRIVES = {"plane": "(CYLNDR/0,-400,0,0,.1,1,(400+Y))"}
PASSES = (300, 3000)  # growth: ten times the passes, ten times the cut vectors; 200 000 to 450 000 of them, so that start-up is little
FEW = {"mesh of 200 000 triangles": (100, 1000), "ruled surface": (100, 1000), "polyconic": (3, 30), "tabulated cylinder": (100, 1000)}
MESH_SIDE = 316  # 316 * 316 * 2 triangles


def wavy_mesh(path, side=MESH_SIDE):
    """A waved square of 100 by 100, as binary STL."""
    xs = [-50 + 100 * i / side for i in range(side + 1)]
    z = [[6 * math.sin(0.06 * x) * math.cos(0.05 * y) - 8 for y in xs] for x in xs]
    with path.open("wb") as file:
        file.write(bytes(80) + struct.pack("<I", 2 * side * side))
        for i in range(side):
            for j in range(side):
                square = [(xs[a], xs[b], z[a][b]) for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))]
                for corners in ((0, 1, 2), (0, 2, 3)):
                    values = [v for k in corners for v in square[k]]
                    file.write(struct.pack("<12fH", 0, 0, 0, *values, 0))


def program(surface, cutter, passes, tolerance=.0005):
    definition, width = SURFACES[surface]
    drive = DRIVES.get(surface, "(PLANE/0,1,0,Y)")
    return (f"PARTNO {surface.upper()}\nINTOL/0\nOUTTOL/{tolerance:.10f}\nCUTTER/{CUTTERS[cutter]}\nNUMPTS/100000\n"
            f"{BEFORE.get(surface, '')}PS1={definition}\nXA=PLANE/1,0,0,-40\nXE=PLANE/1,0,0,40\nFROM/-60,0,60\nLOOPST\nY={-width}\n"
            f"A) GOTO/-45,Y,60\nGO/ON,{drive},TO,PS1,ON,XA\nINDIRV/1,0,0\nTLON,GOFWD/{drive},ON,XE\n"
            f"GODLTA/0,0,80\nY=Y+{2 * width / passes:.7f}\nIF(Y-{width})A,A,B\nB) GOTO/-60,0,60\nLOOPND\nFINI\n")


# Cut vectors per second of the processor that a case is to reach.
GOAL, FAST = 1_000_000, 2_000_000
GOALS = {surface: dict.fromkeys(CUTTERS, GOAL) for surface in SURFACES}
for simple in ("plane", "cylinder", "cone", "sphere"):
    GOALS[simple] |= {"ball": FAST, "flat": FAST}
GOALS["mesh of 200 000 triangles"] = dict.fromkeys(CUTTERS, 50_000)
for without in ("ruled surface", "polyconic"):
    GOALS[without] = {}


def cases(folder):
    """(what, path of a program, goal), all cutters on all surfaces, and one that grows. The goal is that of the longest program."""
    folder = pathlib.Path(folder)
    wavy_mesh(folder / "wavy.stl")
    rows = []

    def add(what, name, text, goal=None):
        (folder / name).write_text(text)
        rows.append((what, folder / name, goal))
    for s, surface in enumerate(SURFACES):
        for cutter in CUTTERS:
            few = FEW.get(surface, PASSES)
            for passes in few:
                add(f"{surface}, {cutter}, {passes} passes", f"{s}_{cutter}_{passes}.apt", program(surface, cutter, passes),
                    GOALS[surface].get(cutter) if passes == few[-1] else None)
    for passes in (10, 100, 1000, 10000):
        add(f"sphere, ball, {passes} passes", f"grows{passes}.apt", program("sphere", "ball", passes, .0001))
    for tolerance in (1e-4, 1e-6, 1e-8):
        add(f"sphere, ball, one pass, tolerance {tolerance:g}", f"one{tolerance:g}.apt",
            program("sphere", "ball", 1, tolerance).replace("NUMPTS/100000", "NUMPTS/10000000"))
    for tolerance in (1e-4, 1e-6, 1e-8, 1e-10):
        add(f"circle in the plane, one turn, tolerance {tolerance:g}", f"circle{tolerance:g}.apt",
            f"INTOL/0\nOUTTOL/{tolerance:.12f}\nCUTTER/10\nC1=CIRCLE/0,0,0,75.25\nLX=LINE/XAXIS\nFROM/120,0,0\nINDIRV/-1,0,0\n"
            "GO/TO,C1\nTLRGT,GORGT/C1,ON,2,INTOF,LX\nGOTO/120,0,0\nFINI\n", 20_000_000 if tolerance == 1e-10 else None)
    return rows
