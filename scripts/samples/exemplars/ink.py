"""The exemplar `ink`: blue-black ink bleeding along the fibres of a damp, soft paper.

The flow is that of wet_flow.py with a permeability that follows the fibres. The ink is a mixture of
three dyes held back by the paper in different degrees, as in paper chromatography: the brown-black
stays near the drop, a violet travels further, a teal runs with the water to the feathered rim.
"""

import numpy as np
from scipy import ndimage

import common
import wet_flow

NAME = "ink"
WIDTH_PX, HEIGHT_PX, FRAME_COUNT = 320, 240, 30
CELLS_PER_PX = 2
WARM_UP_FRAMES = 4.0  # of simulation before the first picture
SOLVES_PER_FRAME = 1
FIRST_COVERAGE, LAST_COVERAGE = 0.045, 0.46
SEED = 1844
GROWTH_SEED = 2349  # chosen among several for an outline without deep bays

# Beer-Lambert absorption per unit amount, linear RGB: brown-black, violet, teal.
ABSORPTION = np.array([[2.30, 2.55, 2.75], [0.85, 1.80, 0.45], [1.55, 0.42, 0.48]])

RECIPE = {
    "adhesion": [0.40, 0.13, 0.02],  # share taken up by the fibres per frame: the retardation
    "granulation": [0.45, 0.40, 0.30],
    "staining": [5.0, 2.0, 1.2],
    "rim_width_px": 6.0,
    "rim_evaporation": 0.06,  # film thicknesses per frame
    "thinning": 0.30,
    "diffusion_px2": 0.30,  # per frame
}

# The drops of ink: (row px, column px, radius px, first frame, last frame, water per frame).
DROPS = [(122, 146, 17, -9, 40, 0.34), (106, 184, 13, -9, 40, 0.34), (142, 176, 9, 5, 15, 0.6),
         (128, 118, 9, 11, 21, 0.6), (94, 160, 8, 17, 27, 0.6)]
CHARGE = np.array([1.25, 0.85, 0.55])  # concentration of the three dyes in the bottle
DENSITY_LIMIT = 4.3  # optical density (natural log) at which the pulp is full of dye


def fibre_mat(shape):
    """The paper on the fine grid: (coverage by fibres 0..1, by the thick ones alone, height, pulp).

    Height and pulp (the cloudy mass between the fibres) have mean 0 and deviation 1.
    """
    long_strands = common.fibre_strands(shape, 1500, (40, 150), (0.7, 1.4), CELLS_PER_PX, SEED + 1)
    fine_strands = common.fibre_strands(shape, 2600, (15, 70), (0.35, 0.7), CELLS_PER_PX, SEED + 2)
    wicks = common.fibre_strands(shape, 130, (60, 180), (1.1, 1.7), CELLS_PER_PX, SEED + 6, 0.005)
    coverage = np.maximum.reduce([long_strands, 0.7 * fine_strands, wicks])
    pulp = common.fractal_noise(shape, [14, 6, 2.5], [0.7, 0.8, 0.5], SEED + 3)
    height = ndimage.gaussian_filter(coverage, 0.7) * 3.2 + 0.30 * pulp
    return coverage, wicks, (height - height.mean()) / height.std(), pulp


def wetting_frames(coverage, wicks, pulp):
    """When each fine cell gets wet (frames): capillary growth that runs ahead along the fibres."""
    shape = coverage.shape
    lobes = common.fractal_noise(shape, [44, 20, 8], [0.8, 0.8, 0.5], GROWTH_SEED)
    places = [(122, 146), (118, 156), (113, 166), (109, 176), (106, 184)]
    starts = [(row * CELLS_PER_PX, column * CELLS_PER_PX, 0.0) for row, column in places]
    uneven = common.calmed(0.42 * lobes + 0.15 * pulp, starts, 16 * CELLS_PER_PX)
    speed = 0.25 + 0.75 * ndimage.gaussian_filter(coverage, 0.7) + 0.9 * ndimage.gaussian_filter(wicks, 0.7)
    slowness = np.exp(uneven) / speed
    slowness *= common.margin_slowness(shape, 34 * CELLS_PER_PX, 9.0)
    cost = common.without_narrow_bays(common.arrival_cost(slowness, starts), 1.6 * CELLS_PER_PX)
    cost = ndimage.gaussian_filter(cost, 0.9)
    share = common.growing_coverage(FIRST_COVERAGE, LAST_COVERAGE, FRAME_COUNT, 0.80)
    return common.frames_from_cost(cost, share), lobes


def brush_at(frame, shape_px):
    """Water per picture pixel and frame, and the concentration of each dye in it, at a time."""
    rows, columns = np.indices(shape_px)
    water = np.zeros(shape_px)
    for row, column, radius, first, last, strength in DROPS:
        swing = np.clip((frame - first) / 3.0, 0, 1) * np.clip((last - frame) / 3.0, 0, 1)
        drop = strength * swing * np.exp(-0.5 * ((rows - row) ** 2 + (columns - column) ** 2) / radius**2)
        water += np.where(drop > 0.01 * strength, drop, 0.0)
    weaker = 0.45 + 0.55 * np.exp(-(frame + WARM_UP_FRAMES) / 10.0)  # the drop is drained of its dye
    return water, np.ones((3,) + shape_px) * (CHARGE * weaker)[:, None, None]


def paper_picture(coverage, height, pulp):
    """The paper before the ink, linear RGB: cream, each fibre lit from the top left."""
    cream = common.linear_from_srgb([0.935, 0.905, 0.835])
    light = common.hillshade(ndimage.gaussian_filter(height, 0.5), 0.17)
    body = 1.0 + 0.055 * (coverage - coverage.mean()) / coverage.std() * 0.6 + 0.018 * pulp
    return cream * (light**0.6 * body)[..., None]


def picture(wash, frame, paper, coverage):
    """One frame in linear RGB on picture pixels (Beer-Lambert through ink and fibre)."""
    age = frame - wash.wetting_frame
    inside = common.smoothstep(-0.25, 0.35, age)
    damp = inside * (0.35 + 0.65 * np.exp(-np.clip(age, 0, None) / 4.0))
    amount = wash.suspended + wash.settled
    # Fibres take the dye up more readily than the pulp between them, and hold more of it.
    fibre = ndimage.gaussian_filter(coverage, 0.6)
    density = np.moveaxis(np.tensordot(ABSORPTION.T, amount * (0.62 + 0.95 * fibre), axes=1), 0, -1)
    limit = DENSITY_LIMIT * (0.70 + 0.75 * fibre)[..., None] * np.array([1.04, 1.06, 0.92])
    density = limit * (1.0 - np.exp(-density / limit))
    colour = paper * (1.0 - 0.10 * damp[..., None]) * np.exp(-density)
    # The densest ink still reflects a little, most where a fibre stands up.
    gloss = common.linear_from_srgb([0.055, 0.052, 0.080]) * (0.55 + 0.9 * coverage)[..., None]
    return common.shrink(np.maximum(colour, 0) * (1 - gloss) + gloss * inside[..., None], wash.factor)


def generate(directory):
    """Writes all frames and masks below `directory`."""
    shape_px = (HEIGHT_PX, WIDTH_PX)
    shape = (HEIGHT_PX * CELLS_PER_PX, WIDTH_PX * CELLS_PER_PX)
    coverage, wicks, height, pulp = fibre_mat(shape)
    wetting, lobes = wetting_frames(coverage, wicks, pulp)
    conduits = common.shrink(coverage, CELLS_PER_PX)
    permeability = (0.10 + 1.2 * conduits**1.5) * np.exp(-0.3 * common.shrink(lobes + pulp, CELLS_PER_PX))
    wash = wet_flow.Wash(wetting, permeability, -height, CELLS_PER_PX, RECIPE)

    start = wash.wet(-WARM_UP_FRAMES)
    mottle = np.exp(0.3 * common.fractal_noise(shape, [20, 8], [1, 1], SEED + 4))
    for k, amount in enumerate(CHARGE):
        wash.suspended[k] = 2.0 * amount * mottle * start

    writer = common.ExemplarWriter(directory)
    paper = paper_picture(coverage, height, pulp)
    duration = 1.0 / SOLVES_PER_FRAME
    for tick in range(round(-WARM_UP_FRAMES * SOLVES_PER_FRAME), (FRAME_COUNT - 1) * SOLVES_PER_FRAME + 1):
        frame = tick * duration
        if tick >= 0 and tick % SOLVES_PER_FRAME == 0:
            mask = common.clean_mask(common.shrink(wash.wet(frame).astype(float), CELLS_PER_PX) > 0.5)
            writer.add(picture(wash, frame, paper, coverage), mask)
        if tick < (FRAME_COUNT - 1) * SOLVES_PER_FRAME:
            wash.advance(frame, duration, *brush_at(frame, shape_px))
