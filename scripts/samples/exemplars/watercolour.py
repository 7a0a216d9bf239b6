"""The exemplar `watercolour`: a wash of ultramarine and violet that spreads over cold-pressed paper.

Flow, settling and edge darkening after Curtis et al. 1997 (see wet_flow.py); colours by the
Kubelka-Munk model of their section 5.
"""

import numpy as np
from scipy import ndimage

import common
import wet_flow

NAME = "watercolour"
WIDTH_PX, HEIGHT_PX, FRAME_COUNT = 400, 222, 24
CELLS_PER_PX = 2
WARM_UP_FRAMES = 4.0  # of simulation before the first picture
SOLVES_PER_FRAME = 2
FIRST_COVERAGE, LAST_COVERAGE = 0.075, 0.43
SEED = 1997
GROWTH_SEED = 2998  # chosen among a dozen for an outline without deep bays

# Absorption K and scattering S per unit thickness, linear RGB (Curtis et al., section 5.1, with
# values in the range of their figure 5): ultramarine, dioxazine violet, phthalo turquoise.
ABSORPTION = np.array([[1.05, 0.80, 0.13], [0.62, 1.20, 0.36], [1.30, 0.34, 0.22]])
SCATTERING = np.array([[0.010, 0.012, 0.080], [0.030, 0.010, 0.045], [0.006, 0.020, 0.020]])

RECIPE = {
    "adhesion": [0.20, 0.08, 0.025],  # share settling per frame
    "granulation": [0.97, 0.75, 0.10],
    "staining": [6.0, 3.0, 1.5],
    "rim_width_px": 4.0,
    "rim_evaporation": 0.36,  # film thicknesses per frame
    "thinning": 0.35,
    "diffusion_px2": 0.35,  # per frame
}

GRAIN_CONTRAST = 0.7  # how much thicker the dry pigment lies in the valleys than on the peaks

# Drops from the brush: (row px, column px, radius px, first frame, last frame, water per frame, charge).
# Water is in film thicknesses per pixel at the centre; the charge scales the pigments' concentration.
# Drops of clean water push the pigment aside and leave backruns.
DROPS = [
    (106, 164, 20, -9, 30, 0.26, (0.75, 0.20, 0.45)),
    (118, 220, 17, -9, 30, 0.24, (0.70, 0.95, 0.20)),
    (100, 132, 12, 1, 9, 0.45, (1.30, 0.15, 0.50)),
    (126, 174, 9, 4, 9, 0.95, (0.0, 0.0, 0.0)),
    (102, 240, 11, 7, 13, 0.55, (0.9, 1.0, 0.10)),
    (88, 192, 9, 10, 15, 1.00, (0.0, 0.0, 0.10)),
    (130, 250, 10, 13, 19, 0.90, (0.0, 0.1, 0.0)),
    (114, 126, 11, 11, 17, 0.85, (0.1, 0.0, 0.5)),
    (136, 200, 10, 15, 22, 0.50, (1.4, 0.5, 0.1)),
]


def wetting_frames(shape_px):
    """When each picture pixel gets wet (frames): capillary growth from one stroke of the brush."""
    lobes = common.fractal_noise(shape_px, [26, 12, 5, 2], [0.75, 0.85, 0.62, 0.34], GROWTH_SEED)
    starts = [(104 + k, 146 + 6 * k, 0.0) for k in range(16)]
    slowness = np.exp(0.52 * common.calmed(lobes, starts, 14)) * common.margin_slowness(shape_px, 32, 9.0)
    cost = common.without_narrow_bays(common.arrival_cost(slowness, starts), 2.0)
    cost = ndimage.gaussian_filter(cost, 0.9)
    coverage = common.growing_coverage(FIRST_COVERAGE, LAST_COVERAGE, FRAME_COUNT, 0.86)
    return common.frames_from_cost(cost, coverage), lobes


def brush_at(frame, shape_px):
    """Water per picture pixel and frame, and the charge of each pigment in it, at a time."""
    rows, columns = np.indices(shape_px)
    ragged = np.exp(0.5 * common.fractal_noise(shape_px, [9, 4], [1, 0.6], SEED + 7))
    water = np.zeros(shape_px)
    charge = np.zeros((len(ABSORPTION),) + shape_px)
    for row, column, radius, first, last, strength, pigments in DROPS:
        swing = np.clip((frame - first) / 2.0, 0, 1) * np.clip((last - frame) / 2.0, 0, 1)
        distance2 = ((rows - row) ** 2 + (columns - column) ** 2) / radius**2
        drop = strength * swing * np.exp(-0.5 * distance2 * ragged)
        drop[drop < 0.01 * strength] = 0.0
        water += drop
        charge += drop * np.array(pigments)[:, None, None]
    return water, charge / np.maximum(water, 1e-6)


def kubelka_munk_over(thickness, absorption, scattering, ground):
    """Linear RGB of one pigment layer over a ground (Curtis et al., section 5.2)."""
    a = 1.0 + absorption / scattering
    b = np.sqrt(a * a - 1.0)
    depth = np.clip(b * scattering * thickness[..., None], 1e-6, 30.0)
    sinh, cosh = np.sinh(depth), np.cosh(depth)
    below = a * sinh + b * cosh
    reflectance, transmittance = sinh / below, b / below
    return reflectance + transmittance**2 * ground / (1.0 - reflectance * ground)


def paper_picture(height):
    """The dry paper under raking light: linear RGB, warm white."""
    white = common.linear_from_srgb([0.955, 0.935, 0.890])
    light = common.hillshade(height, 0.24)
    return white * light[..., None] ** 0.55


def picture(wash, frame, dry_paper):
    """One frame in linear RGB on picture pixels."""
    age = frame - wash.wetting_frame
    inside = common.smoothstep(-0.18, 0.12, age)
    moist = inside * np.exp(-np.clip(age, 0, None) / 5.0)
    colour = dry_paper * (1.0 - 0.07 * moist[..., None])
    hollow = 1.0 + GRAIN_CONTRAST * (0.55 - wash.height)  # the film fills the valleys, peaks stick out
    for k in (2, 1, 0):
        suspended = ndimage.gaussian_filter(wash.suspended[k], 0.6)
        thickness = 1.15 * (suspended * hollow**0.4 + wash.settled[k] * hollow)
        colour = kubelka_munk_over(thickness, ABSORPTION[k], SCATTERING[k], colour)
    return common.shrink(colour, wash.factor)


def generate(directory):
    """Writes all frames and masks below `directory`."""
    shape_px = (HEIGHT_PX, WIDTH_PX)
    shape = (HEIGHT_PX * CELLS_PER_PX, WIDTH_PX * CELLS_PER_PX)
    coarse_frames, lobes = wetting_frames(shape_px)
    rows, columns = np.indices(shape)
    centre = (CELLS_PER_PX - 1) / 2.0
    wetting = ndimage.map_coordinates(
        coarse_frames, [(rows - centre) / CELLS_PER_PX, (columns - centre) / CELLS_PER_PX], order=3, mode="nearest"
    )
    height = common.cold_press_height(shape, CELLS_PER_PX, SEED + 2)
    streaks = common.fractal_noise(shape_px, [7, 3, 1.5], [1, 0.9, 0.6], SEED + 3)
    permeability = np.exp(-0.45 * lobes + 0.75 * streaks)
    wash = wet_flow.Wash(wetting, permeability, height, CELLS_PER_PX, RECIPE)

    start = wash.wet(-WARM_UP_FRAMES)
    mottle = np.exp(0.45 * common.fractal_noise(shape, [30, 12, 5], [1, 1, 0.5], SEED + 4))
    for k, amount in enumerate((0.75, 0.55, 0.40)):
        wash.suspended[k] = amount * mottle * start

    writer = common.ExemplarWriter(directory)
    dry_paper = paper_picture(height)
    duration = 1.0 / SOLVES_PER_FRAME
    for tick in range(round(-WARM_UP_FRAMES * SOLVES_PER_FRAME), (FRAME_COUNT - 1) * SOLVES_PER_FRAME + 1):
        frame = tick * duration
        if tick >= 0 and tick % SOLVES_PER_FRAME == 0:
            mask = common.clean_mask(common.shrink(wash.wet(frame).astype(float), CELLS_PER_PX) > 0.5)
            writer.add(picture(wash, frame, dry_paper), mask)
        if tick < (FRAME_COUNT - 1) * SOLVES_PER_FRAME:
            wash.advance(frame, duration, *brush_at(frame, shape_px))
