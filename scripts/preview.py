#!/usr/bin/python3
"""Makes an animated GIF of painted frames over a background, and an MP4 where ffmpeg is installed.

    preview.py FRAMES_DIR OUT_STEM [BACKGROUND]

FRAMES_DIR holds numbered PNG files of one size. BACKGROUND is a colour (#F4F1E8) or a picture, such as
the bare surface of the film; a picture is stretched to the frames' size.
"""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys

from PIL import Image, ImageColor

FRAMES_PER_SECOND = 12
GIF_LONGEST_SIDE_PX = 480
PALETTE_FRAMES = 8


def fail(message):
    sys.exit(f"preview.py: {message}")


def frames(folder):
    """PNG files of a folder in the order of their numbers; at least one."""
    found = [p for p in pathlib.Path(folder).glob("*.png") if not p.name.startswith(".")]
    if not found:
        fail(f"{folder}: no PNG files")
    return sorted(found, key=lambda p: ([int(n) for n in re.findall(r"\d+", p.name)], p.name))


def background(text, size):
    """A colour or a picture file as a picture of that size."""
    if pathlib.Path(text).is_file():
        return Image.open(text).convert("RGBA").resize(size, Image.LANCZOS)
    try:
        return Image.new("RGBA", size, ImageColor.getrgb(re.sub("^0x", "#", text)))
    except ValueError:
        fail(f"{text}: neither a picture nor a colour; wanted one such as #F4F1E8")


def composited(files, base):
    """Yields the frames over the base, without alpha."""
    for file in files:
        frame = Image.open(file).convert("RGBA")
        if frame.size != base.size:
            fail(f"{file}: {frame.width}x{frame.height}, but {files[0]} is {base.width}x{base.height}")
        yield Image.alpha_composite(base, frame).convert("RGB")


def write_gif(pictures, path):
    """One palette for all frames, taken from some of them: a palette a frame would flicker."""
    small = []
    for picture in pictures:
        picture.thumbnail((GIF_LONGEST_SIDE_PX, GIF_LONGEST_SIDE_PX), Image.LANCZOS)
        small.append(picture)
    chosen = small[::max(1, len(small) // PALETTE_FRAMES)]
    width, height = small[0].size
    strip = Image.new("RGB", (width, height * len(chosen)))
    for i, picture in enumerate(chosen):
        strip.paste(picture, (0, i * height))
    palette = strip.quantize(256)
    first, *others = [picture.quantize(palette=palette) for picture in small]
    first.save(path, save_all=True, append_images=others, loop=0,
               duration=round(1000 / FRAMES_PER_SECOND))


def write_mp4(pictures, size, path):
    command = ["ffmpeg", "-v", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24",
               "-s", f"{size[0]}x{size[1]}", "-r", str(FRAMES_PER_SECOND), "-i", "-",
               "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "file:" + path]
    try:
        with subprocess.Popen(command, stdin=subprocess.PIPE) as encoder:
            for picture in pictures:
                encoder.stdin.write(picture.tobytes())
    except BrokenPipeError:
        pass  # its exit code says more
    if encoder.returncode != 0:
        fail(f"{path}: ffmpeg failed; the lines above say why")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("frames")
    parser.add_argument("out")
    parser.add_argument("background", nargs="?", default="#F4F1E8")
    arguments = parser.parse_args()

    files = frames(arguments.frames)
    base = background(arguments.background, Image.open(files[0]).size)
    pathlib.Path(arguments.out).parent.mkdir(parents=True, exist_ok=True)
    gif, mp4 = arguments.out + ".gif", arguments.out + ".mp4"
    write_gif(composited(files, base), gif)
    print(gif)
    if shutil.which("ffmpeg"):
        write_mp4(composited(files, base), base.size, mp4)
        print(mp4)
    else:
        print("(an MP4 too, once ffmpeg is installed: apt-get install ffmpeg)")


if __name__ == "__main__":
    try:
        main()
    except OSError as error:
        fail(error)
