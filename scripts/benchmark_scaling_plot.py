"""Draws the sweeps of benchmark_scaling.py as panels of one SVG: both axes logarithmic."""

import math
from xml.sax.saxutils import escape

import numpy as np

PANEL_WIDTH_PX = 400
PANEL_HEIGHT_PX = 300
MARGIN_PX = {"left": 62, "right": 18, "top": 46, "bottom": 48}
PANELS_A_ROW = 2
TICK_STEPS = ((1, 2, 5), (1, 2, 3, 4, 5, 7), (1, 1.2, 1.5, 2, 2.5, 3, 3.5, 4, 5, 6, 7, 8))
FEWEST_TICKS = 3  # else the next finer steps
POINT_RADIUS_PX = 3.5
INK = "#222222"
GRID = "#dddddd"
POINT = "#1f5fa8"
FIT = "#c8602a"

# Title, label of the horizontal axis, and the column of the table that is drawn along it.
PANELS = {
    "mask-pixels": ("Pixels inside the mask", "pixels inside", "mask_px"),
    "target-size": ("Size of the target, mask in proportion", "pixels of a frame", "value"),
    "exemplar-frames": ("Frames of the exemplar", "frames", "value"),
    "exemplar-size": ("Size of the exemplar", "pixels of a frame", "value"),
    "threads": ("Threads", "threads", "value"),
}
LINEAR_IN_PIXELS = ("mask-pixels", "target-size")  # what a pixel inside costs is stated too


class LogAxis:
    """Maps positive values to pixels."""

    def __init__(self, values, begin_px, end_px):
        low, high = min(values), max(values)
        # Some room, and never less than an octave in all.
        room = max(1.15, math.sqrt(2 * low / high))
        self.low, self.high = math.log10(low / room), math.log10(high * room)
        self.begin_px, self.end_px = begin_px, end_px

    def __call__(self, value):
        share = (math.log10(value) - self.low) / (self.high - self.low)
        return self.begin_px + share * (self.end_px - self.begin_px)

    def ticks(self):
        decades = range(math.floor(self.low), math.ceil(self.high) + 1)
        for steps in TICK_STEPS:
            ticks = [step * 10.0 ** decade for decade in decades for step in steps]
            ticks = [t for t in ticks if self.low <= math.log10(t) <= self.high]
            if len(ticks) >= FEWEST_TICKS:
                break
        return ticks


def number(value):
    """Short, with a prefix: 2M, 50k, 0.2."""
    for unit, suffix in ((1e6, "M"), (1e3, "k")):
        if value >= unit:
            return f"{value / unit:g}{suffix}"
    return f"{value:g}"


def line(x1, y1, x2, y2, colour, extra=""):
    return (f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" '
            f'stroke="{colour}" {extra}/>')


def text(x, y, content, size=12, anchor="middle", extra=""):
    return (f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}" '
            f'fill="{INK}" {extra}>{escape(content)}</text>')


def power_law(xs, ys):
    """Exponent and factor of y = factor x^exponent, by least squares of the logarithms."""
    exponent, offset = np.polyfit(np.log(xs), np.log(ys), 1)
    return float(exponent), float(np.exp(offset))


def statement(sweep, rows, xs, ys):
    """What the fit says, in words."""
    slope = f"slope {power_law(xs, ys)[0]:.2f}"
    if sweep in LINEAR_IN_PIXELS:
        per_pixel = np.polyfit([row["mask_px"] for row in rows], ys, 1)[0]
        slope += f"; {per_pixel * 1e6:.2f} microseconds x cores per further px inside"
    return slope


def panel(sweep, rows, left, top):
    title, label, column = PANELS[sweep]
    by_clock = sweep == "threads"
    name = "wall_s_per_frame" if by_clock else "cpu_s_per_frame"
    rows = [row for row in rows if row[name] > 0]  # a difference of two runs may be lost in noise
    right, bottom = left + PANEL_WIDTH_PX, top + PANEL_HEIGHT_PX
    parts = [text((left + right) / 2, top + 18, title, 14, extra='font-weight="bold"')]
    if len(rows) < 2:
        return parts + [text((left + right) / 2, (top + bottom) / 2, "fewer than two points")]
    xs = [row[column] for row in rows]
    ys = [row[name] for row in rows]
    bars = [] if by_clock else [(max(row["cpu_min"], min(ys) / 2), row["cpu_max"]) for row in rows]
    x_axis = LogAxis(xs, left + MARGIN_PX["left"], right - MARGIN_PX["right"])
    y_axis = LogAxis(ys + [end for bar in bars for end in bar], bottom - MARGIN_PX["bottom"],
                     top + MARGIN_PX["top"])
    for tick in x_axis.ticks():
        parts += [line(x_axis(tick), y_axis.begin_px, x_axis(tick), y_axis.end_px, GRID),
                  text(x_axis(tick), y_axis.begin_px + 16, number(tick), 11)]
    for tick in y_axis.ticks():
        parts += [line(x_axis.begin_px, y_axis(tick), x_axis.end_px, y_axis(tick), GRID),
                  text(x_axis.begin_px - 6, y_axis(tick) + 4, number(tick), 11, "end")]
    parts += [line(x_axis.begin_px, y_axis.begin_px, x_axis.end_px, y_axis.begin_px, INK),
              line(x_axis.begin_px, y_axis.begin_px, x_axis.begin_px, y_axis.end_px, INK)]

    exponent, factor = power_law(xs, ys)
    ends = (min(xs), max(xs))
    fit = [(x_axis(x), y_axis(factor * x ** exponent)) for x in ends]
    parts.append(line(*fit[0], *fit[1], FIT, 'stroke-dasharray="5 3"'))
    for x, (low, high) in zip(xs, bars):
        parts.append(line(x_axis(x), y_axis(low), x_axis(x), y_axis(high), POINT))
    for x, y in zip(xs, ys):
        parts.append(f'<circle cx="{x_axis(x):.1f}" cy="{y_axis(y):.1f}" r="{POINT_RADIUS_PX}" '
                     f'fill="{POINT}"/>')

    middle = (y_axis.begin_px + y_axis.end_px) / 2
    unit = "s per frame, by the clock" if by_clock else "s x cores per frame"
    return parts + [
        text((left + right) / 2, top + 36, statement(sweep, rows, xs, ys), 11),
        text((x_axis.begin_px + x_axis.end_px) / 2, bottom - 12, label),
        text(left + 16, middle, unit, extra=f'transform="rotate(-90 {left + 16} {middle:.1f})"')]


def svg(rows):
    """The plot of all sweeps that the rows hold, in their order."""
    sweeps = list(dict.fromkeys(row["sweep"] for row in rows))
    lines = -(-len(sweeps) // PANELS_A_ROW)
    width = PANEL_WIDTH_PX * min(len(sweeps), PANELS_A_ROW)
    height = PANEL_HEIGHT_PX * lines
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
             f'viewBox="0 0 {width} {height}" font-family="sans-serif">',
             f'<rect width="{width}" height="{height}" fill="white"/>']
    for i, sweep in enumerate(sweeps):
        parts += panel(sweep, [row for row in rows if row["sweep"] == sweep],
                       PANEL_WIDTH_PX * (i % PANELS_A_ROW), PANEL_HEIGHT_PX * (i // PANELS_A_ROW))
    return "\n".join(parts + ["</svg>"]) + "\n"
