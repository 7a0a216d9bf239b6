"""A genie is squeezed out of a spout: a wisp climbs, curls and billows, then head, turban and arms swell out of it.

The figure is drawn about a spine that stands on the spout: a point (d, h) lies h px up the spine and d px to its
right. The spine rises and waves; every part swells from an anchor on it with an overshoot.
"""

import math

import numpy as np

from vector import Canvas, Track, capsule, ease, ellipse, mix, petal, progress, resample, settle, spline

SIZE = (900, 900)
FRAMES = 80
SPOUT = np.array([450.0, 884.0])  # px
BENDING = 130.0  # px, half the length of spine that sets the lean of what is drawn about it
FILLET = 9.0  # px, smoothness of the union

# Height of the figure over the frames as a share of its full height; it breathes at the end.
RISE = Track([(0, 0.08), (4, 0.16), (17, 0.66), (29, 0.88), (43, 1.015), (54, 0.985), (66, 1.012), (79, 0.99)])

# Half width of the trail of smoke along its height (h, px), as a wisp and in the end.
WISP = ((0, 12), (60, 14), (150, 18), (260, 22), (360, 30), (430, 42), (480, 50), (520, 44), (545, 12))
OPENING = 8.0  # px, radius of the spout; above it the smoke may widen by
WIDENING = 0.5  # px per px of height
TRAIL = ((0, 11), (50, 15), (110, 30), (180, 60), (250, 92), (320, 108), (400, 112), (470, 106), (520, 70), (545, 12))
TRAIL_SWELLS = (22, 50)  # frames

TORSO = np.array([
    (0, 330), (92, 330), (104, 372), (128, 430), (158, 490), (168, 545), (142, 592), (84, 616), (44, 632),
    (-44, 632), (-84, 616), (-142, 592), (-168, 545), (-158, 490), (-128, 430), (-104, 372), (-92, 330)], float)
TORSO_ANCHOR = (0.0, 440.0)
HEAD = (0.0, 684.0, 66.0, 76.0)  # d, h, rx, ry
EARS = ((72.0, 676.0), (-72.0, 676.0))
EAR_RADIUS = 17.0
BEARD = np.array([(-46, 650), (-30, 606), (0, 560), (30, 606), (46, 650)], float)
HEAD_ANCHOR = (0.0, 600.0)
TURBAN = np.array([
    (0, 706), (70, 704), (104, 728), (106, 764), (84, 796), (44, 818), (0, 826), (-44, 818), (-84, 796), (-106, 764),
    (-104, 728), (-70, 704)], float)
TURBAN_ANCHOR = (0.0, 716.0)
PLUME_ROOT = (0.0, 808.0)
PLUME_LENGTH = 66.0
PLUME_WIDTH = 46.0
SHOULDER = (146.0, 556.0)
BICEPS = (190.0, 506.0)
ELBOW = (210.0, 442.0)
HAND = (-88.0, 452.0)
ARM_RADII = (52.0, 53.0, 44.0, 36.0)  # px: shoulder, biceps, elbow, hand
# Slits between the folded arms and the chest: (d, h) with half width.
FOLD_LINES = (((-128, 508), (-64, 500), (4, 506), (74, 488), (126, 486)), ((-66, 396), (-10, 404), (62, 412)))
FOLD_RADII = (4.0, 10.0, 11.0, 10.0, 4.0)

SLOW_START = 1.35  # power of the time: over 1, parts swell gently at first
# When each part swells: (first frame, last frame).
SWELLS = {
    "torso": (21, 56), "head": (25, 56), "turban": (29, 60), "arms": (32, 66), "plume": (44, 76), "folds": (50, 62)}

# Puffs of the billowing cloud: (d, h, radius, frame of the largest size, frames of its rise, of its fall).
PUFFS = (
    (-62, 452, 58, 25, 12, 16), (66, 486, 64, 29, 13, 15), (-74, 540, 60, 33, 13, 15), (58, 572, 54, 35, 12, 14),
    (-10, 602, 66, 33, 13, 14), (-96, 400, 48, 31, 12, 16), (100, 410, 50, 35, 12, 15))


def spine_x(height, time):
    """Sideways shift of the spine, px, at a height in px: a wave that climbs, quick in the wisp, a slow sway after."""
    calm = ease(progress(time, 20, 56))
    wisp = 46.0 * np.sin(2.0 * math.pi * (height / 330.0 - time / 22.0)) * np.clip(height / 260.0, 0.0, 1.0)
    swing = 2.0 * math.pi * (time - 44.0) / 36.0
    belly = np.exp(-(((height - 150.0) / 150.0) ** 2)) * np.clip(height / 90.0, 0.0, 1.0)
    curve = 44.0 * belly * (1.0 + 0.55 * np.sin(swing + 1.6))
    sway = 48.0 * (np.maximum(height, 0.0) / 800.0) ** 1.4 * np.sin(swing - height / 520.0)
    return mix(wisp, curve + sway, calm)


def to_frame(points, time):
    """Points (d, h) of the figure, in the frame."""
    points = np.asarray(points, float)
    height = np.maximum(points[:, 1] * RISE(time), 0.0)
    # The mean slope over a long piece, or wide parts would fold over themselves where the spine bends.
    slope = (spine_x(height + BENDING, time) - spine_x(height - BENDING, time)) / (2.0 * BENDING)
    slope = np.clip(slope, -0.3, 0.3) * np.clip(height / 120.0, 0.0, 1.0)
    length = np.sqrt(1.0 + slope**2)
    x = spine_x(height, time) + points[:, 0] / length
    y = height - points[:, 0] * slope / length
    return SPOUT + np.stack([x, -y], axis=1)


def swell(part, time):
    first, last = SWELLS[part]
    return settle(progress(time, first, last) ** SLOW_START, swings=1.25, damping=4.5)


def frame(index):
    time = float(index)
    canvas = Canvas(SIZE)

    def draw(points, anchor=(0.0, 0.0), size=1.0):
        if size > 0.02:
            outline = np.concatenate([points, points[:1]])
            outline = resample(outline, 8.0)
            canvas.polygon(to_frame(mix(np.asarray(anchor, float), outline, size), time))

    # The trail of smoke.
    heights = np.linspace(0.0, 545.0, 110)
    trail = mix(np.interp(heights, *zip(*WISP)), np.interp(heights, *zip(*TRAIL)), ease(progress(time, *TRAIL_SWELLS)))
    trail = np.convolve(np.pad(trail, 4, mode="edge"), np.full(9, 1.0 / 9.0), mode="valid")
    # Bulges run up through it while it is squeezed out.
    squeeze = 1.0 - ease(progress(time, 34, 56))
    wave = np.sin(2.0 * math.pi * (heights / 210.0 - time / 11.0)) * np.clip(heights / 120.0, 0.0, 1.0)
    bulges = 1.0 + 0.30 * squeeze * wave
    centre = np.stack([np.zeros_like(heights), heights], axis=1)
    radii = np.minimum(trail * bulges, OPENING + WIDENING * heights * RISE(time))
    canvas.stroke(to_frame(centre, time), radii)

    # The billows.
    for d, h, radius, peak, rise, fall in PUFFS:
        size = ease(progress(time, peak - rise, peak)) * (1.0 - ease(progress(time, peak, peak + fall)))
        drift = 10.0 * math.sin(2.0 * math.pi * (time / 15.0 + h / 170.0))
        draw(ellipse((d + drift, h + drift), radius, radius), (0.0, h - 40.0), size)

    # The figure.
    draw(spline(TORSO, closed=True), TORSO_ANCHOR, swell("torso", time))
    size = swell("arms", time)
    for side in (1.0, -1.0) if size > 0.02 else ():
        # The arms are crossed: one forearm lies higher than the other.
        mirror = np.array([side, 1.0])
        lift = np.array([0.0, 16.0 * side])
        joints = [np.array(joint) * mirror for joint in (SHOULDER, BICEPS, ELBOW, HAND)]
        joints[-1] += lift
        # The arms come out of the chest thick: their girth is ahead of their length.
        inside = joints[0] * np.array([0.45, 0.97])
        joints = [mix(inside, joint, size) for joint in joints]
        radii = [radius * math.sqrt(max(0.0, size)) for radius in ARM_RADII]
        for a, b, ra, rb in zip(joints, joints[1:], radii, radii[1:]):
            draw(capsule(a, b, ra, rb))
    head = swell("head", time)
    draw(ellipse(HEAD[:2], *HEAD[2:]), HEAD_ANCHOR, head)
    draw(spline(BEARD, closed=True), HEAD_ANCHOR, head)
    for ear in EARS:
        draw(ellipse(ear, EAR_RADIUS, EAR_RADIUS * 1.4), HEAD_ANCHOR, head)
    # The turban sits on the head and the plume on the turban, however large they are.
    turban = swell("turban", time)
    draw(mix(np.array(TURBAN_ANCHOR), spline(TURBAN, closed=True), turban), HEAD_ANCHOR, head)
    plume = swell("plume", time)
    lean = math.radians(24.0 + 16.0 * math.sin(2.0 * math.pi * (time - 54.0) / 36.0))
    root = mix(np.array(TURBAN_ANCHOR), np.array(PLUME_ROOT), turban)
    tip = root + PLUME_LENGTH * plume * np.array([math.sin(lean), math.cos(lean)])
    if plume > 0.05:
        draw(petal(root, tip, PLUME_WIDTH * plume), HEAD_ANCHOR, head)

    opening = ease(progress(time, *SWELLS["folds"]))
    if opening > 0.4:
        for line in FOLD_LINES:
            curve = to_frame(spline(line), time)
            radii = np.interp(np.linspace(0, 1, len(curve)), np.linspace(0, 1, 5), FOLD_RADII) * opening
            canvas.stroke(curve, radii, inside=False)
    return canvas.mask(FILLET)
