"""A film and an animation small enough to be painted in a moment, made with nothing but Python."""

import pathlib
import random
import struct
import zlib


def png_bytes(width, height, channels, rows):
    """An 8-bit PNG file. rows: bytes of the pixels, one object a row; channels: 1 (gray) or 3 (RGB)."""

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    color_type = {1: 0, 3: 2}[channels]
    header = struct.pack(">IIBBBBB", width, height, 8, color_type, 0, 0, 0)
    pixels = zlib.compress(b"".join(b"\0" + row for row in rows))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", pixels) + chunk(b"IEND", b"")


def is_whole_png(data):
    """Whether all chunks are there with their check sums, and the pixels can be unpacked."""
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        return False
    pixels, at, name = b"", 8, b""
    while at + 12 <= len(data):
        (length,) = struct.unpack(">I", data[at : at + 4])
        name, content = data[at + 4 : at + 8], data[at + 8 : at + 8 + length]
        check = data[at + 8 + length : at + 12 + length]
        if check != struct.pack(">I", zlib.crc32(name + content)):
            return False
        if name == b"IDAT":
            pixels += content
        at += 12 + length
    try:
        zlib.decompress(pixels)
    except zlib.error:
        return False
    return name == b"IEND" and at == len(data)


def disc(width, height, x, y, radius, inside, outside):
    """Rows of a picture; inside and outside give the bytes of a pixel."""
    rows = []
    for py in range(height):
        row = b""
        for px in range(width):
            near = (px - x) ** 2 + (py - y) ** 2 <= radius**2
            row += (inside if near else outside)(px, py)
        rows.append(row)
    return rows


def make(folder, side, frames, film_frames=5, seed=1):
    """Writes folder/src, folder/mask and folder/target. side: of the animation's frames, px."""
    colors = random.Random(seed)
    cells = [[bytes(colors.randrange(40, 200) for _ in range(3)) for _ in range(side)] for _ in range(side)]
    paper, black, white = b"\xf0\xee\xe6", b"\x00", b"\xff"
    film = max(24, side * 3 // 4)
    for name in ("src", "mask", "target"):
        (folder / name).mkdir(parents=True)
    for k in range(film_frames):
        at = (film / 2, film / 2, film / 5 + k * film / 50)
        picture = disc(film, film, *at, lambda x, y: cells[y // 3][x // 3], lambda x, y: paper)
        mask = disc(film, film, *at, lambda x, y: white, lambda x, y: black)
        (folder / "src" / f"{k + 1:05d}.png").write_bytes(png_bytes(film, film, 3, picture))
        (folder / "mask" / f"{k + 1:05d}.png").write_bytes(png_bytes(film, film, 1, mask))
    for j in range(frames):
        at = (side * (0.35 + 0.3 * j / max(1, frames - 1)), side / 2, side / 4)
        mask = disc(side, side, *at, lambda x, y: white, lambda x, y: black)
        (folder / "target" / f"{j + 1:05d}.png").write_bytes(png_bytes(side, side, 1, mask))


def make_large_targets(folder, side, frames):
    """Replaces folder/target by discs that nearly fill frames of so many px a side, and grow."""
    for j in range(frames):
        radius = side * (0.4 + 0.05 * j / frames)
        rows = []
        for y in range(side):
            reach = radius**2 - (y - side / 2) ** 2
            half = int(reach**0.5) if reach > 0 else 0
            outside = bytes(side // 2 - half)
            rows.append(outside + b"\xff" * (side - 2 * len(outside)) + outside if half else bytes(side))
        (folder / "target" / f"{j + 1:05d}.png").write_bytes(png_bytes(side, side, 1, rows))


def options(folder, out):
    """Of a run in `folder` that paints into `out`, in the order of the command line."""
    folder = pathlib.Path(folder)
    return [
        "--src-path", f"{folder}/src/%05d.png",
        "--src-mask-path", f"{folder}/mask/%05d.png",
        "--target-path", f"{folder}/target/%05d.png",
        "--out-path", f"{out}/%05d.png",
        "--blur-sigma", "1", "--time-blur-sigma", "1", "--border-width", "3",
        "--prev-modulation-bounds", "6,1",
    ]
