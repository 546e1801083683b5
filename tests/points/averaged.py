"""Columns p1_corrected, vpl and vpl_slope of room.csv, derived without any of this repository's code.

    python3 averaged.py < room.csv        prints room.csv with these columns computed again

A texel of M×M on a face is one disc (or point): the radiance is the mean over the 6·256² rays of the
capture weighted by exact solid angle; z, the depth along the face's axis, is the harmonic mean over the
rays, so that the middle of a texel that sees one wall lies on that wall; the normal is the mean of the
walls' normals, each by solid angle over max(cos, 1/4).
"""
import csv
import math
import sys

RADIANCE = [(1.0, 0.2), (0.5, 0.8), (0.3, 0.6)]  # of the walls at +1 and −1 on each axis
ORIGIN = (0.2, -0.1, 0.3)
CAPTURE = 256


def face_vector(face, a, b):
    """(a, b) on a face of the cube of edge 2; the order on the face does not matter to a sum."""
    axis, sign = divmod(face, 2)
    v = [0.0, 0.0, 0.0]
    v[axis] = 1.0 if sign == 0 else -1.0
    v[(axis + 1) % 3] = a
    v[(axis + 2) % 3] = b
    return v


def solid_angle(a0, a1, b0, b1):
    def corner(a, b):
        return math.atan2(a * b, math.sqrt(a * a + b * b + 1.0))

    return corner(a1, b1) - corner(a0, b1) - corner(a1, b0) + corner(a0, b0)


def wall(v):
    """Nearest wall along v: how many v away, its axis, its side and its radiance."""
    best = (math.inf, 0, 0, 0.0)
    for axis in range(3):
        if v[axis] != 0.0:
            side = 0 if v[axis] > 0.0 else 1
            k = ((1.0, -1.0)[side] - ORIGIN[axis]) / v[axis]
            if k <= best[0]:
                best = (k, axis, side, RADIANCE[axis][side])
    return best


def texels(m):
    """(place, normal, A/(1 − Δω/π), A, radiance) of each texel, relative to the origin, face by face, column by
    column."""
    step = CAPTURE // m
    edge = [2.0 * i / CAPTURE - 1.0 for i in range(CAPTURE + 1)]
    middle = [(2 * i + 1) / CAPTURE - 1.0 for i in range(CAPTURE)]
    found = []
    for face in range(6):
        for column in range(m):
            for row in range(m):
                light = total = reciprocals = 0.0
                normal = [0.0, 0.0, 0.0]
                for i in range(column * step, (column + 1) * step):
                    for j in range(row * step, (row + 1) * step):
                        v = face_vector(face, middle[i], middle[j])
                        depth, axis, side, radiance = wall(v)
                        omega = solid_angle(edge[i], edge[i + 1], edge[j], edge[j + 1])
                        cos = abs(v[axis]) / math.sqrt(sum(c * c for c in v))
                        light += omega * radiance
                        total += omega
                        reciprocals += 1.0 / depth
                        normal[axis] += (-1.0, 1.0)[side] * omega / max(cos, 0.25)
                length = math.sqrt(sum(c * c for c in normal))
                normal = [c / length for c in normal]
                v = face_vector(face, (2 * column + 1) / m - 1.0, (2 * row + 1) / m - 1.0)
                depth = step * step / reciprocals
                place = [c * depth for c in v]
                distance = math.sqrt(sum(c * c for c in place))
                cos = -sum(a * b for a, b in zip(normal, place)) / distance
                omega = solid_angle(
                    2.0 * column / m - 1.0, 2.0 * (column + 1) / m - 1.0,
                    2.0 * row / m - 1.0, 2.0 * (row + 1) / m - 1.0,
                )
                area = distance * distance * omega / cos
                found.append((place, normal, area / (1.0 - omega / math.pi), area, light / total))
    return found


def irradiance(lights, x, n):
    """Discs and points: Σ L·A·c·(n·I)⁺/(r² + A·c/π), and the same with r² alone; and what moving a point by a metre
    changes of the latter at most: each cosine turns by 1/r, and the square by 2/r."""
    x = [a - o for a, o in zip(x, ORIGIN)]
    discs = points = slope = 0.0
    for place, normal, disc, point, radiance in lights:
        to = [p - a for p, a in zip(place, x)]
        r2 = sum(c * c for c in to)
        if r2 == 0.0:
            continue
        r = math.sqrt(r2)
        cos_x = max(sum(a * b for a, b in zip(n, to)) / r, 0.0)
        cos_y = max(-sum(a * b for a, b in zip(normal, to)) / r, 0.0)
        discs += radiance * cos_x * disc * cos_y / (r2 + disc * cos_y / math.pi)
        points += radiance * cos_x * point * cos_y / r2
        slope += radiance * 4.0 * point / (r * r2)
    return discs, points, slope


def main():
    reader = csv.DictReader(sys.stdin)
    lights = {m: texels(m) for m in (2, 4, 8, 16)}
    slopes = [f"vpl_slope_M{m}" for m in lights]
    columns = [c for c in reader.fieldnames if c not in slopes] + slopes
    writer = csv.DictWriter(sys.stdout, columns, lineterminator="\n")
    writer.writeheader()
    for row in reader:
        x = [float(row[c]) for c in ("x", "y", "z")]
        n = [float(row[c]) for c in ("nx", "ny", "nz")]
        length = math.sqrt(sum(c * c for c in n))
        n = [c / length for c in n]
        for m, found in lights.items():
            discs, points, slope = irradiance(found, x, n)
            row[f"p1_corrected_M{m}"] = f"{discs:.9g}"
            row[f"vpl_M{m}"] = f"{points:.9g}"
            row[f"vpl_slope_M{m}"] = f"{slope:.3g}"
        writer.writerow(row)


main()
