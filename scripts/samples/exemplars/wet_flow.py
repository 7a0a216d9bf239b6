"""Thin-film flow in a growing wet area, carrying and settling pigments.

After Curtis, Anderson, Seims, Fleischer and Salesin, "Computer-Generated Watercolor", SIGGRAPH 1997.
Their shallow-water layer (section 4.3) is taken in its slow limit: viscous drag outweighs inertia, so
the velocity is minus the permeability times the pressure gradient, and the pressure follows from the
volume balance alone. Their wet-area mask and its capillary growth (4.1, 4.6) are a field of wetting
times; edge darkening (4.3.3) is the extra evaporation at the rim, which the flow must make good.
"""

import numpy as np
from scipy import ndimage
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import spsolve

COURANT_NUMBER = 0.45  # largest share of a cell that the flow crosses in one step


def harmonic_mean(a, b):
    """The permeability of a face between two cells, as of two resistances in series."""
    return 2.0 * a * b / (a + b)


def face_velocity(region, permeability, balance):
    """Velocity through cell faces, from div(u) = balance and u = -permeability grad(p).

    No flow leaves `region`; `balance` (water gained per cell and frame, sources positive) must sum to
    zero over it. Returns (across columns, across rows), shapes (rows, columns + 1), (rows + 1, columns).
    It stands for UpdateVelocities and RelaxDivergence of Curtis et al., sections 4.3.1 and 4.3.2.
    """
    rows, columns = region.shape
    number = np.cumsum(region.ravel()).reshape(region.shape) - 1
    count = int(region.sum())
    conductance_x = np.zeros((rows, columns + 1))
    conductance_y = np.zeros((rows + 1, columns))
    conductance_x[:, 1:-1] = harmonic_mean(permeability[:, 1:], permeability[:, :-1])
    conductance_x[:, 1:-1] *= region[:, 1:] & region[:, :-1]
    conductance_y[1:-1] = harmonic_mean(permeability[1:], permeability[:-1])
    conductance_y[1:-1] *= region[1:] & region[:-1]
    diagonal = conductance_x[:, 1:] + conductance_x[:, :-1] + conductance_y[1:] + conductance_y[:-1]
    entries = [(number[region], number[region], diagonal[region] + 1e-7)]  # the tiny term fixes the level
    joined = conductance_x[:, 1:-1] > 0
    a, b, weight = number[:, :-1][joined], number[:, 1:][joined], -conductance_x[:, 1:-1][joined]
    entries += [(a, b, weight), (b, a, weight)]
    joined = conductance_y[1:-1] > 0
    a, b, weight = number[:-1][joined], number[1:][joined], -conductance_y[1:-1][joined]
    entries += [(a, b, weight), (b, a, weight)]
    i, j, value = (np.concatenate(part) for part in zip(*entries))
    matrix = coo_matrix((value, (i, j)), shape=(count, count)).tocsc()
    pressure = np.zeros(region.shape)
    pressure[region] = spsolve(matrix, balance[region], permc_spec="MMD_AT_PLUS_A")
    across_columns = np.zeros_like(conductance_x)
    across_rows = np.zeros_like(conductance_y)
    across_columns[:, 1:-1] = -conductance_x[:, 1:-1] * np.diff(pressure, axis=1)
    across_rows[1:-1] = -conductance_y[1:-1] * np.diff(pressure, axis=0)
    return across_columns, across_rows


def refine_velocity(across_columns, across_rows, factor):
    """Face velocities on a grid `factor` times finer, in fine cells per frame."""

    def resample(field, fine_shape, offset):
        rows = (np.arange(fine_shape[0]) + 0.5 * (1 - offset[0])) / factor - 0.5 * (1 - offset[0])
        columns = (np.arange(fine_shape[1]) + 0.5 * (1 - offset[1])) / factor - 0.5 * (1 - offset[1])
        grid = np.meshgrid(rows, columns, indexing="ij")
        return ndimage.map_coordinates(field, grid, order=1, mode="nearest")

    rows, columns = across_columns.shape[0] * factor, across_rows.shape[1] * factor
    fine_columns = resample(across_columns, (rows, columns + 1), (0, 1)) * factor
    fine_rows = resample(across_rows, (rows + 1, columns), (1, 0)) * factor
    return fine_columns.astype(np.float32), fine_rows.astype(np.float32)


def _limited_flux(amount, velocity):
    """Amount carried through interior faces of the last axis; van Leer's limiter keeps fronts crisp."""
    step = np.diff(amount, axis=-1)
    behind, ahead = step[..., :-1], step[..., 1:]
    product = behind * ahead
    slope = np.where(product > 0, 2.0 * product / np.where(product > 0, behind + ahead, 1.0), 0.0)
    slope = np.pad(slope, [(0, 0)] * (amount.ndim - 1) + [(1, 1)])
    forward = amount[..., :-1] + 0.5 * (1.0 - velocity) * slope[..., :-1]
    backward = amount[..., 1:] - 0.5 * (1.0 + velocity) * slope[..., 1:]
    return velocity * np.where(velocity > 0, forward, backward)


def carry(amount, across_columns, across_rows):
    """Moves `amount` (pigments, rows, columns) in place with velocities in cells per step; keeps its sum.

    MovePigment of Curtis et al., section 4.4, with a flux of second order.
    """
    flux = _limited_flux(amount, across_columns[:, 1:-1])
    amount[..., :-1] -= flux
    amount[..., 1:] += flux
    turned = np.swapaxes(amount, -1, -2)
    flux = _limited_flux(turned, across_rows[1:-1].T)
    turned[..., :-1] -= flux
    turned[..., 1:] += flux


def close_dry_faces(wet, across_columns, across_rows):
    """Stops the flow at the edge of the wet area (velocity zero on its boundary, section 4.3.1)."""
    across_columns[:, 1:-1] *= wet[:, 1:] & wet[:, :-1]
    across_rows[1:-1] *= wet[1:] & wet[:-1]


def settle(suspended, settled, height, adhesion, granulation, staining, duration_frames):
    """Exchange between water and paper (Curtis et al., section 4.5, TransferPigment).

    `height` is the paper in 0..1: valleys collect more where `granulation` is high. `adhesion` is the
    share settling per frame (their density rho), `staining` their omega, how firmly it then holds.
    One value per pigment. Changes both arrays in place.
    """
    for k in range(suspended.shape[0]):
        rate = adhesion[k] * duration_frames
        down = suspended[k] * np.clip(1.0 - height * granulation[k], 0.0, 1.0) * rate
        up = settled[k] * np.clip(1.0 + (height - 1.0) * granulation[k], 0.0, 1.0) * rate / staining[k]
        suspended[k] += up - down
        settled[k] += down - up


class Wash:
    """A wet area that grows and the pigments in it.

    The fine grid has `cells_per_px` cells per picture pixel and carries the pigment; velocities are
    solved for on picture pixels. The water film keeps unit thickness, so an amount of pigment per
    cell is also its concentration; what the front and the evaporation take, the sources give.
    """

    def __init__(self, wetting_frame, permeability, paper_height, cells_per_px, recipe):
        """`wetting_frame` (fine grid) says when a cell gets wet; `permeability` is on picture pixels.

        `recipe` has: adhesion, granulation, staining (per pigment, see `settle`), rim_width_px,
        rim_evaporation (film thicknesses per frame), thinning (share of the demand that the inner
        film yields by growing thinner), diffusion_px2 (per frame).
        """
        self.wetting_frame = wetting_frame
        self.permeability = permeability
        low, high = np.quantile(paper_height, [0.01, 0.99])
        self.height = np.clip((paper_height - low) / (high - low), 0.0, 1.0).astype(np.float32)
        self.factor = cells_per_px
        self.recipe = recipe
        pigments = len(recipe["adhesion"])
        self.suspended = np.zeros((pigments,) + wetting_frame.shape, np.float32)
        self.settled = np.zeros_like(self.suspended)
        rows, columns = permeability.shape
        self._coarse_frame = wetting_frame.reshape(rows, self.factor, columns, self.factor).min(axis=(1, 3))

    def wet(self, frame):
        """Cells that are wet at a time."""
        return self.wetting_frame <= frame

    def _balance(self, frame, duration_frames, brush):
        """Water given and taken per picture pixel and frame; sums to zero over the wet region.

        The dry paper ahead of the front drinks what fills it; more evaporates near the rim, where the
        blurred wet mask falls off (FlowOutward, Curtis et al., section 4.3.3: their M - M').
        """
        region = self._coarse_frame <= frame + duration_frames
        wet = self._coarse_frame <= frame
        taken = (region & ~wet) / duration_frames
        blurred = ndimage.gaussian_filter(region.astype(float), self.recipe["rim_width_px"])
        taken = taken + self.recipe["rim_evaporation"] * np.clip(2.0 - 2.0 * blurred, 0.0, 1.0) * region
        brush = brush * region
        interior = smooth_interior(wet, self.recipe["rim_width_px"])
        surplus = brush.sum() - (1.0 - self.recipe["thinning"]) * taken.sum()
        if surplus > 0:  # a generous brush: the whole area evaporates a little
            taken = taken + surplus * region / region.sum()
        thinning = interior * (taken.sum() - brush.sum()) / max(interior.sum(), 1.0)
        return region, brush + thinning - taken

    def advance(self, frame, duration_frames, brush, charge):
        """Moves on from `frame`. `brush`: water added per picture pixel and frame; `charge`: the
        concentration of each pigment in that water (pigments, rows, columns)."""
        region, balance = self._balance(frame, duration_frames, brush)
        # The flow is solved for once, then the pigment follows it in steps of less than half a cell.
        velocity = refine_velocity(*face_velocity(region, self.permeability, balance), self.factor)
        speed = max(np.abs(velocity[0]).max(), np.abs(velocity[1]).max())
        steps = max(2, int(np.ceil(speed * duration_frames / COURANT_NUMBER)))
        step_frames = duration_frames / steps
        box = bounding_box(self.wet(frame + duration_frames), 3)
        inflow = np.kron(brush * charge, np.ones((self.factor, self.factor))).astype(np.float32)[(...,) + box]
        suspended, settled = self.suspended[(...,) + box], self.settled[(...,) + box]
        for step in range(steps):
            wet = self.wet(frame + step_frames * (step + 1))[box]
            across_columns = velocity[0][box[0], box[1].start : box[1].stop + 1] * np.float32(step_frames)
            across_rows = velocity[1][box[0].start : box[0].stop + 1, box[1]] * np.float32(step_frames)
            close_dry_faces(wet, across_columns, across_rows)
            suspended += inflow * np.float32(step_frames) * wet
            carry(suspended, across_columns, across_rows)
            np.clip(suspended, 0.0, None, out=suspended)
            if step % 4 == 3 or step == steps - 1:
                passed = step_frames * (step % 4 + 1)
                settle(suspended, settled, self.height[box], self.recipe["adhesion"], self.recipe["granulation"],
                       self.recipe["staining"], passed)
                self._diffuse(suspended, wet, passed)

    def _diffuse(self, suspended, wet, duration_frames):
        """Spreads the pigment within the wet area by a normalised blur."""
        variance_cells2 = 2.0 * self.recipe["diffusion_px2"] * duration_frames * self.factor**2
        if variance_cells2 <= 0:
            return
        sigma = np.sqrt(variance_cells2)
        weight = ndimage.gaussian_filter(wet.astype(np.float32), sigma, truncate=3) + 1e-6
        for k in range(suspended.shape[0]):
            total = suspended[k].sum()
            spread = ndimage.gaussian_filter(suspended[k] / weight * wet, sigma, truncate=3) * wet
            suspended[k] = spread * (total / max(spread.sum(), 1e-9))


def smooth_interior(wet, rim_width_px):
    """1 deep inside the wet area, 0 within about two rim widths of its edge."""
    depth = ndimage.distance_transform_edt(wet)
    interior = np.clip(depth / rim_width_px - 1.5, 0.0, 4.0)
    return interior if interior.any() else wet.astype(float)


def bounding_box(region, margin_cells):
    """Slices of the smallest rectangle around a region, with a margin, inside the grid."""
    slices = ndimage.find_objects(region.astype(int))[0]
    return tuple(
        slice(max(0, s.start - margin_cells), min(n, s.stop + margin_cells)) for s, n in zip(slices, region.shape)
    )
