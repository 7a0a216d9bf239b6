"""A sunflower grows: the stem rises with its bud, leaves unfold, the head turns to us, opens and spins.

The head is a ring of petals in space, seen along -z without perspective: a cone that opens while its axis tilts from
the stem towards the viewer. Lengths in px, angles in degrees, times in frames.
"""

import math

import numpy as np

from vector import Canvas, Track, ease, petal, progress, settle

SIZE = (500, 600)
FRAMES = 90
FILLET = 3.0  # px
ROOT = np.array([246.0, 598.0])

STEM_LENGTH = Track([(0, 40), (3, 62), (22, 300), (34, 372), (44, 386), (60, 384), (89, 384)])  # px
STEM_RADII = (17.0, 13.0)  # px, at the root and under the head

# Leaves: (height on the stem, side, direction when open, length, width, first frame, last frame).
LEAVES = ((54.0, 1.0, -24.0, 168.0, 70.0, 10, 50), (96.0, -1.0, -20.0, 156.0, 66.0, 16, 58))

PETALS = 13
HEAD_SIZE = Track([(0, 0.46), (10, 0.58), (26, 0.70), (44, 0.88), (56, 1.05), (63, 0.985), (70, 1.0), (89, 1.0)])
DISC_RADIUS = 86.0
PETAL_LENGTH = 124.0
PETAL_WIDTH = 56.0
PETAL_ROOT = 0.70  # share of the radius of the disc where the petals grow out of it
# Angle between the petals and the axis of the head: closed bud to flat, and back a little.
OPENING = Track([(0, -13), (18, -11), (27, 0), (37, 34), (50, 84), (57, 98), (64, 88), (72, 90), (89, 90)])
# Angle between the axis and the stem's direction: 0 points up the stem, 90 at the viewer.
TILT = Track([(0, 0), (20, 4), (34, 30), (50, 80), (57, 88), (64, 84), (89, 85)])
# Turn of the head about its axis; it gathers speed and comes to rest.
SPIN = Track([(0, 0), (40, 4), (58, 22), (78, 92), (84, 108), (89, 112)])


def stem_line(time):
    """Points up the stem; it sways as it grows, the top most."""
    length = STEM_LENGTH(time)
    u = np.linspace(0.0, 1.0, 40)
    lively = 1.0 - 0.6 * ease(progress(time, 40, 70))
    sway = 26.0 * lively * math.sin(2.0 * math.pi * time / 40.0) * length / 384.0
    bow = 20.0 * math.sin(2.0 * math.pi * (time - 9.0) / 40.0) * lively * length / 384.0
    x = sway * u**2 + bow * np.sin(math.pi * u) * 0.6
    return ROOT + np.stack([x, -length * u], axis=1)


def draw_leaf(canvas, line, time, leaf):
    height, side, open_angle, length, width, first, last = leaf
    if STEM_LENGTH(time) < height + 6.0 or time <= first:
        return
    grown = ease(progress(time, first, last - 6))
    unfolded = settle(progress(time, first + 4, last), swings=1.2)
    root = line[int(np.searchsorted(-line[:, 1], height - ROOT[1]))]
    angle = -84.0 + (open_angle + 84.0) * unfolded + 4.0 * math.sin(2.0 * math.pi * (time - 14.0) / 40.0)
    # The leaf bends over its length: its tip hangs.
    u = np.linspace(0.0, 1.0, 22)
    heading = np.radians(angle + (u - 0.25) * 46.0 * unfolded)
    steps = np.stack([side * np.cos(heading), np.sin(heading)], axis=1) * length * grown / len(u)
    rib = root + np.cumsum(steps, axis=0)
    profile = np.sin(math.pi * u**0.85) ** 0.8
    radii = np.maximum(width / 2.0 * grown * profile, np.interp(u, (0, 0.5, 1), (9.0, 6.0, 3.0)) * min(1.0, 3 * grown))
    canvas.stroke(rib, radii)


def draw_head(canvas, centre, stem_angle, time):
    size = HEAD_SIZE(time)
    tilt, opening = math.radians(TILT(time)), math.radians(OPENING(time))
    up = np.array([math.sin(stem_angle), -math.cos(stem_angle), 0.0])
    viewer = np.array([0.0, 0.0, 1.0])
    axis = up * math.cos(tilt) + viewer * math.sin(tilt)
    across = np.cross(up, viewer)
    beside = np.cross(axis, across)

    def project(points):
        return centre + points[:, :2] * size

    turn = np.radians(np.linspace(0.0, 360.0, 72, endpoint=False))
    rim = np.cos(turn)[:, None] * across + np.sin(turn)[:, None] * beside
    open_share = max(0.0, math.sin(opening))
    disc = DISC_RADIUS * (0.55 + 0.45 * open_share)
    canvas.polygon(project(rim * disc))
    # The cup under the disc keeps the bud round from the side.
    canvas.circle(centre - axis[:2] * disc * 0.20 * size, disc * 0.97 * size)

    flat = petal((0.0, 0.0), (1.0, 0.0), 1.0, fullness=0.50)
    for k in range(PETALS):
        angle = math.radians(SPIN(time) + 360.0 * k / PETALS)
        outward = math.cos(angle) * across + math.sin(angle) * beside
        tangent = -math.sin(angle) * across + math.cos(angle) * beside
        # Petals are not all alike, and do not open in step.
        vary = math.sin(2.4 * k)
        lean = opening * (1.0 + 0.05 * vary)
        along = math.cos(lean) * axis + math.sin(lean) * outward
        length = PETAL_LENGTH * (1.0 + 0.05 * vary) * (0.9 + 0.1 * open_share)
        root = outward * disc * PETAL_ROOT
        shape = root + flat[:, :1] * length * along + flat[:, 1:] * PETAL_WIDTH * tangent
        canvas.polygon(project(shape))


def frame(index):
    time = float(index)
    canvas = Canvas(SIZE)
    line = stem_line(time)
    canvas.stroke(line, np.linspace(*STEM_RADII, len(line)) * (0.75 + 0.25 * ease(progress(time, 0, 30))))
    for leaf in LEAVES:
        draw_leaf(canvas, line, time, leaf)
    top = line[-1] - line[-4]
    draw_head(canvas, line[-1], math.atan2(top[0], -top[1]), time)
    return canvas.mask(FILLET)
