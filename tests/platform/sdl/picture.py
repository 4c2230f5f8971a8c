"""What is in a picture of platform/sdl: its size, and how much of it has the colours of newts, which are teal, red and
purple, in the left third, the middle and the right. Fails below a share in any of the three.

usage: picture.py PICTURE.bmp WIDTHxHEIGHT PER_CENT PER_CENT PER_CENT"""
import colorsys
import pathlib
import struct
import sys

name, size, *least = sys.argv[1:]
data = pathlib.Path(name).read_bytes()
first, = struct.unpack_from("<I", data, 10)
width, height = struct.unpack_from("<ii", data, 18)
bytes_a_pixel = struct.unpack_from("<H", data, 28)[0] // 8
if f"{width}x{abs(height)}" != size:
    sys.exit(f"{name}: {width}x{abs(height)}, not {size}")
stride = -(-width * bytes_a_pixel // 4) * 4
newts = [0, 0, 0]
for y in range(abs(height)):
    for x in range(width):
        b, g, r = data[first + y * stride + x * bytes_a_pixel:][:3]
        hue, saturation, _ = colorsys.rgb_to_hsv(r / 255, g / 255, b / 255)
        newts[3 * x // width] += saturation > 0.3 and not 0.03 < hue < 0.40
shares = [300 * n / (width * abs(height)) for n in newts]
print(f"{name}: newts cover {shares[0]:.1f} %, {shares[1]:.1f} % and {shares[2]:.1f} % of its thirds")
if any(share < float(wanted) for share, wanted in zip(shares, least)):
    sys.exit(f"{name}: at least {', '.join(least)} % are wanted")
