"""One long line is drawn in loops, as a pen would: quick on the straights, slow in the turns; then it rests."""

import numpy as np

from vector import Canvas, resample, spline

SIZE = (750, 600)
FRAMES = 80
DRAWN_AFTER = 69  # frames, then the line is complete and still

MEAN_RADIUS = 20.0  # px, half the width of the line
RADIUS_SWING = 2.2  # px; the line is thinner where the pen is quick
SPACING = 4.0  # px between the points of the line
SLOW_IN_TURNS = 60.0  # px; where the curvature is c (1/px) the pen needs 1 + SLOW_IN_TURNS * c times as long

# The path of the pen.
PATH = np.array([
    (58, 500), (150, 452), (270, 318), (318, 182), (244, 84), (150, 170), (164, 330), (262, 470), (398, 506),
    (530, 412), (600, 232), (520, 92), (410, 176), (412, 340), (500, 470), (610, 506), (694, 420)], float)
SMOOTHING = 170.0  # px along the path: the loops get an even curvature


def smoothed(points):
    """The path averaged over SMOOTHING px along it; both ends stay where they are."""
    half = int(SMOOTHING / SPACING / 2)
    window = np.hanning(2 * half + 3)[1:-1]
    padded = np.concatenate([2 * points[:1] - points[half:0:-1], points, 2 * points[-1:] - points[-2:-half - 2:-1]])
    return np.stack([np.convolve(padded[:, axis], window / window.sum(), mode="valid") for axis in (0, 1)], axis=1)


def measured_path():
    """Points of the path with the time (0..1) at which the pen passes them and the radius of the line there (px)."""
    points = resample(smoothed(resample(spline(PATH, samples=24), SPACING)), SPACING)
    heading = np.unwrap(np.arctan2(*np.gradient(points, axis=0).T[::-1]))
    curvature = np.abs(np.gradient(heading)) / SPACING  # 1/px
    window = np.hanning(41)
    padded = np.pad(curvature, 20, mode="edge")
    curvature = np.convolve(padded, window / window.sum(), mode="valid")
    slowness = 1.0 + SLOW_IN_TURNS * curvature
    time = np.concatenate([[0.0], np.cumsum((slowness[1:] + slowness[:-1]) / 2.0)])
    radius = MEAN_RADIUS + RADIUS_SWING * np.tanh((slowness / slowness.mean() - 1.0) * 3.0)
    return points, time / time[-1], radius


POINTS, TIMES, RADII = measured_path()


def pen_time(index):
    """How far the pen is (0..1) at a frame: a soft start and a soft end, even in between."""
    u = min(1.0, (index + 2.0) / (DRAWN_AFTER + 2.0))
    soft = 0.13  # share of the time for speeding up and for slowing down
    speed_up = u * u / (2.0 * soft) if u < soft else u - soft / 2.0
    if u > 1.0 - soft:
        speed_up = 1.0 - soft - (1.0 - u) ** 2 / (2.0 * soft)
    return speed_up / (1.0 - soft)


def frame(index):
    now = pen_time(index)
    count = int(np.searchsorted(TIMES, now, side="right"))
    tip = np.array([np.interp(now, TIMES, POINTS[:, axis]) for axis in (0, 1)])
    line = np.concatenate([POINTS[:count], [tip, tip + 0.01]])
    radii = np.concatenate([RADII[:count], np.full(2, np.interp(now, TIMES, RADII))])
    canvas = Canvas(SIZE)
    canvas.stroke(line, radii)
    return canvas.mask()
