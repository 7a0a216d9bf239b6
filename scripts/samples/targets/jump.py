"""A rabbit-like blob crouches, leaps along an arc, lands with a squash, leaps again and comes to rest.

The body keeps its area: what it gains along one axis it loses across it. The ears are chains that lag behind.
"""

import math

import numpy as np

from vector import Canvas, Track, mix, place, rotate, spline

SIZE = (700, 300)
FRAMES = 60
GROUND = 284.0  # px

# Take-off and landing: (frame of take-off, frame of landing, x there, x here, height of the arc), px.
LEAPS = ((9.0, 25.0, 104.0, 344.0, 90.0), (33.0, 49.0, 344.0, 594.0, 96.0))
STAND = 54.0  # px, height of the body's centre over the ground when at rest

# Stretch along the body's long axis (across it: the inverse); 1 at rest. < 1: squashed.
STRETCH = Track([
    (0, 1.0), (1.5, 1.03), (6.5, 0.66), (8, 0.78), (9.5, 1.34), (12, 1.24), (17, 0.98), (22, 1.16),
    (25, 1.34), (26.6, 0.68), (28, 0.63), (29.5, 0.69), (31.5, 0.84), (33.5, 1.36), (36, 1.24), (41, 0.97),
    (46, 1.16), (49, 1.36), (50.6, 0.67), (52, 0.64), (54.5, 1.13), (57, 0.95), (59, 1.01)])
# Lean of the long axis from the vertical, degrees, positive to the right.
LEAN = Track([
    (0, 0), (3, -5), (7, -9), (9.5, 26), (12, 34), (17, 2), (22, -24), (25, -17), (27.5, 2), (30.5, -8), (33.5, 25),
    (36, 33), (41, 2), (46, -25), (49, -18), (51.5, 4), (54.5, -5), (57, 2), (59, 0)])

BODY = np.array([  # px about its centre, upright; the head is the upper part
    (0, -56), (26, -52), (42, -34), (42, -12), (46, 10), (52, 30), (36, 48), (0, 52), (-38, 50), (-56, 32), (-50, 8),
    (-36, -14), (-32, -38), (-20, -52)], float) * 0.95
TAIL = (-54.0, 26.0)  # px in the body's upright shape
TAIL_RADIUS = 13.0
FOOT_RADII = (10.5, 9.0)  # px, heel and toe
FEET = ((-16.0, 38.0), (22.0, 40.0))  # px, hips in the body's upright shape
FOOT_LENGTH = 26.0
# Where the feet point and how far they hang below the hips during a leap (share of the leap: angle, px).
FOOT_ANGLE = Track([(0, 78), (0.2, 84), (0.5, 20), (0.8, -22), (1, 0)])
FOOT_DROP = Track([(0, 26), (0.2, 24), (0.5, 10), (0.8, 20), (1, 24)])

EAR_ROOTS = ((-4.0, -44.0), (14.0, -46.0))  # px in the body's upright shape
EAR_LINKS = 7
EAR_LINK = 9.0  # px
EAR_RADII = (9.5, 12.0, 9.5)  # px at the root, half way and at the tip
EAR_REST = (-112.0, -72.0)  # degrees of the ears when at rest
EAR_STIFFNESS = 0.22  # share of the way back to rest in each step
EAR_DRAG = 0.55  # share of the movement kept from step to step
STEPS = 4  # of the ears in each frame
FILLET = 4.0  # px


def leap_at(time):
    """The leap under way at this time and the share of it that has passed, or (None, 0)."""
    for leap in LEAPS:
        if leap[0] <= time <= leap[1]:
            return leap, (time - leap[0]) / (leap[1] - leap[0])
    return None, 0.0


def body_scale(time):
    stretch = STRETCH(time)
    return np.array([1.0 / stretch, stretch])


def body_centre(time):
    """On the ground the underside stays on the ground however the body is squashed; in the air it flies a parabola."""
    leap, share = leap_at(time)
    if leap is not None:
        x = mix(leap[2], leap[3], share)
        rise = leap[4] * 4.0 * share * (1.0 - share)
        return np.array([x, GROUND - STAND * 1.2 - rise])
    x = LEAPS[0][2]
    for start, end, x_from, x_to, _ in LEAPS:
        if time > end:
            x = x_to
    # The body goes down with the squash, and rocks back a little before it leaps, forward after it lands.
    return np.array([x + 0.35 * LEAN(time), GROUND - STAND * STRETCH(time) * 0.90 - 4.0])


def blended_centre(time):
    """`body_centre` smoothed over two frames: no corner in the path at take-off and landing."""
    offsets = np.linspace(-1.0, 1.0, 9)
    weights = 1.0 - np.abs(offsets) * 0.9
    return sum(w * body_centre(max(0.0, time + o)) for w, o in zip(weights, offsets)) / weights.sum()


def on_body(points, time):
    """Points of the upright body shape, in the frame; nothing sinks into the ground."""
    placed = place(rotate(np.atleast_2d(points) * body_scale(time), LEAN(time)), blended_centre(time))
    return np.minimum(placed, (np.inf, GROUND))


def simulate_ears():
    """Positions of the ear joints for every frame: chains pulled along by the head, springing back to rest."""
    ears = []
    for root, rest in zip(EAR_ROOTS, EAR_REST):
        def target(time):
            angle = rest + LEAN(time)
            step = EAR_LINK * np.array([math.cos(math.radians(angle)), math.sin(math.radians(angle))])
            return on_body(root, time)[0] + np.arange(EAR_LINKS)[:, None] * step

        joints = target(0.0)
        before = joints.copy()
        frames = []
        for tick in range(FRAMES * STEPS):
            if tick % STEPS == 0:
                frames.append(joints.copy())
            goal = target((tick + 1) / STEPS)
            softness = np.linspace(1.0, 0.35, EAR_LINKS)[:, None]
            moved = joints + (joints - before) * EAR_DRAG + (goal - joints) * EAR_STIFFNESS * softness
            before, joints = joints, moved
            joints[0] = goal[0]
            for i in range(1, EAR_LINKS):  # links keep their length
                link = joints[i] - joints[i - 1]
                joints[i] = joints[i - 1] + link * EAR_LINK / max(float(np.linalg.norm(link)), 1e-6)
        ears.append(frames)
    return ears


EARS = simulate_ears()


def frame(index):
    canvas = Canvas(SIZE)
    time = float(index)
    canvas.polygon(on_body(spline(BODY, closed=True), time))
    canvas.circle(np.minimum(on_body(TAIL, time)[0], (np.inf, GROUND - TAIL_RADIUS)), TAIL_RADIUS)

    leap, share = leap_at(time)
    soles = []
    for hip in FEET:
        top = on_body(hip, time)[0]
        if leap is None:
            heel = np.array([top[0] - 4.0, GROUND - FOOT_RADII[0]])
            angle = 0.0
        else:
            drop = rotate([(0.0, FOOT_DROP(share))], LEAN(time) * 1.1)[0]
            heel = top + drop
            angle = FOOT_ANGLE(share) + LEAN(time)
            heel[1] = min(heel[1], GROUND - FOOT_RADII[0])
        toe = heel + rotate([(FOOT_LENGTH, 0.0)], angle)[0]
        toe[1] = min(toe[1], GROUND - FOOT_RADII[1])
        canvas.capsule(top, heel, 15.0, FOOT_RADII[0])
        canvas.capsule(heel, toe, *FOOT_RADII)
        soles += [heel, toe]
    if leap is None:  # it sits flat on the ground
        canvas.capsule(soles[0], soles[-1], *FOOT_RADII)

    links = np.linspace(0.0, 1.0, EAR_LINKS)
    for frames in EARS:
        canvas.stroke(frames[index], np.interp(links, (0.0, 0.55, 1.0), EAR_RADII))
    return canvas.mask(FILLET)
