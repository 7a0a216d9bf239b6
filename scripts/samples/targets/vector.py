"""Small vector toolbox for the sample targets: curves, shapes, easing and a rasteriser for binary masks.

Conventions: points are rows (x, y) in pixels of the frame, x grows right, y grows down; angles are in degrees,
0 along +x and growing clockwise on the screen (towards +y). Every function is pure; nothing here is random.
"""

import math

import numpy as np
from PIL import Image, ImageChops, ImageDraw, ImageFilter

SUPERSAMPLING = 4  # samples per pixel and axis
SMALLEST_REGION = 600  # px; regions with less are noise of the drawing
INSIDE_LEVEL = 128  # coverage (0..255) from which a pixel counts as inside: half


# ---------------------------------------------------------------- easing and interpolation


def clamp01(value):
    return min(1.0, max(0.0, value))


def progress(time, start, end):
    """Share of the interval [start, end] that has passed at `time`, within 0..1."""
    return clamp01((time - start) / (end - start))


def ease(value):
    """Ease in and out: 0..1 to 0..1 with zero velocity and acceleration at both ends."""
    value = clamp01(value)
    return value**3 * (value * (6.0 * value - 15.0) + 10.0)


def settle(value, swings=1.5, damping=4.0):
    """0 to 1 with an overshoot that rings `swings` times and dies away: a soft body that comes to rest."""
    value = clamp01(value)
    fade = math.exp(-damping * value) * (1.0 - value)
    return 1.0 - fade * math.cos(2.0 * math.pi * swings * value)


def mix(a, b, weight):
    return a + (b - a) * weight


class Track:
    """Smooth curve of a number over time through keys (time, value): cubic Hermite, flat beyond both ends.

    With `period` the curve closes: the key at time t also stands for t + period, t - period, ...
    Tangents are those of a parabola through neighbouring keys, so unequal spacing in time is fine.
    """

    def __init__(self, keys, period=None):
        times = [float(key[0]) for key in keys]
        values = [float(key[1]) for key in keys]
        if period is not None:
            count = len(keys)
            times = [t + turn * period for turn in (-1, 0, 1) for t in times]
            values = values * 3
            assert times == sorted(times) and count > 2
        self.period = period
        self.times = np.array(times)
        self.values = np.array(values)
        steps = np.diff(self.times)
        slopes = np.diff(self.values) / steps
        inner = (slopes[:-1] * steps[1:] + slopes[1:] * steps[:-1]) / (steps[:-1] + steps[1:])
        if period is None:  # no overshoot at the keys where the motion turns round or rests
            inner = np.where(slopes[:-1] * slopes[1:] <= 0.0, 0.0, inner)
        self.tangents = np.concatenate([[0.0], inner, [0.0]])

    def __call__(self, time):
        if self.period is not None:
            time = time % self.period
        time = min(max(time, self.times[0]), self.times[-1])
        i = int(np.clip(np.searchsorted(self.times, time, side="right") - 1, 0, len(self.times) - 2))
        step = self.times[i + 1] - self.times[i]
        u = (time - self.times[i]) / step
        return float(
            self.values[i] * (1 + 2 * u) * (1 - u) ** 2
            + self.tangents[i] * step * u * (1 - u) ** 2
            + self.values[i + 1] * u * u * (3 - 2 * u)
            + self.tangents[i + 1] * step * u * u * (u - 1)
        )


# ---------------------------------------------------------------- points and curves


def direction(angle):
    """Unit vector of an angle in degrees."""
    radians = math.radians(angle)
    return np.array([math.cos(radians), math.sin(radians)])


def rotate(points, angle, pivot=(0.0, 0.0)):
    c, s = direction(angle)
    pivot = np.asarray(pivot, float)
    return (np.asarray(points, float) - pivot) @ np.array([[c, s], [-s, c]]) + pivot


def place(points, shift=(0.0, 0.0), angle=0.0, scale=1.0):
    """Scale (a number or a pair), then rotate about the origin, then move."""
    return rotate(np.asarray(points, float) * np.asarray(scale, float), angle) + np.asarray(shift, float)


def spline(points, closed=False, samples=10):
    """Catmull-Rom curve (centripetal: no loops, no cusps) through the points, `samples` per span."""
    p = np.asarray(points, float)
    if closed:
        p = np.concatenate([p[-1:], p, p[:2]])
    else:
        p = np.concatenate([2 * p[:1] - p[1:2], p, 2 * p[-1:] - p[-2:-1]])
    u = np.linspace(0.0, 1.0, samples, endpoint=False)[:, None]
    pieces = []
    for p0, p1, p2, p3 in zip(p, p[1:], p[2:], p[3:]):
        d1, d2, d3 = (max(math.sqrt(np.linalg.norm(b - a)), 1e-3) for a, b in ((p0, p1), (p1, p2), (p2, p3)))
        m1 = d2 * ((p1 - p0) / d1 - (p2 - p0) / (d1 + d2) + (p2 - p1) / d2)
        m2 = d2 * ((p2 - p1) / d2 - (p3 - p1) / (d2 + d3) + (p3 - p2) / d3)
        pieces.append((2 * p1 - 2 * p2 + m1 + m2) * u**3 + (3 * p2 - 3 * p1 - 2 * m1 - m2) * u**2 + m1 * u + p1)
    if not closed:
        pieces.append(p[-2:-1])
    return np.concatenate(pieces)


def arc_lengths(points):
    """Distance along the polyline from its first point to each point, px."""
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(steps)])


def resample(points, spacing):
    """The polyline with points about every `spacing` px, ends kept."""
    lengths = arc_lengths(points)
    at = np.linspace(0.0, lengths[-1], max(2, int(round(lengths[-1] / spacing)) + 1))
    return np.stack([np.interp(at, lengths, points[:, axis]) for axis in (0, 1)], axis=1)


def ellipse(centre, rx, ry, angle=0.0, samples=72):
    turn = np.linspace(0.0, 2.0 * math.pi, samples, endpoint=False)
    return place(np.stack([rx * np.cos(turn), ry * np.sin(turn)], axis=1), centre, angle)


def capsule(a, b, ra, rb, samples=24):
    """Hull of a circle of radius `ra` about `a` and one of radius `rb` about `b`."""
    a, b = np.asarray(a, float), np.asarray(b, float)
    length = float(np.linalg.norm(b - a))
    if length <= abs(ra - rb) + 1e-6:
        return ellipse(a, ra, ra) if ra >= rb else ellipse(b, rb, rb)
    axis = math.degrees(math.atan2(b[1] - a[1], b[0] - a[0]))
    lean = math.degrees(math.acos((ra - rb) / length))
    around_b = np.linspace(axis - lean, axis + lean, samples)
    around_a = np.linspace(axis + lean, axis + 360.0 - lean, samples)
    circle_b = [b + rb * direction(angle) for angle in around_b]
    circle_a = [a + ra * direction(angle) for angle in around_a]
    return np.array(circle_b + circle_a)


def petal(base, tip, width, fullness=0.55):
    """A leaf shape from `base` to `tip`; `width` px across at the share `fullness` of its length, round at the tip."""
    base, tip = np.asarray(base, float), np.asarray(tip, float)
    along = tip - base
    across = np.array([-along[1], along[0]]) / max(float(np.linalg.norm(along)), 1e-6) * width / 2.0
    u = np.linspace(0.0, 1.0, 25)
    # A half wave bent so that its crest lies at `fullness`.
    profile = np.sin(math.pi * u ** (math.log(0.5) / math.log(fullness))) ** 0.8
    left = base + u[:, None] * along + profile[:, None] * across
    right = base + u[:, None] * along - profile[:, None] * across
    return np.concatenate([left, right[::-1]])


# ---------------------------------------------------------------- rasteriser


class Canvas:
    """A binary picture under construction: shapes are joined (or cut out) at SUPERSAMPLING times its size.

    Whatever is drawn is enlarged `zoom` times about the point `about` (px of the frame).
    """

    def __init__(self, size, zoom=1.0, about=(0.0, 0.0)):
        self.zoom = zoom
        self.about = np.asarray(about, float)
        self.image = Image.new("L", (size[0] * SUPERSAMPLING, size[1] * SUPERSAMPLING), 0)
        self.draw = ImageDraw.Draw(self.image)

    def polygon(self, points, inside=True):
        # The sample (i, j) lies at ((i + 0.5) / SUPERSAMPLING, ...) px.
        corners = ((np.asarray(points, float) - self.about) * self.zoom + self.about) * SUPERSAMPLING - 0.5
        self.draw.polygon([tuple(corner) for corner in corners], fill=255 if inside else 0)

    def blob(self, control_points, inside=True):
        """The inside of a closed spline."""
        self.polygon(spline(control_points, closed=True), inside)

    def circle(self, centre, radius, inside=True):
        self.polygon(ellipse(centre, radius, radius), inside)

    def capsule(self, a, b, ra, rb, inside=True):
        self.polygon(capsule(a, b, ra, rb), inside)

    def stroke(self, points, radii, inside=True):
        """A line with round caps; `radii` is one radius in px or one for each point."""
        points = np.asarray(points, float)
        radii = np.broadcast_to(np.asarray(radii, float), len(points))
        for a, b, ra, rb in zip(points, points[1:], radii, radii[1:]):
            self.capsule(a, b, float(ra), float(rb), inside)

    def mask(self, fillet=0.0):
        """Threshold the coverage at half.

        `fillet` (px) makes the union smooth: inner corners are filled as by a Gaussian of that sigma, which also
        closes slits of about its width. Outer corners and thin parts stay as drawn.
        """
        coverage = self.image.reduce(SUPERSAMPLING)
        if fillet > 0.0:
            coverage = ImageChops.lighter(coverage, coverage.filter(ImageFilter.GaussianBlur(fillet)))
        return without_small_regions(np.asarray(coverage) >= INSIDE_LEVEL, SMALLEST_REGION)


def without_small_regions(mask, smallest):
    """Flip every connected region, inside or outside, of fewer than `smallest` pixels: no specks, no pinholes."""
    height, width = mask.shape
    # Runs of equal pixels in each row, joined to those they touch in the row above.
    parent, area, runs = [], [], []

    def root(run):
        while parent[run] != run:
            parent[run] = parent[parent[run]]
            run = parent[run]
        return run

    above = []
    for y in range(height):
        row = mask[y]
        cuts = [0, *(np.flatnonzero(row[1:] != row[:-1]) + 1).tolist(), width]
        current = []
        k = 0
        for start, end in zip(cuts, cuts[1:]):
            run = len(parent)
            parent.append(run)
            area.append(end - start)
            runs.append((y, start, end))
            current.append(run)
            while k > 0 and runs[above[k]][1] >= start:
                k -= 1
            while k < len(above) and runs[above[k]][1] < end:
                other = above[k]
                if runs[other][2] > start and mask[y - 1, runs[other][1]] == row[start]:
                    a, b = root(other), root(run)
                    if a != b:
                        parent[b] = a
                        area[a] += area[b]
                k += 1
            k = max(0, k - 1)
        above = current
    result = mask.copy()
    for run, (y, start, end) in enumerate(runs):
        if area[root(run)] < smallest:
            result[y, start:end] = not mask[y, start]
    return result


def save_mask(mask, path):
    Image.fromarray(mask.astype(np.uint8) * 255).convert("1", dither=Image.Dither.NONE).save(path, optimize=True)
