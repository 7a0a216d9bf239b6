"""A girl waves: four swings of her raised arm in a loop of 60 frames, drawn in layers.

Each swing starts in the shoulder; elbow, wrist and fingers follow one after the other, and so do the head and the
pony tail. The hips sway once for every two swings; the other hand rests on the hip. Lengths in px, angles in
degrees, on screen: 0 to the right, -90 up.
"""

import math

import numpy as np

from vector import Canvas, direction, mix, place, rotate, spline

SIZE = (640, 740)
FRAMES = 60
ZOOM = 0.885
ZOOM_ABOUT = (330.0, 380.0)
SWINGS = 4
SWAYS = 2
FILLETS = {"trousers": 6.0, "shoes": 4.0, "shirt": 6.0, "skin": 2.0, "hair": 5.0}  # px

GROUND = 716.0
CENTRE_X = 284.0
HIP_Y = 432.0
WAIST_RISE = 66.0  # px, waist above the hips
CHEST_RISE = 176.0  # px, line of the shoulders above the hips
NECK_LENGTH = 34.0
HEAD_RISE = 62.0  # px, middle of the head above the top of the neck

HIP_HALF = 30.0
LEG_LENGTHS = (132.0, 124.0)  # thigh, shin
KNEES_OUT = 0.3  # share of the bend of the knees that is seen
LEG_RADII = (36.0, 26.5, 21.0)  # hip, knee, ankle
STANCE_HALF = 46.0  # px, from the middle to an ankle
PELVIS = np.array([
    (-52, -36), (0, -42), (52, -36), (67, 0), (58, 40), (14, 46), (0, 52), (-14, 46), (-58, 40), (-67, 0)], float)
SHOULDER_HALF = 64.0
UPPER_ARM = 100.0
FOREARM = 92.0
SLEEVE_LENGTH = 0.62  # share of the upper arm
ARM_SEEN_FROM = 0.66  # share of the upper arm where the bare arm comes out of the sleeve
SLEEVE_RADII = (28.0, 25.0)
FOREARM_RADII = (20.0, 15.0)

HEAD = np.array([
    (0, -70), (40, -58), (55, -18), (50, 26), (28, 55), (0, 65), (-28, 55), (-50, 26), (-55, -18), (-40, -58)], float)
EARS = ((54.0, 6.0), (-54.0, 6.0))
HAIR = np.array([
    (0, -84), (40, -74), (65, -42), (69, 0), (62, 24), (52, 4), (44, -24), (14, -36), (-22, -26), (-46, -8), (-54, 20),
    (-65, 24), (-70, -4), (-66, -42), (-42, -74)], float)
TAIL_ROOT = (-54.0, -52.0)
TAIL_LENGTH = 150.0
TAIL_RADII = ((0.0, 17), (0.3, 27), (0.65, 25), (1.0, 8))

PALM_RADIUS = 23.0
# Fingers: angle from the axis of the hand, length from the middle of the palm, radius.
FINGERS = ((-39.0, 60.0, 11.0), (-13.0, 69.0, 11.5), (13.0, 68.0, 11.5), (38.0, 58.0, 11.0))
THUMB = (-86.0, 48.0, 11.5)


def swing(index, lag, turns=SWINGS):
    """Sine of the wave of the arm, `lag` frames late."""
    return math.sin(2.0 * math.pi * turns * (index - lag) / FRAMES)


def knee(hip, ankle, side):
    """Joint between a thigh and a shin of given lengths; it bends to the viewer, a little of it outwards."""
    thigh, shin = LEG_LENGTHS
    reach = min(float(np.linalg.norm(ankle - hip)), thigh + shin - 0.5)
    along = (ankle - hip) / reach
    share = (thigh**2 - shin**2 + reach**2) / (2.0 * reach)
    out = math.sqrt(max(0.0, thigh**2 - share**2))
    return hip + along * share + KNEES_OUT * out * side * np.array([along[1], -along[0]])


def draw_hand(canvas, wrist, angle, lag_angle):
    """An open hand; its fingers bend sideways behind the movement."""
    palm = wrist + 22.0 * direction(angle)
    canvas.capsule(wrist, palm, FOREARM_RADII[1], PALM_RADIUS)
    for spread, length, radius in FINGERS + (THUMB,):
        middle = palm + 0.55 * length * direction(angle + spread)
        tip = middle + 0.45 * length * direction(angle + spread + lag_angle)
        canvas.stroke([palm, middle, tip], (radius + 1.0, radius, radius - 0.5))


def frame(index):
    skin, hair, shirt, trousers, shoes = (Canvas(SIZE, ZOOM, ZOOM_ABOUT) for _ in range(5))

    # Hips sway from leg to leg and dip twice as often.
    sway = swing(index, 0.0, SWAYS)
    dip = 0.5 - 0.5 * swing(index, 1.5, SWINGS)
    hips = np.array([CENTRE_X + 15.0 * sway, HIP_Y + 9.0 * dip])
    hip_tilt = -4.0 * sway
    chest_lean = -5.0 * swing(index, 2.0, SWAYS) - 2.0 * swing(index, 1.0)
    waist = hips + rotate([(0.0, -WAIST_RISE)], 0.4 * chest_lean)[0]
    chest = waist + rotate([(0.0, WAIST_RISE - CHEST_RISE)], chest_lean)[0]
    chest_tilt = 0.7 * chest_lean - 2.0 * swing(index, 0.5)

    # Legs and shoes.
    for side in (-1.0, 1.0):
        hip = hips + rotate([(side * HIP_HALF, 0.0)], hip_tilt)[0]
        ankle = np.array([CENTRE_X + side * STANCE_HALF, GROUND - 34.0])
        joint = knee(hip, ankle, side)
        trousers.stroke([hip, joint, ankle], LEG_RADII)
        toe = ankle + np.array([side * 34.0, 17.0])
        shoes.stroke([ankle + np.array([-side * 4.0, 12.0]), toe], (22.0, 17.0))
        # A flat sole.
        heel_x, toe_x = sorted((ankle[0] - side * 22.0, toe[0] + side * 10.0))
        shoes.polygon([(heel_x, GROUND - 16.0), (toe_x, GROUND - 16.0), (toe_x, GROUND), (heel_x, GROUND)])
    trousers.polygon(hips + rotate(spline(PELVIS, closed=True), hip_tilt))

    # Shirt: a spline through the shoulders, the waist and the hem, which follows the hips.
    def upper(x, y):
        return chest + rotate([(x, y)], chest_tilt)[0]

    def middle(x, y):
        return waist + rotate([(x, y)], 0.5 * (chest_tilt + hip_tilt))[0]

    def lower(x, y):
        return hips + rotate([(x, y)], hip_tilt)[0]

    shirt.blob([
        upper(0, -14), upper(40, -16), upper(74, 2), upper(72, 46), middle(52, -26), middle(50, 6), lower(61, -26),
        lower(67, 0), lower(0, 8), lower(-67, 0), lower(-61, -26), middle(-50, 6), middle(-52, -26), upper(-72, 46),
        upper(-74, 2), upper(-40, -16)])

    # The resting arm: from the shoulder out to the elbow and back to the hip.
    shoulder = upper(-SHOULDER_HALF, 14.0)
    hand = lower(-62.0, -14.0)
    reach = hand - shoulder
    distance = float(np.linalg.norm(reach))
    share = (UPPER_ARM**2 - FOREARM**2 + distance**2) / (2.0 * distance)
    out = math.sqrt(max(0.0, UPPER_ARM**2 - share**2))
    normal = np.array([-reach[1], reach[0]]) / distance
    elbow = shoulder + reach / distance * share + normal * out
    shirt.capsule(shoulder, mix(shoulder, elbow, SLEEVE_LENGTH), *SLEEVE_RADII)
    skin.stroke([mix(shoulder, elbow, ARM_SEEN_FROM), elbow, hand], (21.0, 20.0, 17.0))
    skin.capsule(hand, hand + np.array([30.0, 12.0]), 18.0, 14.0)

    # The waving arm: each joint a little later than the one before.
    shoulder = upper(SHOULDER_HALF, 12.0 - 5.0 * swing(index, 0.5))
    upper_angle = -13.0 + 7.0 * swing(index, 0.0)
    elbow = shoulder + UPPER_ARM * direction(upper_angle)
    fore_angle = -75.0 + 25.0 * swing(index, 1.2)
    wrist = elbow + FOREARM * direction(fore_angle)
    hand_angle = fore_angle + 4.0 + 15.0 * swing(index, 3.6)
    finger_bend = 12.0 * swing(index, 5.0)
    shirt.capsule(shoulder, mix(shoulder, elbow, SLEEVE_LENGTH), *SLEEVE_RADII)
    skin.stroke([mix(shoulder, elbow, ARM_SEEN_FROM), elbow, wrist], (21.0, *FOREARM_RADII))
    draw_hand(skin, wrist, hand_angle, finger_bend)

    # Neck and head; the head leans against the sway and nods with the swings.
    neck = upper(0.0, -NECK_LENGTH)
    head_tilt = 7.0 * swing(index, 4.0, SWAYS) + 2.0 * swing(index, 3.0)
    head = neck + rotate([(0.0, -HEAD_RISE + 3.0 * dip)], head_tilt)[0]
    skin.capsule(upper(0.0, 6.0), mix(neck, head, 0.4), 25.0, 23.0)
    skin.polygon(place(spline(HEAD, closed=True), head, head_tilt))
    for ear in EARS:
        skin.circle(place([ear], head, head_tilt)[0], 13.0)
    hair.polygon(place(spline(HAIR, closed=True), head, head_tilt))

    # The pony tail swings last and widest.
    u = np.linspace(0.0, 1.0, 20)
    phases = np.array([swing(index, 6.0 + 5.0 * v, SWAYS) * 0.8 + swing(index, 4.0 + 4.0 * v) * 0.5 for v in u])
    heading = np.radians(head_tilt - 192.0 - 64.0 * u**0.7 - (6.0 + 20.0 * u) * phases)
    steps = np.stack([np.cos(heading), np.sin(heading)], axis=1) * TAIL_LENGTH / len(u)
    line = place([TAIL_ROOT], head, head_tilt)[0] + np.cumsum(steps, axis=0)
    hair.stroke(line, np.interp(u, *zip(*TAIL_RADII)))

    layers = {"trousers": trousers, "shoes": shoes, "shirt": shirt, "skin": skin, "hair": hair}
    return {name: canvas.mask(FILLETS[name]) for name, canvas in layers.items()}
