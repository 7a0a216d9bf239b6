"""A horse gallops on the spot, seen from its right side: five strides in 72 frames, and the last flows into the first.

The stride starts when the right hind hoof lands; left hind, right fore and left fore follow, then the horse flies
with its legs gathered under it (a transverse gallop). Every joint has a periodic curve of key angles. Leg angles
count from straight down, positive forward (to the right); lengths are px of the horse drawn at SCALE 1, where it
stands about 400 px at the withers.
"""

import math

import numpy as np

from vector import Canvas, Track, direction, mix, place, rotate, spline

SIZE = (1000, 800)
FRAMES = 72
STRIDES = 5  # in FRAMES; no common divisor, so no two frames are equal

SCALE = 0.908
CENTRE = (516.0, 380.0)  # px in the frame: centre of the trunk, on average
GROUND = 305.0  # px below the trunk's mean height where hooves stand
FILLET = 7.0  # px, smoothness of the union

# Share of the stride at which each hoof lands.
FOOTFALLS = {"right hind": 0.0, "left hind": 0.13, "right fore": 0.38, "left fore": 0.53}
STANCE = 0.24  # share of the stride that a hoof stays on the ground
FAR_SIDE_SHIFT = np.array([10.0, -7.0])  # px, where the joints of the left (far) legs lie

# Key angles over one stride of a leg; 0 is its own footfall.
PHASES = (0.00, 0.08, 0.16, 0.24, 0.32, 0.42, 0.52, 0.62, 0.72, 0.81, 0.90)
HIND_KEYS = {
    "thigh":  (56, 42, 26, 8, -2, 2, 18, 34, 48, 61, 66),
    "gaskin": (-14, -26, -38, -52, -64, -74, -76, -69, -58, -40, -19),
    "cannon": (30, 14, -8, -34, -58, -62, -40, -15, 5, 26, 40),
    "pastern": (52, 62, 52, 6, -62, -96, -92, -68, -36, 6, 42),
}
FORE_KEYS = {
    "shoulder": (8, 0, -9, -16, -20, -17, -8, 2, 9, 13, 12),
    "forearm": (36, 16, -8, -30, -36, -22, 6, 34, 56, 62, 52),
    "cannon":  (34, 14, -10, -36, -70, -98, -96, -68, -28, 16, 40),
    "pastern": (54, 58, 44, -2, -76, -134, -144, -116, -64, -2, 46),
}

# Length and radii (at the upper and the lower end) of the limb segments.
HIND_SHAPE = {
    "thigh": (112, 60, 40), "gaskin": (110, 38, 18), "cannon": (94, 16, 13.5), "pastern": (36, 13.5, 12.5)}
FORE_SHAPE = {
    "shoulder": (124, 50, 32), "forearm": (106, 31, 16), "cannon": (78, 16, 13.5), "pastern": (35, 13.5, 12.5)}
HOOF = np.array([(-14, -6), (12, -8), (22, 20), (21, 25), (-12, 25), (-16, 18)], float)
HOOF_LENGTH = 25.0

HIP = np.array([-136.0, -20.0])
SHOULDER = np.array([108.0, -36.0])
LOIN = np.array([-70.0, -50.0])  # the pelvis turns about this point
BUTTOCK = np.array([-172.0, -18.0])
HAM_RADIUS = 27.0
FLANK = np.array([-76.0, 16.0])
FLANK_RADIUS = 34.0
NECK_BASE = np.array([118.0, -40.0])
POLL = np.array([250.0, -196.0])

TRUNK = np.array([
    (104, -100), (70, -92), (14, -76), (-40, -76), (-96, -88), (-146, -86), (-186, -62), (-205, -24), (-196, 8),
    (-156, 34), (-104, 40), (-60, 54), (10, 74), (80, 86), (134, 78), (174, 46), (188, 2), (164, -60)], float)
NECK = np.array([
    (40, -78), (92, -108), (142, -146), (194, -190), (246, -214), (280, -192), (264, -148), (222, -114), (192, -70),
    (184, -10), (150, 40), (80, 10)], float)
# Along +x from the poll to the muzzle; the forehead is on the side of -y.
HEAD = np.array([
    (-14, -4), (22, -21), (58, -24), (104, -15), (140, -14), (164, -9), (174, 6), (168, 21), (156, 31), (140, 32),
    (122, 23), (92, 27), (66, 47), (36, 54), (8, 44)], float)
EAR = np.array([(-11, 4), (-12, -16), (-5, -34), (3, -46), (9, -34), (13, -16), (13, 4)], float)

# Motion of the body over the stride: (phase, value).
BOB = Track([(0.0, 2), (0.15, 10), (0.35, 4), (0.6, 12), (0.78, -8), (0.9, -10)], 1.0)  # px, down
PITCH = Track([(0.0, -1.0), (0.2, -4.0), (0.42, -1.0), (0.62, 4.0), (0.82, 2.0)], 1.0)  # degrees, nose down
PELVIS = Track([(0.0, -7), (0.2, -1), (0.4, 5), (0.6, 3), (0.8, -5), (0.92, -9)], 1.0)  # degrees, < 0: tucked under
NECK_NOD = Track([(0.0, -3), (0.2, -5), (0.42, 1), (0.62, 8), (0.82, 3)], 1.0)  # degrees, nose down
HEAD_NOD = Track([(0.05, 0), (0.28, -3), (0.5, -2), (0.7, 5), (0.88, 2)], 1.0)
HEAD_ANGLE = 42.0  # degrees below the horizontal

TAIL_LENGTH = 235.0
TAIL_RADII = ((0.0, 17), (0.15, 17), (0.35, 23), (0.6, 27), (0.8, 22), (1.0, 7))
MANE_ROOTS = (0.08, 0.29, 0.50, 0.71, 0.92)  # shares of the crest
CREST = np.array([(84, -100), (142, -142), (194, -184), (240, -206)], float)
MANE_LENGTH = 92.0
LOCK_RADII = ((0.0, 19), (0.4, 16), (1.0, 6))


def tracks(keys):
    return {bone: Track(list(zip(PHASES, angles)), 1.0) for bone, angles in keys.items()}


HIND = tracks(HIND_KEYS)
FORE = tracks(FORE_KEYS)


def grip(phase):
    """How firmly the hoof is held to the ground at this phase of its leg: 1 during the stance, eased around it."""
    centre = STANCE / 2.0
    distance = abs((phase - centre + 0.5) % 1.0 - 0.5)
    return float(np.clip((STANCE / 2.0 + 0.10 - distance) / 0.10, 0.0, 1.0)) ** 2


def leg(canvas, to_frame, pivot, angles, shape, phase, ground):
    """Draw one leg from its pivot down; returns its joints. All in px of the horse but for `canvas`."""
    joints = [pivot]
    for bone, (length, _, _) in shape.items():
        joints.append(joints[-1] + length * direction(90.0 - angles[bone](phase)))
    hoof_angle = angles["pastern"](phase) * 0.9 - 38.0
    # On the ground the sole lies flat.
    hold = grip(phase)
    hoof_angle = mix(hoof_angle, 0.0, hold)
    hoof = rotate(HOOF, -hoof_angle)
    # Stretch or shorten the leg a little so that the hoof meets the ground.
    height = max(1.0, joints[-1][1] - pivot[1])
    stretch = mix(1.0, (ground - HOOF_LENGTH - pivot[1]) / height, hold)
    joints = [pivot + (joint - pivot) * np.array([1.0, stretch]) for joint in joints]
    for (_, upper, lower), a, b in zip(shape.values(), joints, joints[1:]):
        canvas.capsule(to_frame(a), to_frame(b), upper * SCALE, lower * SCALE)
    canvas.polygon(to_frame(joints[-1] + hoof))
    return joints


def tail(canvas, to_frame, root, stride):
    """A waving train of hair: the wave runs from the root to the tip, the tip swings widest."""
    u = np.linspace(0.0, 1.0, 26)
    wave = 2.0 * math.pi * (stride - 0.75 * u)
    # Heading of the tail along its length: up at the dock, over the arch, then streaming back.
    heading = 180.0 + 26.0 * (1.0 - u * 5.0).clip(-0.8, 1.0) + (4.0 + 20.0 * u) * np.sin(wave)
    steps = np.stack([np.cos(np.radians(heading)), np.sin(np.radians(heading))], axis=1) * TAIL_LENGTH / len(u)
    line = root + np.cumsum(steps, axis=0)
    radii = np.interp(u, *zip(*TAIL_RADII)) * SCALE
    canvas.stroke(to_frame(line), radii)
    # A second strand leaves it half way and lags behind.
    branch = u[12:] - u[12]
    drop = 34.0 + 16.0 * math.sin(2.0 * math.pi * (stride - 0.7))
    lag = line[12:] + branch[:, None] * np.array([6.0, drop])
    canvas.stroke(to_frame(lag), np.interp(branch, (0.0, 0.25, 0.5), (20.0, 17.0, 7.0)) * SCALE)


def mane(canvas, to_frame, crest, stride):
    """Overlapping locks blown back from the crest."""
    line = spline(crest)
    for k, share in enumerate(MANE_ROOTS):
        root = line[int(share * (len(line) - 1))]
        u = np.linspace(0.0, 1.0, 8)
        wave = 16.0 * np.sin(2.0 * math.pi * (stride - 0.35 * u - 0.11 * k))
        heading = 192.0 + wave - 30.0 * u
        steps = np.stack([np.cos(np.radians(heading)), np.sin(np.radians(heading))], axis=1) * MANE_LENGTH / len(u)
        radii = np.interp(u, *zip(*LOCK_RADII)) * SCALE
        canvas.stroke(to_frame(root + np.cumsum(steps, axis=0)), radii)


def frame(index):
    stride = STRIDES * index / FRAMES
    canvas = Canvas(SIZE)
    pitch, bob = PITCH(stride), BOB(stride)

    def to_frame(points):
        return rotate(np.asarray(points, float), pitch) * SCALE + np.array(CENTRE) + np.array([0.0, bob * SCALE])

    def ground_below(x):
        """Ground line in horse coordinates at x, which lean with the body."""
        return (GROUND - bob - x * math.sin(math.radians(pitch))) / math.cos(math.radians(pitch))

    # Trunk: the part behind the loin turns with the pelvis, the more the farther back.
    pelvis = PELVIS(stride)

    def with_pelvis(points):
        points = np.atleast_2d(points)
        share = np.clip((LOIN[0] + 40.0 - points[:, :1]) / 120.0, 0.0, 1.0)
        return mix(points, rotate(points, pelvis, LOIN), share)

    canvas.polygon(to_frame(spline(with_pelvis(TRUNK), closed=True)))

    # Neck: its points turn about the base, the more the farther up.
    nod = NECK_NOD(stride)

    def with_neck(points):
        points = np.atleast_2d(points)
        share = np.clip((points[:, :1] - 60.0) / 110.0, 0.0, 1.0)
        return mix(points, rotate(points, nod, NECK_BASE), share)

    canvas.polygon(to_frame(spline(with_neck(NECK), closed=True)))

    poll = with_neck(POLL)[0]
    head_angle = HEAD_ANGLE + nod * 0.4 + HEAD_NOD(stride)
    canvas.polygon(to_frame(place(spline(HEAD, closed=True), poll, head_angle)))
    flick = 5.0 * math.sin(2.0 * math.pi * (stride - 0.2))
    canvas.polygon(to_frame(place(spline(EAR, closed=True), poll + np.array([6.0, -12.0]), 12.0 + nod + flick)))

    mane(canvas, to_frame, with_neck(CREST), stride)
    tail(canvas, to_frame, with_pelvis((-192.0, -62.0))[0], stride)

    hip = with_pelvis(HIP)[0]
    for name, footfall in FOOTFALLS.items():
        far = FAR_SIDE_SHIFT if name.startswith("left") else 0.0
        phase = (stride - footfall) % 1.0
        if name.endswith("hind"):
            joints = leg(canvas, to_frame, hip + far, HIND, HIND_SHAPE, phase, ground_below(hip[0]))
            # Hamstrings behind the thigh, and the fold of skin between the flank and the stifle.
            hamstrings = [with_pelvis(BUTTOCK)[0], mix(joints[1], joints[2], 0.3)]
            canvas.stroke(to_frame(hamstrings), HAM_RADIUS * SCALE)
            canvas.stroke(to_frame([FLANK, joints[1]]), FLANK_RADIUS * SCALE)
        else:
            leg(canvas, to_frame, SHOULDER + far, FORE, FORE_SHAPE, phase, ground_below(SHOULDER[0]))
    return canvas.mask(FILLET)
