"""Why a test of LinuxCNC differs here, by its name: a class and the reason."""

PATH = "the trace states the programmed contour, LinuxCNC the path of the tool's centre"
SAID = "not interpreted, and the run says so"
DEFECT = "a defect of LinuxCNC that its test records"
CONTROL = "LinuxCNC as it was called, or as strict as it is"

ROTATION = "G10 L2 R turns the coordinates"
TURNING = "cycles of lathes"

REASONS = {
    "cam-nisley": (PATH, "G41.1 with a diameter"),
    "crazy-paths": (PATH, "G41 and G42"),
    "inside-corners": (PATH, "G42"),
    "inverse-time-with-comp": (PATH, "G41, and feeds that follow from it"),
    "g10/g10-l1-l10": (SAID, "G10 L1 and L10, the tool table, and #5401 to #5403"),
    "g10/g10-l11": (SAID, "G10 L11, and G10 L2 R"),
    "g10/g10-l2-while-active": (SAID, ROTATION),
    "g10/g10-l20-while-active": (SAID, ROTATION + "; G10 L20"),
    "g10/g10-with-g92": (SAID, ROTATION),
    "g52/g52-g92-interaction": (SAID, "#5210 to #5219, which keep G92; G92.3"),
    "g71-endless-loop": (SAID, TURNING),
    "g71-endless-loop2": (SAID, TURNING),
    "g71-endless-loop_2": (SAID, TURNING),
    "g71-with-g70": (SAID, TURNING),
    "g72-facing": (SAID, TURNING),
    "g72-missing-iteration": (SAID, TURNING),
    "g76": (SAID, TURNING),
    "machine-coord-params": (SAID, "#<_abs_x> and its like, and G43.1"),
    "rotation/abs-pts": (SAID, ROTATION + "; #<_abs_x> and its like"),
    "rotation/g28": (SAID, ROTATION + "; the stored point of G28"),
    "rotation/g53": (SAID, ROTATION),
    "unit-conversion": (SAID, "#5211 to #5216, which keep G92; all else agrees"),
    "g84/g18/g98": (DEFECT, "in G18 a tap along Y goes along X and changes the two others"),
    "g84/g18/g99": (DEFECT, "in G18 a tap along Y goes along X and changes the two others"),
    "g84/g19/g98": (DEFECT, "in G19 a tap along X goes along Y and changes the two others"),
    "g84/g19/g99": (DEFECT, "in G19 a tap along X goes along Y and changes the two others"),
    "nested-sub-in-file-error": (CONTROL, "a subprogram of a file calls another of it: refused there, run here"),
    "oword-unwind": (CONTROL, "it goes on with the next line after an error, as by hand"),
}
