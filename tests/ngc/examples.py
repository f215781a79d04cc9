"""The examples that RS-274 has no meaning for without more than they say, and the error that tells so.

Each entry: the code of the error, and why. All others are written, run by the interpreter and compared with the CL."""

REFUSED = {
    "stop.apt": ("E0672", "the gun tilts, which a control without turning axes cannot"),
    "ahead.apt": ("E0672", "the gun tilts"),
    "school_xing.apt": ("E0672", "the gun tilts"),
    "right_turn.apt": ("E0672", "the gun tilts"),
    "ring_paint.apt": ("E0672", "the gun points at a ring from all sides"),
    "sen_half_cylinder.apt": ("E0672", "the gun points at a cylinder from all sides"),
    "sen_revolved.apt": ("E0672", "the gun points at a surface of revolution from all sides"),
}
