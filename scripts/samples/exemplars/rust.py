"""The exemplar `rust`: corrosion that eats under the paint of a steel plate and lifts it off.

Not a fluid: the front is a first-passage growth through a surface of uneven protection, and what lies
behind it is a relief of scale, pits and powder whose parts age from fresh orange to dark brown. The
shape of every flake is fixed; only its age changes, so the crust stays where it is.
"""

import numpy as np
from scipy import ndimage
from scipy.spatial import cKDTree

import common

NAME = "rust"
SIZE_PX, FRAME_COUNT = 256, 30
CELLS_PER_PX = 2
FIRST_COVERAGE, LAST_COVERAGE = 0.055, 0.52
SEED = 1911
CURL_WIDTH_PX = (0.9, 3.6)  # of the paint lifted along the edge, inside the mask: least and most
GAP_WIDTH_PX = 2.2  # shadow under the lifted paint

PAINT = common.linear_from_srgb([0.415, 0.560, 0.535])
PAINT_EDGE = common.linear_from_srgb([0.70, 0.76, 0.70])
GRIME = common.linear_from_srgb([0.26, 0.30, 0.25])
# Colours of rust from fresh to old (sRGB), met at the ages given by STAGES.
STAGES = np.array([0.0, 0.18, 0.36, 0.55, 0.75, 1.0])
COLOURS = common.linear_from_srgb(
    [[0.93, 0.62, 0.26], [0.84, 0.46, 0.15], [0.68, 0.33, 0.12], [0.50, 0.235, 0.11], [0.35, 0.175, 0.10],
     [0.20, 0.115, 0.085]]
)
POWDER = common.linear_from_srgb([0.86, 0.60, 0.33])
PIT = common.linear_from_srgb([0.095, 0.060, 0.050])


def flakes(shape, spacing_px, seed):
    """Plates of scale: Voronoi cells of jittered points, seen through a warp.

    Returns (cell number, distance to the border between plates in cells, offsets from the plate's centre).
    """
    spacing = spacing_px * CELLS_PER_PX
    random = np.random.default_rng(seed)
    rows, columns = np.meshgrid(*(np.arange(-spacing, n + spacing, spacing) for n in shape), indexing="ij")
    points = np.stack([rows.ravel(), columns.ravel()], axis=1)
    points += random.uniform(-0.5, 0.5, points.shape) * spacing
    where = np.stack(np.indices(shape), axis=-1).astype(float)
    for axis in range(2):
        where[..., axis] += 0.30 * spacing * common.fractal_noise(shape, [0.45 * spacing, 0.16 * spacing], [1, 0.6],
                                                                  [seed, axis])
    distance, number = cKDTree(points).query(where.reshape(-1, 2), k=2)
    border = (distance[:, 1] - distance[:, 0]).reshape(shape)
    offset = (where.reshape(-1, 2) - points[number[:, 0]]).reshape(shape + (2,))
    return number[:, 0].reshape(shape), border, offset


def tilted_plates(shape, spacing_px, seed):
    """Height of plates that each stand at their own level and slope; (height, per-plate random, border)."""
    number, border, offset = flakes(shape, spacing_px, seed)
    random = np.random.default_rng([seed, 9])
    count = number.max() + 1
    level, chance = random.normal(0, 1, count), random.uniform(0, 1, count)
    slope = random.normal(0, 1, (count, 2)) / (spacing_px * CELLS_PER_PX)
    height = level[number] + (slope[number] * offset).sum(axis=-1) * 1.5
    return height, chance[number], border


class Plate:
    """All that does not change: the paint, the plan of the growth, the relief of the crust."""

    def __init__(self, shape):
        scale = CELLS_PER_PX
        self.paint_height = self._paint_relief(shape)
        self.paint_colour = self._paint_colour(shape)
        coarse, coarse_chance, coarse_border = tilted_plates(shape, 11.0, SEED + 2)
        fine, fine_chance, fine_border = tilted_plates(shape, 4.6, SEED + 3)
        self.grain = common.fractal_noise(shape, [1.0 * scale, 0.5 * scale], [1, 0.5], SEED + 4)
        lumps = common.fractal_noise(shape, [12 * scale, 5 * scale, 2.2 * scale], [0.8, 1, 0.9], SEED + 5)
        self.lumps = lumps
        cracks = np.exp(-((coarse_border / (1.1 * scale)) ** 2)) + 0.5 * np.exp(-((fine_border / (0.8 * scale)) ** 2))
        self.cracks = np.clip(cracks, 0, 1)
        plates = np.where(coarse_chance > 0.45, coarse, 0.0)
        self.crust = ndimage.gaussian_filter(0.75 * plates + 0.55 * fine * (fine_chance > 0.3), 0.35 * scale)
        self.crust += 0.9 * lumps + 0.28 * self.grain - 0.8 * self.cracks
        pits = common.fractal_noise(shape, [4.5 * scale, 1.6 * scale], [1, 0.55], SEED + 6)
        self.pits = common.smoothstep(1.15, 1.75, pits + 0.25 * lumps)
        hue_scales = [20 * scale, 7 * scale, 2.5 * scale, scale]
        self.hue = common.fractal_noise(shape, hue_scales, [0.9, 1, 0.7, 0.4], SEED + 7)
        curl = common.fractal_noise(shape, [7 * scale, 2.5 * scale], [1.0, 0.6], SEED + 10)
        self.curl_px = CURL_WIDTH_PX[0] + (CURL_WIDTH_PX[1] - CURL_WIDTH_PX[0]) * common.smoothstep(-1.2, 1.8, curl)
        bleaching = common.fractal_noise(shape, [9 * scale, 3 * scale], [1, 0.7], SEED + 17)
        self.bleaching = common.smoothstep(0.0, 1.5, bleaching)
        self.stain_colour = rust_colour(np.clip(0.42 + 0.13 * self.hue, 0, 1))
        self.powder = common.fractal_noise(shape, [9 * scale, 3 * scale, 1.2 * scale], [1, 0.8, 0.6], SEED + 8)
        # Each plate of scale breaks through a little before or after its surroundings.
        self.plate_delay = 2.2 * (coarse_chance - 0.5) + 1.2 * (fine_chance - 0.5)
        self.rusting_frame = self._plan(shape, coarse_chance)

    @staticmethod
    def _scratches(shape):
        """Coverage 0..1 by fine scratches, most of them short."""
        long_ones = common.fibre_strands(shape, 26, (40, 220), (0.35, 0.7), CELLS_PER_PX, SEED + 12, 0.0005)
        short_ones = common.fibre_strands(shape, 150, (6, 28), (0.4, 0.9), CELLS_PER_PX, SEED + 14, 0.002)
        return np.maximum(long_ones, short_ones)

    @staticmethod
    def _paint_relief(shape):
        """Sprayed paint: orange peel, grains of dust, scratches. Height, deviation about 1."""
        scale = CELLS_PER_PX
        peel = common.fractal_noise(shape, [2.4 * scale, 1.2 * scale, 10 * scale], [1.0, 0.5, 0.6], SEED + 11)
        scratches = Plate._scratches(shape)
        dust = common.smoothstep(2.6, 3.6, common.smooth_noise(shape, 0.75 * scale, SEED + 13))
        return peel - 2.2 * ndimage.gaussian_filter(scratches, 0.5) + 2.5 * dust

    @staticmethod
    def _paint_colour(shape):
        """Weathered paint: chalky clouds, grime that ran down, primer showing in the scratches."""
        scale = CELLS_PER_PX
        clouds = common.fractal_noise(shape, [45 * scale, 16 * scale, 5 * scale, 1.6 * scale], [1, 0.9, 0.7, 0.5],
                                      SEED + 1)
        streaks = np.random.default_rng(SEED + 15).standard_normal(shape)
        streaks = ndimage.gaussian_filter(streaks, (20 * scale, 1.4 * scale), mode="wrap")
        streaks = common.warped(streaks / streaks.std(), 1.0 * scale, 12 * scale, SEED + 16)
        grime = common.smoothstep(-0.2, 2.4, 0.35 * streaks + 0.9 * clouds)[..., None]
        chalk = common.smoothstep(-0.3, 2.4, -clouds + 0.2 * streaks)[..., None]
        scratches = ndimage.gaussian_filter(Plate._scratches(shape), 0.4)
        colour = PAINT * (1 - 0.30 * grime) + 0.30 * grime * GRIME
        colour = colour * (1 - 0.22 * chalk) + 0.22 * chalk * PAINT_EDGE
        return colour * (1 - 0.35 * scratches[..., None]) + 0.35 * scratches[..., None] * PAINT_EDGE

    @staticmethod
    def _plan(shape, plate_chance):
        """When each cell starts to rust (frames)."""
        scale = CELLS_PER_PX
        uneven = common.fractal_noise(shape, [24 * scale, 10 * scale, 4 * scale, 1.7 * scale], [0.9, 0.9, 0.7, 0.45],
                                      SEED + 9)
        scratch = [(108 + 4.0 * k, 98 + 4.2 * k + 4 * np.sin(k)) for k in range(10)]
        starts = [(row * scale, column * scale, 0.0) for row, column in scratch]
        uneven = common.calmed(0.55 * uneven + 0.5 * (plate_chance - 0.5), starts, 11 * scale)
        slowness = np.exp(uneven) * common.margin_slowness(shape, 34 * scale, 7.0)
        cost = ndimage.gaussian_filter(common.arrival_cost(slowness, starts), 0.9)
        return common.frames_from_cost(cost, common.growing_coverage(FIRST_COVERAGE, LAST_COVERAGE, FRAME_COUNT, 0.92))


def rust_colour(stage):
    """Linear RGB of rust at a stage 0 (fresh) .. 1 (old)."""
    return np.stack([np.interp(stage, STAGES, COLOURS[:, c]) for c in range(3)], axis=-1)


def picture(plate, frame):
    """One frame in linear RGB on picture pixels."""
    scale = CELLS_PER_PX
    age = frame - plate.rusting_frame
    inside = age > 0
    # Depth behind the edge in px, negative on the paint; from distances, so that the lip has one width.
    depth = (ndimage.distance_transform_edt(inside) - ndimage.distance_transform_edt(~inside)) / scale
    depth = ndimage.gaussian_filter(depth, 0.8 * scale)
    ragged = depth + 0.9 * plate.lumps * common.smoothstep(-0.2, 2.0, depth)
    bare = common.smoothstep(plate.curl_px - 0.8, plate.curl_px + 0.5, ragged)
    lip = common.smoothstep(-0.7, 0.5, depth) * (1.0 - bare)
    gap = bare * np.exp(-((np.clip(ragged - plate.curl_px, 0, None) / GAP_WIDTH_PX) ** 2))

    crust_age = np.clip(age + plate.plate_delay - 1.0, 0.0, None)
    grown = 1.0 - np.exp(-crust_age / 5.0)
    old = 1.0 - np.exp(-crust_age / 12.0)
    height = plate.paint_height * 0.30 * (1.0 - bare)
    height += 3.4 * lip * common.smoothstep(-0.7, 2.6, depth)
    height += bare * (plate.crust * (0.7 + 1.9 * grown) + 1.8 * grown - 1.2 - 3.0 * plate.pits * grown)
    light = common.hillshade(ndimage.gaussian_filter(height, 0.35 * scale), 0.60)
    light = np.clip(light, 0.12, 1.75)

    stage = 0.06 + 0.80 * old + 0.135 * plate.hue * (0.6 + 0.6 * grown) + 0.10 * plate.cracks - 0.05 * plate.crust
    rust = rust_colour(np.clip(stage, 0.0, 1.0))
    powder = common.smoothstep(0.7, 1.9, plate.powder + 0.35 * plate.crust)[..., None] * (0.25 + 0.5 * grown)[..., None]
    rust = rust * (1 - powder) + POWDER * powder
    hollow = np.clip(plate.pits * grown + 0.55 * plate.cracks * grown, 0, 1)[..., None]
    rust = rust * (1 - 0.85 * hollow) + PIT * 0.85 * hollow
    rust *= (1.0 - 0.72 * gap)[..., None]

    # In places the lifted paint bleaches, elsewhere rust water stains it from below.
    bleach = (lip * plate.bleaching)[..., None]
    paint = plate.paint_colour * (1 - 0.55 * bleach) + PAINT_EDGE * 0.55 * bleach
    stain = (lip * (1.0 - 0.8 * plate.bleaching) * common.smoothstep(-0.2, 0.9, depth / plate.curl_px))[..., None]
    paint = paint * (1 - 0.85 * stain) + plate.stain_colour * 0.85 * stain
    colour = paint * (1 - bare[..., None]) + rust * bare[..., None]
    return common.shrink(colour * light[..., None], scale), inside


def generate(directory):
    """Writes all frames and masks below `directory`."""
    plate = Plate((SIZE_PX * CELLS_PER_PX,) * 2)
    writer = common.ExemplarWriter(directory)
    for frame in range(FRAME_COUNT):
        colour, inside = picture(plate, float(frame))
        writer.add(colour, common.clean_mask(common.shrink(inside.astype(float), CELLS_PER_PX) > 0.5))
