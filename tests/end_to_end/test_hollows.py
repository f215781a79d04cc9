"""Line contact in hollows: paths that touch all along are proven, and refuted where one place is two slacks too deep."""
import json
import math
import unittest

from arelem_run import PROJECT, ArelemCase

MOTION = PROJECT / "tests" / "golden" / "motion"
# Half angle of the cone, and whether a place is pushed along the axis of the cone or square to it.
SCENES = {
    "proof_of_a_tapered_tool_in_a_cone_of_its_taper": (10, False),
    "proof_of_a_drafted_corner": (10, False),
    "proof_of_an_axis_along_a_hollow_cone": (20, False),
    "proof_of_a_drill_in_a_countersink_of_its_angle": (60, True),
}
SLACK = 1e-6


class Hollows(ArelemCase):
    def test_a_place_that_is_too_deep_is_refuted(self):
        for name, (half, along) in SCENES.items():
            half = math.radians(half)
            path = MOTION / f"{name}.apt"
            self.assertExit(0, path, "-o", "whole.jsonl")
            whole = (self.folder / "whole.jsonl").read_text()
            for depth, code in ((0.5 * SLACK, 0), (3 * SLACK, 5)):
                with self.subTest(name=name, depth=depth):
                    records = [json.loads(line) for line in whole.splitlines()]
                    motion = [r for r in records if r["kind"] == "GOTO" and len(r["points"]) > 1][-1]
                    point = motion["points"][len(motion["points"]) // 2]
                    if along:
                        point[2] -= depth / math.sin(half)
                    else:
                        out = depth / math.cos(half) / math.hypot(point[0], point[1])
                        point[0] += out * point[0]
                        point[1] += out * point[1]
                    self.write("pushed.jsonl", "".join(json.dumps(r) + "\n" for r in records))
                    self.assertExit(code, "verify", path, "pushed.jsonl")
                    self.assertEqual("error[E0904]" in self.err, code == 5, self.err)
                    self.assertNotIn("error[E0906]", self.err)


if __name__ == "__main__":
    unittest.main()
