"""What the sample exemplars share: noise, paper, growth of the covered area, light, and PNG files.

Conventions. Arrays are indexed [row, column], the origin is the top left corner. Lengths called `_px`
are pixels of the finished picture; lengths called `_cells` are cells of the grid at hand, which is
finer where a simulation is supersampled. Times are counted in frames of the clip. Colours are linear
RGB in 0..1 unless a name says sRGB. Every random number comes from a generator with a fixed seed, so
a second run writes the same bytes.
"""

import pathlib

import numpy as np
from PIL import Image, ImageDraw
from scipy import ndimage
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import dijkstra

SMALLEST_SPECK_PX = 40  # islands and holes of a mask below this area are removed


# --- noise ---------------------------------------------------------------------------------------


def smooth_noise(shape, scale_cells, seed):
    """Gaussian random field of mean 0 and deviation 1; details are about `scale_cells` wide."""
    values = np.random.default_rng(seed).standard_normal(shape)
    if scale_cells > 0:
        values = ndimage.gaussian_filter(values, scale_cells, mode="wrap")
    return (values - values.mean()) / values.std()


def fractal_noise(shape, scales_cells, weights, seed):
    """Weighted sum of smooth noises, one per scale, brought to mean 0 and deviation 1."""
    total = np.zeros(shape)
    for index, (scale, weight) in enumerate(zip(scales_cells, weights)):
        total += weight * smooth_noise(shape, scale, [seed, index])
    return (total - total.mean()) / total.std()


def smoothstep(low, high, value):
    """Cubic ramp: 0 at `low`, 1 at `high`, without kinks."""
    t = np.clip((value - low) / (high - low), 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


def sample_bilinear(field, row, column):
    """Reads `field` at fractional positions; positions outside take the nearest edge."""
    return ndimage.map_coordinates(field, [row, column], order=1, mode="nearest")


def warped(field, amount_cells, scale_cells, seed):
    """Shifts `field` by a random displacement, which takes the regularity out of an outline."""
    rows, columns = np.indices(field.shape).astype(float)
    rows += amount_cells * smooth_noise(field.shape, scale_cells, [seed, 0])
    columns += amount_cells * smooth_noise(field.shape, scale_cells, [seed, 1])
    return sample_bilinear(field, rows, columns)


# --- surfaces ------------------------------------------------------------------------------------


def cold_press_height(shape, cells_per_px, seed):
    """Height field of cold-pressed paper, mean 0, deviation 1: felt bumps 4 to 9 px across.

    Curtis et al. 1997, section 4.1, build theirs from noise too. The felt of the press leaves
    broad rounded bumps between narrow dips; the exponential skews the noise that way.
    """
    bumps = 1.0 * smooth_noise(shape, 2.1 * cells_per_px, [seed, 0])
    bumps += 0.85 * smooth_noise(shape, 1.05 * cells_per_px, [seed, 1])
    bumps += 0.55 * smooth_noise(shape, 4.5 * cells_per_px, [seed, 2])
    bumps = warped(bumps, 0.8 * cells_per_px, 3 * cells_per_px, seed + 1)
    height = -np.exp(-0.28 * bumps / bumps.std())
    return (height - height.mean()) / height.std()


def fibre_strands(shape, count, length_range_px, width_range_px, cells_per_px, seed, bend_rad_per_px=0.012):
    """Random curved strands: the coverage 0..1 of a mat of fibres, or of scratches if nearly straight.

    Each strand is a walk whose direction drifts by about `bend_rad_per_px`; the walks are drawn three
    times finer than the grid, later strands on top of earlier ones.
    """
    random = np.random.default_rng(seed)
    zoom = 3
    size = (shape[1] * zoom, shape[0] * zoom)
    canvas = Image.new("F", size, 0.0)
    draw = ImageDraw.Draw(canvas)
    step_px = 3.0
    for _ in range(count):
        x = random.uniform(-20, shape[1] / cells_per_px + 20)
        y = random.uniform(-20, shape[0] / cells_per_px + 20)
        # Paper machines leave a weak grain direction: the strands prefer the horizontal.
        angle = random.uniform(0, 2 * np.pi)
        angle -= 0.18 * np.sin(2 * angle)
        bend = random.normal(0, bend_rad_per_px)
        steps = int(random.uniform(*length_range_px) / step_px)
        points = []
        for _ in range(steps):
            points.append((x * cells_per_px * zoom, y * cells_per_px * zoom))
            bend += random.normal(0, 0.8 * bend_rad_per_px)
            bend *= 0.97
            angle += bend * step_px
            x += step_px * np.cos(angle)
            y += step_px * np.sin(angle)
        width = random.uniform(*width_range_px) * cells_per_px * zoom
        level = random.uniform(0.35, 1.0)
        draw.line(points, fill=level, width=max(1, round(width)), joint="curve")
    fine = np.asarray(canvas, dtype=np.float32)
    return fine.reshape(shape[0], zoom, shape[1], zoom).mean(axis=(1, 3)).astype(float)


def hillshade(height, relief, light_azimuth_rad=np.deg2rad(225.0)):
    """Light raking over a height field: 1 on level ground, more towards the light, less away.

    The light stands top left (azimuth 225 degrees, row axis down). `relief` scales the slopes.
    """
    slope_row, slope_column = np.gradient(height)
    facing = slope_column * np.cos(light_azimuth_rad) + slope_row * np.sin(light_azimuth_rad)
    facing = -relief * facing
    return 1.0 - facing / np.sqrt(1.0 + facing * facing)


# --- growth --------------------------------------------------------------------------------------

# Knight moves and the next ring beside the eight neighbours: 32 directions keep the fronts round.
_STEPS = [(0, 1), (1, 0), (1, 1), (1, -1), (1, 2), (2, 1), (1, -2), (2, -1), (1, 3), (3, 1), (1, -3),
          (3, -1), (2, 3), (3, 2), (2, -3), (3, -2)]


def arrival_cost(slowness, starts):
    """Least travel cost from `starts` to every cell: first-passage growth through a random medium.

    `slowness` is the cost per cell of length; `starts` is a list of (row, column, head start).
    Shortest paths on a grid graph with 32 directions, so that no axis shows in the outline.
    """
    rows, columns = slowness.shape
    index = np.arange(rows * columns).reshape(rows, columns)
    source, target, cost = [], [], []
    for step_row, step_column in _STEPS:
        length = np.hypot(step_row, step_column)
        low, high = max(0, -step_column), columns - max(0, step_column)
        here = (slice(0, rows - step_row), slice(low, high))
        there = (slice(step_row, rows), slice(low + step_column, high + step_column))
        source.append(index[here].ravel())
        target.append(index[there].ravel())
        if length > 1.5:
            middle = ndimage.shift(slowness, (-step_row / 2, -step_column / 2), order=1, mode="nearest")[here]
            mean = 0.25 * (slowness[here] + slowness[there]) + 0.5 * middle
        else:
            mean = 0.5 * (slowness[here] + slowness[there])
        cost.append((length * mean).ravel())
    outside = rows * columns  # one more node, from which all starts are reached
    for row, column, head_start in starts:
        source.append(np.array([outside]))
        target.append(index[int(row), int(column)].reshape(1))
        cost.append(np.array([max(head_start, 1e-6)]))
    graph = coo_matrix(
        (np.concatenate(cost), (np.concatenate(source), np.concatenate(target))), shape=(outside + 1,) * 2
    ).tocsr()
    return dijkstra(graph, directed=False, indices=outside)[:outside].reshape(rows, columns)


def margin_slowness(shape, margin_cells, strength):
    """Factor >= 1 that slows growth near the rim of the picture, so that bare surface remains."""
    rows, columns = np.indices(shape)
    inset = np.minimum.reduce([rows, columns, shape[0] - 1 - rows, shape[1] - 1 - columns])
    return 1.0 + strength * np.clip(1.0 - inset / margin_cells, 0.0, None) ** 2


def calmed(noise, starts, radius_cells):
    """Fades `noise` out within about `radius_cells` of the starts, so that the first shape is plump."""
    away = np.ones(noise.shape, bool)
    for row, column, _ in starts:
        away[int(row), int(column)] = False
    distance = ndimage.distance_transform_edt(away)
    return noise * smoothstep(0.3 * radius_cells, 1.7 * radius_cells, distance)


def without_narrow_bays(cost, radius_cells):
    """Grey opening of a travel cost with a disc: places that narrow arms would enclose or leave as slits
    less than two radii wide are reached together with their surroundings."""
    reach = int(np.ceil(radius_cells))
    rows, columns = np.mgrid[-reach : reach + 1, -reach : reach + 1]
    return ndimage.grey_opening(cost, footprint=rows**2 + columns**2 <= radius_cells**2)


def frames_from_cost(cost, coverage_of_frame):
    """Turns travel cost into the time, in frames, at which a cell is reached.

    `coverage_of_frame[k]` is the wanted covered share of the picture at frame k; it must rise.
    """
    thresholds = np.quantile(cost, coverage_of_frame)
    frames = np.arange(len(coverage_of_frame), dtype=float)
    step = thresholds[-1] - thresholds[-2]
    before = frames[0] + (cost - thresholds[0]) / (thresholds[1] - thresholds[0])
    after = frames[-1] + (cost - thresholds[-1]) / step
    inside = np.interp(cost, thresholds, frames)
    return np.where(cost < thresholds[0], before, np.where(cost > thresholds[-1], after, inside))


def growing_coverage(first, last, frame_count, exponent):
    """Covered share per frame; its square root (a radius) runs from first to last as t**exponent."""
    t = np.linspace(0.0, 1.0, frame_count) ** exponent
    return (np.sqrt(first) + (np.sqrt(last) - np.sqrt(first)) * t) ** 2


# --- masks, colours, files -----------------------------------------------------------------------


def shrink(values, factor):
    """Box-filters a fine grid down to picture pixels; works on (rows, columns[, channels])."""
    rows, columns = values.shape[0] // factor, values.shape[1] // factor
    return values.reshape(rows, factor, columns, factor, *values.shape[2:]).mean(axis=(1, 3))


def clean_mask(inside):
    """Boolean mask with a smooth outline, without specks and pinholes."""
    soft = ndimage.gaussian_filter(inside.astype(float), 0.8)
    mask = soft > 0.5
    for value in (True, False):
        labels, count = ndimage.label(mask == value)
        if count:
            areas = ndimage.sum_labels(np.ones(mask.shape), labels, np.arange(1, count + 1))
            small = 1 + np.flatnonzero(areas < SMALLEST_SPECK_PX)
            mask = np.where(np.isin(labels, small), not value, mask)
    return mask


def linear_from_srgb(srgb):
    """IEC 61966-2-1 transfer function, code values 0..1 to linear light."""
    srgb = np.asarray(srgb, dtype=float)
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def srgb_from_linear(linear):
    """IEC 61966-2-1 transfer function, linear light to code values 0..1."""
    linear = np.clip(linear, 0.0, 1.0)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


class ExemplarWriter:
    """Writes rgb/%05d.png and mask/%05d.png below one directory, counting from 1."""

    def __init__(self, directory):
        self._directory = pathlib.Path(directory)
        self._count = 0
        for kind in ("rgb", "mask"):
            (self._directory / kind).mkdir(parents=True, exist_ok=True)
            for stale in (self._directory / kind).glob("*.png"):
                stale.unlink()

    def add(self, linear_rgb, mask):
        """Appends one frame: linear RGB in 0..1 and a boolean mask of the same size."""
        self._count += 1
        name = f"{self._count:05d}.png"
        code = np.round(srgb_from_linear(linear_rgb) * 255.0).astype(np.uint8)
        Image.fromarray(code, "RGB").save(self._directory / "rgb" / name, optimize=True)
        grey = Image.fromarray(np.where(mask, 255, 0).astype(np.uint8), "L")
        grey.save(self._directory / "mask" / name, optimize=True)
